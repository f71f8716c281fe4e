#pragma once

#include <string>
#include <vector>

namespace plumb {

/// Runs every scene file of a folder again, a corpus of what once failed: by the engines of `words`, or if they were
/// not `chosen`, by the one that each scene was found in (ours, if it does not say). Writes again.md and again.xml
/// (JUnit) into `out` and prints a table. Returns 1 if any is wrong, else 0. Throws std::invalid_argument for a folder
/// without scenes, or a file that is not one.
int run_again(const std::string& folder, const std::vector<std::string>& words, bool chosen, const std::string& out,
              double run_limit);

}  // namespace plumb
