#include "reports/gate/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <stdexcept>
#include <utility>

#include "reports/run/converged_checks.h"
#include "reports/run/selection.h"
#include "reports/system/command_options.h"
#include "reports/system/environment.h"
#include "reports/system/terminal.h"

namespace plumb {
namespace {

bool in_plan(const RunKey& key, const BaselineRun& run, const Plan& plan) {
  const bool has_case = std::any_of(plan.cases.begin(), plan.cases.end(), [&](const Case& one) {
    return one.scenario->name == key.scenario && one.variant == key.variant;
  });
  const bool has_engine =
      run.exact || std::any_of(plan.configs.begin(), plan.configs.end(), [&](const EngineConfig& one) {
        return one.engine->name == key.engine && one.method() == key.method;
      });
  return has_case && has_engine;
}

// Every engine but the closed forms, with its method.
std::set<std::pair<std::string, std::string>> engines_of(const Baseline& baseline) {
  std::set<std::pair<std::string, std::string>> engines;
  for (const auto& [key, run] : baseline.runs) {
    if (!run.exact) engines.emplace(key.engine, key.method);
  }
  return engines;
}

constexpr const char* remedy = "is not in the baseline; plumb accept makes one that has it";

void check_cases(const Baseline& baseline, const Plan& plan) {
  for (const Case& one : plan.cases) {
    const bool known = std::any_of(baseline.runs.begin(), baseline.runs.end(), [&](const auto& run) {
      return run.first.scenario == one.scenario->name && run.first.variant == one.variant;
    });
    if (known) continue;
    throw std::invalid_argument(fmt::format("{}:{} {}", one.scenario->name, one.variant, remedy));
  }
}

void check_engines(const Baseline& baseline, const Plan& plan) {
  const auto known = engines_of(baseline);
  for (const EngineConfig& one : plan.configs) {
    if (known.contains({one.engine->name, one.method()})) continue;
    throw std::invalid_argument(fmt::format("{} {}", label_of(one.engine->name, one.method()), remedy));
  }
}

}  // namespace

void GateOptions::attach_to(CLI::App& app) {
  CommandOptions add(app);
  add.add("scenario", "NAME", scenarios, "NAME, NAME:LABEL, NAME:parameter=value,... or FILE.json");
  add.flag("--canonical", canonical, "Only the canonical scenarios, in seconds");
  add.excludes("--canonical", "scenario");
  add.retired("--all", "--all is the default now and will go");  // needed until 0.1
  add.add_repeated("--engine", "ENGINE", engines,
                   "NAME[:key=value,...]; may be repeated. Default: those of the baseline");
  add.add("--baseline", "FILE", baseline, "Default: all.json in $PLUMB_BASELINES, or else in reports/baselines");
  add.add("--jobs", "N", jobs, 1, 1024, "Cases run at once; the results are the same for any number");
}

std::string GateOptions::baseline_file() const {
  if (!baseline.empty()) return baseline;
  const char* folder = std::getenv("PLUMB_BASELINES");
  return (folder == nullptr || *folder == '\0' ? std::string("reports/baselines") : std::string(folder)) + "/all.json";
}

std::vector<std::string> engine_words_of(const Baseline& baseline) {
  std::vector<std::string> words;
  for (const auto& [engine, method] : engines_of(baseline)) {
    const auto word = baseline.words.find(engine);
    words.push_back(label_of(word == baseline.words.end() ? engine : word->second, method));
  }
  return words;
}

std::vector<std::string> engines_missing_in(const Baseline& baseline) {
  const auto known = engines_of(baseline);
  std::vector<std::string> missing;
  for (const EngineConfig& one : default_engines()) {
    if (!known.contains({one.engine->name, one.method()})) missing.push_back(label_of(one.engine->name, one.method()));
  }
  return missing;
}

Plan plan_of(const Baseline& baseline, const GateOptions& options) {
  const bool some = options.canonical || !options.scenarios.empty();
  Plan plan = select_plan(some ? options.scenarios : baseline.scenarios, !some && baseline.all,
                          options.engines.empty() ? engine_words_of(baseline) : options.engines);
  plan.dt = baseline.dt;
  plan.jobs = options.jobs;
  plan.refine = usual_budget;
  plan.timed = false;
  if (some) check_cases(baseline, plan);
  if (!options.engines.empty()) check_engines(baseline, plan);
  return plan;
}

Baseline selected(const Baseline& baseline, const GateOptions& options, const Plan& plan) {
  if (options.scenarios.empty() && !options.canonical && options.engines.empty()) return baseline;
  Baseline some = baseline;
  std::erase_if(some.runs, [&](const auto& run) { return !in_plan(run.first, run.second, plan); });
  std::erase_if(some.engines, [&](const auto& engine) {
    return std::none_of(plan.configs.begin(), plan.configs.end(),
                        [&](const EngineConfig& one) { return one.engine->name == engine.first; });
  });
  return some;
}

Report run_plan(const Plan& plan) {
  const ProgressLine line;
  Report report = run_experiment(plan, [&](const std::string& what, std::size_t done, std::size_t of) {
    line.show(fmt::format("[{}/{}] {}", done + 1, of, what));
  });
  report.environment = environment();
  return report;
}

}  // namespace plumb
