#pragma once

#include <span>
#include <string>
#include <string_view>

namespace plumb {

/// The name closest to `word` by Levenshtein distance, ignoring case. The first one if several are equally close; ""
/// if there are no names.
std::string nearest(std::string_view word, std::span<const std::string> names);

/// The message for an unknown name: `unknown parameter "hieght", did you mean "height"?`. Where no name resembles the
/// word, it lists them, if they are few.
std::string unknown(std::string_view kind, std::string_view word, std::span<const std::string> names);

}  // namespace plumb
