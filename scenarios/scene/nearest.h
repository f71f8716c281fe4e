#pragma once

#include <span>
#include <string>
#include <string_view>

namespace plumb {

/// The name that needs the fewest insertions, deletions and replacements of letters (capitals or not) to become `word`;
/// the first of equals, "" when there are no names.
std::string nearest(std::string_view word, std::span<const std::string> names);

/// The sentence for a name that does not exist: `unknown parameter "hieght", did you mean "height"?`.
std::string unknown(std::string_view kind, std::string_view word, std::span<const std::string> names);

}  // namespace plumb
