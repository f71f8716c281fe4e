#pragma once

#include <vector>

#include "reports/study/study.h"

namespace plumb {

/// What the points of the speed study come to: measured orders of convergence, fronts of time against error, times at
/// equal error and errors at equal time, and each method's factor of time against Box2D.
Findings speed_findings(const std::vector<PointResult>&);

}  // namespace plumb
