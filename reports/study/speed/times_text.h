#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace plumb {

/// The result of the speed study for the console: who is the fastest to an error, in a sentence, then a table of the
/// times, of the columns that fit. `timings`: as work_precision_of returns them; width: columns.
std::string times_text(const nlohmann::ordered_json& timings, std::size_t width);

}  // namespace plumb
