#pragma once

#include <nlohmann/json.hpp>

#include "reports/report.h"

namespace plumb {

/// The report as report.schema.json describes it: everything that hangs on the clock is under "timings". Numbers are
/// written so that they read back to the same bits; what is not finite is null.
nlohmann::ordered_json to_json(const Report&);

}  // namespace plumb
