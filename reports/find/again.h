#pragma once

#include <string>
#include <vector>

namespace plumb {

struct AgainOptions {
  std::vector<std::string> engines = {};  // empty: the one that each scene was found in, ours if it does not say
  std::string out;
  int parallel = 1;       // scenes at the same time
  double run_limit = 10;  // s of a processor
};

/// Runs every scene file of a folder again, but for images: a corpus of what once failed, judged as when it was found,
/// and by what a file states. Writes again.md and again.xml
/// (JUnit) into `out` and prints a table, in which a scene whose engine is not installed is not run. Returns 1 if any
/// is wrong, else 0. Throws std::invalid_argument for a folder without scenes, a file that is not one, and unknown
/// engines of the options.
int run_again(const std::string& folder, const AgainOptions&);

}  // namespace plumb
