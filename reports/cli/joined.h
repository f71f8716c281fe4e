#pragma once

#include <span>
#include <string>

#include "reference/simulation.h"

namespace plumb {

/// Whether what joined the catalog of engines can be asked at all. `all` is sorted by name, as the catalog is. Throws
/// std::invalid_argument, naming the engine and what it lacks: a part of it that is missing, a name that is none or
/// another's.
void check_joined(std::span<const Engine* const> all);

}  // namespace plumb
