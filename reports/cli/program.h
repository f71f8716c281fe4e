#pragma once

#include <string>
#include <vector>

namespace plumb {

/// The whole command line, without the program's name. Returns the exit code: 0 fine, 1 the physics failed, 2 the user
/// should put something right, 3 a mistake of ours.
int program(std::vector<std::string> arguments);

}  // namespace plumb
