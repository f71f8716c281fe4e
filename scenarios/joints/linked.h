#pragma once

#include <span>

#include "scenarios/scene/scene.h"

namespace plumb {

/// Adds to the scene a fixed body "hook" at the first point and capsules "link 1", "link 2" ... from each point to the
/// next, hinged at every point but the last. They collide with nothing.
void add_links(Scene&, std::span<const Vec> points, double thickness);

}  // namespace plumb
