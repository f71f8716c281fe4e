#pragma once

#include <string>
#include <string_view>

namespace plumb {

/// ISO 8601 in UTC, "2026-11-21T09:06:10Z", so that moments are sorted as texts are: of "2026-11-21" (its midnight),
/// or of a date and a time with Z or an offset, "2026-11-21T10:06:10+01:00". Throws std::invalid_argument for what is
/// none of these.
std::string utc(std::string_view text);

}  // namespace plumb
