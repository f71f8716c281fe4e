#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace plumb {

/// The value that a JSON text (RFC 8259, UTF-8) holds. Throws std::invalid_argument for what is no JSON, with line and
/// column; and, with the path to it, for a key given twice, a number beyond double precision and nesting deeper than
/// any format of ours goes.
nlohmann::json parse_json(std::string_view text, std::string_view file);

/// Text as a message may show it: no longer than `most` bytes, control characters and broken UTF-8 as '?'.
std::string printable(std::string_view text, std::size_t most = 60);

}  // namespace plumb
