#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace plumb {

/// The result of the speed study for the console: who is the fastest to an error, in a sentence, then a table of the
/// times. `timings`: as work_precision_of returns them.
std::string times_text(const nlohmann::ordered_json& timings);

}  // namespace plumb
