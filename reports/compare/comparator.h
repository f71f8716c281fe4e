#pragma once

#include <span>
#include <vector>

#include "reports/judge/observe.h"
#include "reports/report.h"

namespace plumb {

/// Compares the runs of one case: every engine with the closed form, and every two engines. Differences are taken at
/// the moments of a, up to the end of the shorter run; differences of rest metrics are a's minus b's. `truth` gives the
/// scales of relative differences and may be null.
std::vector<Comparison> compare(std::span<const RunRecord> runs_of_one_case, const Truth* truth);

}  // namespace plumb
