#pragma once

#include <string>

namespace plumb {

/// All families of scenes as a table in Markdown, by group: name, cases, question, and what answers it, with the source
/// where that is a closed form of its own.
std::string family_table();

}  // namespace plumb
