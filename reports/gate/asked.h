#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "reports/gate/baseline.h"
#include "reports/run/experiment.h"
#include "reports/system/jobs.h"

namespace plumb {

/// What `check` and `accept` have in common: which runs, and which baseline.
struct GateAsked {
  std::vector<std::string> scenarios;
  std::vector<std::string> engines;
  bool all = false;
  std::string baseline;  // file; "" for the one of the set
  int jobs = default_jobs();

  void attach_to(CLI::App&);

  /// The file given, else that of the set in $PLUMB_BASELINES, which ./plumb sets, or in reports/baselines.
  std::string file() const;
};

/// Every engine of a baseline but the closed forms, as --engine takes it.
std::vector<std::string> engines_of(const Baseline&);

/// The runs of a baseline, or those of them that are chosen. Throws std::invalid_argument for a scenario or an engine
/// that is unknown, is asked for twice, or is not in the baseline.
Plan plan_of(const Baseline&, const GateAsked&);

/// Of a baseline what a choice leaves: everything, where nothing is chosen.
Baseline chosen(const Baseline&, const GateAsked&, const Plan&);

/// Carries it out, with environment and without timings, and shows how far it is.
Report carried_out(const Plan&);

}  // namespace plumb
