#pragma once

#include <string>

#include "reports/gate/result.h"
#include "reports/timing/report.h"

namespace plumb {

/// Adds to what a gate says that `engine` was timed, a run "time CASE" for each case, and which of them take longer
/// than before, so that whoever is told of the rest is told of that, too.
void add_times(GateResult&, const TimingReport&, const std::string& engine);

}  // namespace plumb
