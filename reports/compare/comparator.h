#pragma once

#include <span>
#include <vector>

#include "reports/report.h"

namespace plumb {

/// What the runs of one case say of each other: every engine against the closed form, and every two engines against
/// each other. Differences are taken at the moments both have recorded; those of rest metrics are a's less b's.
std::vector<Comparison> compare(std::span<const RunRecord> runs_of_one_case);

}  // namespace plumb
