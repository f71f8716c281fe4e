#pragma once

#include "reports/gate/baseline.h"
#include "reports/run/experiment.h"

/// How far a number may lie off on another platform.
namespace plumb {

/// Finds that out for every number of a baseline that is of this plan: from runs of starts next to it, and from what is
/// stated of rounding. Takes some sixteen times as long as the runs themselves.
void find_bounds(const Plan&, Baseline&, const Progress&);

}  // namespace plumb
