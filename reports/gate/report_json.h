#pragma once

#include "reports/report.h"
#include "scenarios/scene/json_reader.h"

namespace plumb {

/// What a report.json says of runs, engines and environment; scenes and traces are not in it. Throws
/// std::invalid_argument, naming the place, for what does not fit report.schema.json there.
Report report_from(const JsonReader&);

}  // namespace plumb
