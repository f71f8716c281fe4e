#pragma once

#include <cstddef>

#include "scenarios/scene/scene.h"

namespace plumb {

/// The scene without the bodies begin ... end - 1, their joints and forces.
Scene without_bodies(const Scene&, std::size_t begin, std::size_t end);

}  // namespace plumb
