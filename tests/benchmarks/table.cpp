#include <fmt/format.h>

#include "contest.h"

namespace plumb::benchmarks {
namespace {

constexpr const char* row_format = "  {:<34} {:>8} {:>15} {:>8} {:>6} {:>13} {:>6} {:>6}  {}\n";

// Four digits, of us.
std::string micro(double seconds) {
  const double us = 1e6 * seconds;
  return fmt::format("{:.{}f}", us, us >= 1000 ? 0 : us >= 100 ? 1 : us >= 10 ? 2 : 3);
}

std::string spread(const Quartiles& of, std::string (*text)(double)) { return text(of.low) + " - " + text(of.high); }

std::string times(double speed) { return fmt::format("{:.2f}", speed); }

std::string line(const Contest& contest, const Contest::Row& row) {
  if (!row.finish.no_result.empty()) {
    return fmt::format("  {:<34} no result: {}\n", row.engine, row.finish.no_result);
  }
  const Figures& all = row.figures;
  const Quartiles& main = contest.basis == Basis::cpu ? all.cpu : all.wall;
  const Quartiles& other = contest.basis == Basis::cpu ? all.wall : all.cpu;
  const bool compared = all.speed.median > 0;
  const std::string busy = all.disturbed > 0 ? fmt::format("{} of {}", all.disturbed, contest.rounds) : "";
  const Depth& overlap = row.finish.overlap;
  return fmt::format(row_format, row.engine, micro(main.median), spread(main, micro), micro(other.median),
                     compared ? times(all.speed.median) : "-", compared ? spread(all.speed, times) : "-",
                     fmt::format("{:.2f}", 1e3 * overlap.mean), fmt::format("{:.1f}", 1e3 * overlap.most), busy);
}

}  // namespace

std::string table(const Contest& contest) {
  const bool by_cpu = contest.basis == Basis::cpu;
  std::string text = fmt::format(
      "{}: {}\nsteps {} to {}, {}, {} rounds\n", contest.scene, contest.about, contest.window.from, contest.window.to,
      contest.threads == 1 ? "one thread" : fmt::format("{} threads", contest.threads), contest.rounds);
  text += fmt::format(row_format, "us a step, overlap in mm", by_cpu ? "CPU" : "wall", "quartiles",
                      by_cpu ? "wall" : "CPU", "speed", "quartiles", "mean", "most", "disturbed");
  for (const Contest::Row& row : contest.rows) text += line(contest, row);
  return text;
}

}  // namespace plumb::benchmarks
