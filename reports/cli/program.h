#pragma once

#include <span>
#include <string>
#include <vector>

#include "reference/simulation.h"

namespace plumb {

/// Runs a whole command line, without the program's name. Returns the exit code: 0 fine, 1 the physics failed, 2 bad
/// usage or input, 3 an internal error.
int program(std::vector<std::string> arguments);

/// Throws std::invalid_argument, naming the engine and the defect, if an engine of the catalog is incomplete or has no
/// valid name of its own. `all` is sorted by name.
void check_engines(std::span<const Engine* const> all);

}  // namespace plumb
