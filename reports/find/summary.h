#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "reports/study/job.h"

namespace plumb {

/// The findings of a search, each told once, and the ruler by which all engines are measured alike; found/NAME.json for
/// each finding, find.md and find.xml (JUnit).
Findings conclude_search(const nlohmann::ordered_json& configuration, const std::vector<JobResult>&);

}  // namespace plumb
