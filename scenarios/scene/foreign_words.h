#pragma once

#include <string>
#include <string_view>

namespace plumb {

/// Why a scene file has no such word of another engine's format, and what to write instead: "motors are not in the
/// format", for example. "" for any other word. Case, - and _ don't count.
std::string foreign_word(std::string_view word);

}  // namespace plumb
