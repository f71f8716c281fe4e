#include "results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "reports/timing/google_benchmark.h"
#include "reports/timing/repetitions.h"

namespace plumb::benchmarks {
namespace {

using google_benchmark::Json;

std::vector<double> times_of(std::span<const Elapsed> rounds, TimeBasis basis) {
  std::vector<double> times;
  for (const Elapsed& round : rounds) times.push_back(basis == TimeBasis::cpu ? round.cpu : round.wall);
  return times;
}

Quartiles step_times(std::span<const Elapsed> rounds, int steps, TimeBasis basis) {
  std::vector<double> times = times_of(rounds, basis);
  for (double& time : times) time /= steps;
  return quartiles(std::move(times));
}

constexpr const char* line_format = "  {:<34} {:>8} {:>15} {:>8} {:>6} {:>13} {:>6} {:>6}  {}\n";

// Four digits, in us.
std::string micro(double seconds) {
  const double us = 1e6 * seconds;
  return fmt::format("{:.{}f}", us, us >= 1000 ? 0 : us >= 100 ? 1 : us >= 10 ? 2 : 3);
}

std::string spread(const Quartiles& of, std::string (*text)(double)) { return text(of.low) + " - " + text(of.high); }

std::string factor(double speed) { return fmt::format("{:.2f}", speed); }

std::string line(const BenchmarkResult& result, const EngineResult& one) {
  if (!one.times.no_result.empty()) return fmt::format("  {:<34} no result: {}\n", one.engine, one.times.no_result);
  const TimesSummary& all = one.summary;
  const Quartiles& main = result.basis == TimeBasis::cpu ? all.cpu : all.wall;
  const Quartiles& other = result.basis == TimeBasis::cpu ? all.wall : all.cpu;
  const bool compared = all.speed.median > 0;
  const std::string busy = all.disturbed > 0 ? fmt::format("{} of {}", all.disturbed, result.rounds) : "";
  const OverlapDepth& overlap = one.times.overlap;
  return fmt::format(line_format, one.engine, micro(main.median), spread(main, micro), micro(other.median),
                     compared ? factor(all.speed.median) : "-", compared ? spread(all.speed, factor) : "-",
                     fmt::format("{:.2f}", 1e3 * overlap.mean), fmt::format("{:.1f}", 1e3 * overlap.most), busy);
}

Json entry(const BenchmarkResult& result, const EngineResult& one, const char* type) {
  return google_benchmark::entry(result.scene + "/" + one.engine, type, result.rounds, result.threads,
                                 static_cast<std::size_t>(result.window.steps()));
}

void add_times(Json& to, double wall, double cpu, double speed, const BenchmarkResult& result,
               const EngineResult& one) {
  google_benchmark::add_times(to, wall, cpu);
  if (speed > 0) to["speed_against_" + result.against] = speed;
  to["first_step"] = result.window.from;
  to["mean_overlap"] = one.times.overlap.mean;
  to["deepest_overlap"] = one.times.overlap.most;
}

void add_entries(Json& all, const BenchmarkResult& result, const EngineResult& one) {
  if (!one.times.no_result.empty()) {
    Json failed = entry(result, one, "iteration");
    google_benchmark::add_error(failed, one.times.no_result);
    all.push_back(failed);
    return;
  }
  for (std::size_t i = 0; i < one.times.rounds.size(); ++i) {
    const Elapsed& elapsed = one.times.rounds[i];
    Json round = entry(result, one, "iteration");
    round["repetition_index"] = i;
    add_times(round, elapsed.wall / result.window.steps(), elapsed.cpu / result.window.steps(), 0, result, one);
    round["disturbed"] = disturbed(elapsed) ? 1 : 0;
    all.push_back(round);
  }
  const TimesSummary& summary = one.summary;
  Json median = entry(result, one, "aggregate");
  google_benchmark::name_median(median);
  add_times(median, summary.wall.median, summary.cpu.median, summary.speed.median, result, one);
  median["speed_lower_quartile"] = summary.speed.low;
  median["speed_upper_quartile"] = summary.speed.high;
  median["disturbed"] = summary.disturbed;
  all.push_back(median);
}

}  // namespace

bool disturbed(const Elapsed& round) { return std::abs(round.wall - round.cpu) > 0.1 * round.wall; }

TimesSummary summarize(std::span<const Elapsed> rounds, std::span<const Elapsed> reference, int steps,
                       TimeBasis basis) {
  TimesSummary all{.wall = step_times(rounds, steps, TimeBasis::wall),
                   .cpu = step_times(rounds, steps, TimeBasis::cpu),
                   .disturbed = static_cast<int>(std::count_if(rounds.begin(), rounds.end(), disturbed))};
  if (!rounds.empty() && !reference.empty())
    all.speed = quartiles(ratios(times_of(reference, basis), times_of(rounds, basis)));
  return all;
}

std::string table(const BenchmarkResult& result) {
  const bool by_cpu = result.basis == TimeBasis::cpu;
  std::string text = fmt::format(
      "{}: {}\nsteps {} to {}, {}, {} rounds\n", result.scene, result.about, result.window.from, result.window.to,
      result.threads == 1 ? "one thread" : fmt::format("{} threads", result.threads), result.rounds);
  text += fmt::format(line_format, "us a step, overlap in mm", by_cpu ? "CPU" : "wall", "quartiles",
                      by_cpu ? "wall" : "CPU", "speed", "quartiles", "mean", "most", "disturbed");
  for (const EngineResult& one : result.engines) text += line(result, one);
  return text;
}

std::string google_json(const std::vector<BenchmarkResult>& results) {
  Json benchmarks = Json::array();
  for (const BenchmarkResult& result : results) {
    for (const EngineResult& one : result.engines) add_entries(benchmarks, result, one);
  }
  return google_benchmark::text_of(std::move(benchmarks));
}

}  // namespace plumb::benchmarks
