#pragma once

#include <map>
#include <span>
#include <string>

#include "reports/judge/scale.h"
#include "reports/judge/states.h"
#include "reports/report.h"

namespace plumb {

/// The row that answers the first questions about two runs that reached their end, from the runs and from what
/// `compare` found: their differences in pose at the moments of a, and the summaries of their other differences over
/// time.
KeyDifferences key_differences(const RunRecord& a, const RunRecord& b, std::span<const PoseDifference> poses,
                               const std::map<std::string, Measured>& differences, const Scales&);

}  // namespace plumb
