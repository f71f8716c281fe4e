#include "reports/session.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <set>
#include <stdexcept>

#include "reports/cli.h"
#include "reports/environment.h"
#include "reports/experiment.h"
#include "reports/writers/console.h"

namespace plumb {
namespace {

// https://no-color.org: any value but the empty one says no.
bool wants_colour() {
  const char* no = std::getenv("NO_COLOR");
  return (no == nullptr || *no == '\0') && isatty(STDOUT_FILENO) != 0;
}

// One line that is written over and over, on a terminal only, and gone in the end.
class ProgressLine {
 public:
  ~ProgressLine() { clear(); }
  ProgressLine() = default;
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const std::string& what, std::size_t done, std::size_t of) const {
    if (!terminal_) return;
    clear();
    fmt::print(stderr, "[{}/{}] {:.80}", done + 1, of, what);
    std::fflush(stderr);
  }

 private:
  void clear() const {
    if (terminal_) std::fputs("\r\033[K", stderr);
  }
  bool terminal_ = isatty(STDERR_FILENO) != 0;
};

Report carry_out_with_progress(const Plan& plan) {
  const ProgressLine line;
  try {
    return carry_out(plan,
                     [&](const std::string& what, std::size_t done, std::size_t of) { line.show(what, done, of); });
  } catch (const std::invalid_argument& error) {
    // Everything the user said was checked before: this is a mistake of ours.
    throw std::runtime_error(error.what());
  }
}

}  // namespace

void Session::attach_to(CLI::App& app) {
  app.add_flag("--all", all, "Every scenario, not only the canonical ones");
  app.add_option("--engine", engines, "NAME[:key=value,...]; may be repeated. Default: every engine")
      ->allow_extra_args(false)
      ->type_name("ENGINE");
  app.add_option("--dt", dt, "Time step in s, a number or a fraction")->capture_default_str()->type_name("STEP");
  app.add_option("--out", out, "Folder for report.json, report.csv and index.html")
      ->capture_default_str()
      ->type_name("DIR");
}

Session::Result Session::conduct(const std::string& command) const {
  Plan plan{.dt = parse_dt(dt)};
  for (const std::string& word : scenarios) {
    for (Case& one : parse_cases(word)) plan.cases.push_back(std::move(one));
  }
  if (scenarios.empty()) plan.cases = default_cases(all);

  for (const std::string& word : engines) plan.entrants.push_back(parse_entrant(word));
  if (engines.empty()) plan.entrants = default_entrants();
  std::set<std::string> labels;
  for (const Entrant& entrant : plan.entrants) {
    const std::string label = label_of(entrant.contender->name, entrant.method());
    if (!labels.insert(label).second) throw std::invalid_argument("engine \"" + label + "\" is asked for twice");
  }
  const OutputFolder folder(out);

  Result result{.report = carry_out_with_progress(plan)};
  Report& report = result.report;
  report.title = "Plumb: " + command;
  report.command = {"plumb", command};
  report.command.insert(report.command.end(), scenarios.begin(), scenarios.end());
  if (all) report.command.emplace_back("--all");
  for (const std::string& engine : engines) report.command.insert(report.command.end(), {"--engine", engine});
  report.command.insert(report.command.end(), {"--dt", dt});
  report.environment = environment();

  result.written = folder.write(report);
  fmt::print("{}", console_text(report, wants_colour()));
  fmt::print("{:.1f} % of the runs' time was spent outside step.\n", 100 * report.clock.at("outside_step"));
  for (const auto& [file, why] : result.written.skipped) fmt::print("No {}: {}.\n", file, why);
  return result;
}

}  // namespace plumb
