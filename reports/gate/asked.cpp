#include "reports/gate/asked.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <stdexcept>
#include <utility>

#include "reports/study/asked_cases.h"
#include "reports/system/environment.h"
#include "reports/system/progress_line.h"

namespace plumb {
namespace {

bool in_plan(const RunKey& key, const KeptRun& run, const Plan& plan) {
  const bool asked = std::any_of(plan.cases.begin(), plan.cases.end(), [&](const Case& one) {
    return one.scenario->name == key.scenario && one.variant == key.variant;
  });
  const bool entered = run.exact || std::any_of(plan.configs.begin(), plan.configs.end(), [&](const EngineConfig& one) {
                         return one.engine->name == key.engine && one.method() == key.method;
                       });
  return asked && entered;
}

constexpr const char* cure = "is not in the baseline; plumb accept makes one that has it";

void must_know_cases(const Baseline& baseline, const Plan& plan) {
  for (const Case& one : plan.cases) {
    const bool known = std::any_of(baseline.runs.begin(), baseline.runs.end(), [&](const auto& kept) {
      return kept.first.scenario == one.scenario->name && kept.first.variant == one.variant;
    });
    if (known) continue;
    throw std::invalid_argument(fmt::format("{}:{} {}", one.scenario->name, one.variant, cure));
  }
}

void must_know_engines(const Baseline& baseline, const Plan& plan) {
  const std::vector<std::string> known = engines_of(baseline);
  for (const EngineConfig& one : plan.configs) {
    const std::string label = label_of(one.engine->name, one.method());
    if (std::find(known.begin(), known.end(), label) == known.end()) {
      throw std::invalid_argument(fmt::format("{} {}", label, cure));
    }
  }
}

}  // namespace

void GateAsked::attach_to(CLI::App& app) {
  app.add_option("scenario", scenarios, "NAME, NAME:LABEL, NAME:parameter=value,... or FILE.json")->type_name("NAME");
  app.add_flag("--all", all, "The baseline of every scenario, not only of the canonical ones");
  app.add_option("--engine", engines, "NAME[:key=value,...]; may be repeated. Default: those of the baseline")
      ->allow_extra_args(false)
      ->type_name("ENGINE");
  app.add_option("--baseline", baseline,
                 "Default: canonical.json (all.json with --all) in $PLUMB_BASELINES, or else in reports/baselines")
      ->type_name("FILE");
  app.add_option("--jobs", jobs, "Scenes run at once; the results are the same for any number")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
}

std::string GateAsked::file() const {
  if (!baseline.empty()) return baseline;
  const char* folder = std::getenv("PLUMB_BASELINES");
  return (folder == nullptr || *folder == '\0' ? std::string("reports/baselines") : std::string(folder)) +
         (all ? "/all.json" : "/canonical.json");
}

std::vector<std::string> engines_of(const Baseline& baseline) {
  std::set<std::string> labels;
  for (const auto& [key, run] : baseline.runs) {
    if (!run.exact) labels.insert(label_of(key.engine, key.method));
  }
  return {labels.begin(), labels.end()};
}

Plan plan_of(const Baseline& baseline, const GateAsked& asked) {
  const bool some = !asked.scenarios.empty();
  Plan plan = plan_asked(some ? asked.scenarios : baseline.words, baseline.all,
                         asked.engines.empty() ? engines_of(baseline) : asked.engines);
  plan.dt = baseline.dt;
  plan.jobs = asked.jobs;
  plan.timed = false;
  if (some) must_know_cases(baseline, plan);
  if (!asked.engines.empty()) must_know_engines(baseline, plan);
  return plan;
}

Baseline chosen(const Baseline& baseline, const GateAsked& asked, const Plan& plan) {
  if (asked.scenarios.empty() && asked.engines.empty()) return baseline;
  Baseline some = baseline;
  std::erase_if(some.runs, [&](const auto& kept) { return !in_plan(kept.first, kept.second, plan); });
  std::erase_if(some.engines, [&](const auto& engine) {
    return std::none_of(plan.configs.begin(), plan.configs.end(),
                        [&](const EngineConfig& one) { return one.engine->name == engine.first; });
  });
  return some;
}

Report carried_out(const Plan& plan) {
  const ProgressLine line;
  Report report = run_experiment(plan, [&](const std::string& what, std::size_t done, std::size_t of) {
    line.show(fmt::format("[{}/{}] {}", done + 1, of, what));
  });
  report.environment = environment();
  return report;
}

}  // namespace plumb
