#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "reports/study/stability/map.h"
#include "reports/study/study.h"

namespace plumb {

/// A map in words and numbers: its axes with their values, its metrics, its boundaries and their theories.
nlohmann::ordered_json description_of(const StabilityMap&, int cells);

/// What the rows of maps come to: how they stand to theory, and what each method stands.
Findings stability_findings(const std::vector<const StabilityMap*>&, int cells, const std::vector<PointResult>&);

}  // namespace plumb
