#pragma once

#include <string>
#include <vector>

#include "reports/gate/baseline.h"
#include "reports/run/experiment.h"
#include "reports/system/jobs.h"

namespace CLI {
class App;
}

namespace plumb {

/// The options that `check` and `accept` share: which runs, and which baseline.
struct GateOptions {
  std::vector<std::string> scenarios;
  std::vector<std::string> engines;
  bool canonical = false;  // only the canonical scenarios
  std::string baseline;    // file; "" for the default
  int jobs = default_jobs();

  void attach_to(CLI::App&);

  /// The file given, else all.json in $PLUMB_BASELINES, which ./plumb sets, or in reports/baselines.
  std::string baseline_file() const;
};

/// Every engine of a baseline but the closed forms, as --engine takes it.
std::vector<std::string> engine_words_of(const Baseline&);

/// The engines that would run by default but are not in the baseline, as --engine takes them.
std::vector<std::string> engines_missing_in(const Baseline&);

/// The selected runs of a baseline; all of them if the options select none. Throws std::invalid_argument for a scenario
/// or an engine that is unknown, given twice, or not in the baseline.
Plan plan_of(const Baseline&, const GateOptions&);

/// The part of a baseline that the options select.
Baseline selected(const Baseline&, const GateOptions&, const Plan&);

/// Runs the plan with a progress line and adds the environment to the report.
Report run_plan(const Plan&);

}  // namespace plumb
