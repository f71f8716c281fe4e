#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

#include "reports/cli/command_line.h"
#include "reports/gate/baseline.h"
#include "reports/gate/bounds.h"
#include "reports/gate/options.h"
#include "reports/gate/result.h"
#include "reports/gate/writers.h"
#include "reports/run/converged_checks.h"
#include "reports/run/selection.h"
#include "reports/system/files.h"
#include "reports/system/terminal.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/json_reader.h"

namespace plumb::commands::accept {
namespace {

struct Accept {
  GateOptions gate;
  std::string dt;
};

// The scenarios and engines of the existing baseline, as far as the user does not name others.
struct Scope {
  bool all = false;
  std::vector<std::string> scenarios;
  Plan plan;
};

Scope scope_of(const Accept& options, const std::optional<Baseline>& before) {
  const GateOptions& gate = options.gate;
  const bool some = gate.canonical || !gate.scenarios.empty();
  if (some && gate.baseline.empty()) {
    throw std::invalid_argument("a baseline of selected scenarios needs its own file: --baseline FILE");
  }
  Scope scope{.all = !some, .scenarios = gate.scenarios};
  if (before && !some) {
    scope.all = before->all;
    scope.scenarios = before->scenarios;
  }
  scope.plan =
      select_plan(scope.scenarios, scope.all, before && gate.engines.empty() ? engine_words_of(*before) : gate.engines);
  if (before) scope.plan.dt = before->dt;
  if (!options.dt.empty()) scope.plan.dt = parse_dt(options.dt);
  scope.plan.jobs = gate.jobs;
  scope.plan.refine = usual_budget;
  scope.plan.timed = false;
  return scope;
}

Baseline present(const Plan& plan) {
  Baseline now = baseline_of(run_plan(plan));
  const ProgressLine line;
  find_bounds(plan, now, [&](const std::string& what, std::size_t done, std::size_t of) {
    line.show(fmt::format("[{}/{}] {}", done + 1, of, what));
  });
  return now;
}

void print_changes(const std::optional<Baseline>& before, const Baseline& now) {
  if (!before) {
    fmt::print("new baseline: {} runs\n", now.runs.size());
  } else if (before->dt != now.dt) {
    fmt::print("other steps: {} s, was {} s\n", now.dt, before->dt);
  } else {
    const GateResult changes = compare(*before, now);
    fmt::print("{}", text_of(changes, changes.regressions.size()));
  }
}

int accept(const Accept& options) {
  const std::string path = options.gate.baseline_file();
  std::optional<Baseline> before;
  if (std::filesystem::exists(path)) before = read_baseline(path);
  const Scope scope = scope_of(options, before);
  NewFile file(path);
  if (!file.write("")) throw std::invalid_argument(path + ": cannot be written; is its folder there?");

  Baseline now = present(scope.plan);
  now.all = scope.all;
  now.scenarios = scope.scenarios;
  file.write_all(to_text(now));
  file.put_in_place();
  print_changes(before, now);
  fmt::print("{}\n", printable(path, path.npos));
  return 0;
}

const Catalog<Command>::Entry entry{
    {.name = "accept",
     .about = "Accept the current results as the baseline of `plumb check`, and show what changes",
     .examples = "  plumb accept                                 every scenario, the engines of the baseline\n"
                 "  plumb accept bounce mine.json --engine impulse --baseline mine-gate.json\n"
                 "  plumb accept --canonical --baseline quick.json    a baseline of the canonical scenarios\n",
     .attach = [](CLI::App& app) {
       const auto options = std::make_shared<Accept>();
       options->gate.attach_to(app);
       app.add_option("--dt", options->dt,
                      "Time step in s, a number or a fraction; default: that of the baseline, or 1/60")
           ->type_name("STEP");
       return [options] { return accept(*options); };
     }}};

}  // namespace
}  // namespace plumb::commands::accept
