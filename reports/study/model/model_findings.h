#pragma once

#include <vector>

#include "reports/study/study.h"

namespace plumb {

/// What the points of the study of models come to, case by case: what each feature is worth in error and in cost, the
/// least model that answers as well, and whether the engine's own choice keeps its promise.
Findings model_findings(const std::vector<PointResult>&);

}  // namespace plumb
