#pragma once

#include <nlohmann/json_fwd.hpp>

#include "reports/report.h"

namespace plumb {

/// The report as report.schema.json describes it. Everything that depends on the clock is under "timings". Numbers read
/// back to the same bits; values that are not finite are null.
nlohmann::ordered_json to_json(const Report&);

}  // namespace plumb
