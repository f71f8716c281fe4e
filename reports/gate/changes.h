#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "reports/report.h"

namespace plumb {

/// What a report's runs gave otherwise than an accepted baseline, told like a study for the page: {"study": "baseline",
/// "findings": {"verdict", "notes", "runs", "regressions"}, ...}. Nothing where there is no such file, or it is of
/// another step. Runs that only one of the two has are left out. Throws std::invalid_argument, naming the place, for a
/// file that is damaged.
std::optional<nlohmann::ordered_json> changes_since(const std::string& file, const Report&);

}  // namespace plumb
