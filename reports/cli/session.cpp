#include "reports/cli/session.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "reports/run/converged_checks.h"
#include "reports/run/experiment.h"
#include "reports/run/scene_file.h"
#include "reports/run/selection.h"
#include "reports/system/command_options.h"
#include "reports/system/environment.h"
#include "reports/system/terminal.h"
#include "reports/writers/console.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/json_reader.h"

namespace plumb {
namespace {

// https://no-color.org: any non-empty value turns colour off.
bool wants_colour() {
  const char* no = std::getenv("NO_COLOR");
  return (no == nullptr || *no == '\0') && isatty(STDOUT_FILENO) != 0;
}

Report run_with_progress(const Plan& plan, bool quiet) {
  const ProgressLine line(quiet ? ProgressLine::Kind::quiet : ProgressLine::Kind::usual);
  try {
    return run_experiment(plan, [&](const std::string& what, std::size_t done, std::size_t of) {
      line.show(fmt::format("[{}/{}] {}", done + 1, of, what));
    });
  } catch (const std::invalid_argument& error) {
    // All input was checked before, so this is an internal error.
    throw std::runtime_error(error.what());
  }
}

Plan plan_of(const Session& session) {
  Plan plan = select_plan(session.scenarios, session.all, session.engines);
  plan.dt = parse_dt(session.dt);
  plan.jobs = session.jobs;
  plan.refine = session.refinement();
  plan.timed = !session.no_timings;
  plan.explain = true;
  plan.relations = session.relations;
  plan.ensemble = session.ensemble;
  return plan;
}

}  // namespace

void warn_about_files(std::span<const Case> cases) {
  for (const Case& one : cases) {
    if (one.from_file == nullptr || one.variant == tracker) continue;
    std::vector<std::string> warnings = warnings_about(*one.scene);
    warnings.insert(warnings.end(), one.doubts.begin(), one.doubts.end());
    for (const std::string& warning : warnings)
      fmt::print(stderr, "plumb: warning: {}: {}\n", printable(one.variant, one.variant.npos), warning);
  }
}

void Session::attach_to(CLI::App& app) {
  CommandOptions add(app);
  add.add("scenario", "NAME", scenarios, "NAME, NAME:LABEL, NAME:parameter=value,... or FILE.json");
  add.flag("--all", all, "Every scenario, not only the canonical ones");
  add.flag("--converged", converged,
           "Spend five times as much on the converged references that judge where there is no closed form; a few "
           "seconds a scene");
  add.flag("--no-converged", no_converged, "Judge without converged references");
  add.excludes("--no-converged", "--converged");
  add.flag("--no-timings", no_timings, "Judge without timing steps, which takes most of the time of large scenes");
  add.flag("--relations", relations,
           "Also run images of every scene (shifted, turned, mirrored ...) and check that they move alike");
  add.add(
      "--ensemble", "N", ensemble, 0, 1000,
      "Runs of each engine that are compared beyond a scene's horizon, fewer (at least 6) in large scenes; 0: none");
  add.add_repeated("--engine", "ENGINE", engines, "NAME[:key=value,...]; may be repeated. Default: every engine");
  add.add("--dt", "STEP", dt, "Time step in s, a number or a fraction");
  add.add("--jobs", "N", jobs, 1, 1024, "Scenes that run at the same time; results are the same for any number");
  add.add("--out", "DIR", out, "Folder for index.html, report.md, report.json, report.csv and report.xml (JUnit)");
  add.flag("--verbose", verbose, "Also print how far every two engines are apart, and all failed checks");
  add.flag("--quiet", quiet, "Print nothing: the files and the exit code say it all");
  add.flag("--json", json, "Print report.json instead of tables");
}

std::size_t Session::refinement() const {
  if (no_converged) return 0;
  return converged ? 5 * usual_budget : usual_budget;
}

Report Session::conduct(const std::string& command, const std::function<void(Report&)>& complete) const {
  if (int{verbose} + int{quiet} + int{json} > 1)
    throw std::invalid_argument("--verbose, --quiet and --json exclude each other: choose one");
  const Plan plan = plan_of(*this);
  const OutputFolder folder(out);
  if (!quiet) warn_about_files(plan.cases);

  Report report = run_with_progress(plan, quiet);
  report.title = "Plumb: " + command;
  report.command = {"plumb", command};
  report.command.insert(report.command.end(), scenarios.begin(), scenarios.end());
  if (all) report.command.emplace_back("--all");
  if (converged) report.command.emplace_back("--converged");
  if (no_converged) report.command.emplace_back("--no-converged");
  if (no_timings) report.command.emplace_back("--no-timings");
  if (relations) report.command.emplace_back("--relations");
  if (ensemble != Session().ensemble)
    report.command.insert(report.command.end(), {"--ensemble", std::to_string(ensemble)});
  for (const std::string& engine : engines) report.command.insert(report.command.end(), {"--engine", engine});
  report.command.insert(report.command.end(), {"--dt", dt});
  report.environment = environment();
  complete(report);

  print(report, folder.write(report));
  return report;
}

void Session::print(const Report& report, const OutputFolder::Written& written) const {
  if (quiet) return;
  if (json) {
    std::string why_not;
    fmt::print("{}", Catalog<Writer>::find("json")->text(report, why_not).value());
    return;
  }
  fmt::print("{}", console_text(report, {.colour = wants_colour(), .verbose = verbose, .width = terminal_width(100)}));
  if (verbose)
    fmt::print("{:.1f} % of the runs' time was spent outside step.\n", 100 * report.clock.at("outside_step"));
  for (const auto& file : written.files) fmt::print("{}\n", printable(file.string(), std::string::npos));
  for (const auto& [file, why] : written.skipped) fmt::print("No {}: {}.\n", file, why);
}

}  // namespace plumb
