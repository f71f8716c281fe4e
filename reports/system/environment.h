#pragma once

#include <map>
#include <string>

namespace plumb {

/// What a report was made with: Plumb, compiler, flags, build type, libraries, system, processor. The same from run to
/// run.
std::map<std::string, std::string> environment();

/// Of Plumb, as `plumb --version` says it.
const char* version();

}  // namespace plumb
