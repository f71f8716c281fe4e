#pragma once

#include <map>
#include <string>

namespace plumb {

/// What a report was made with: Plumb, compiler, flags, build type, libraries, system, processor. The same in every run
/// on one machine.
std::map<std::string, std::string> environment();

/// Plumb's version, as `plumb --version` prints it.
const char* version();

}  // namespace plumb
