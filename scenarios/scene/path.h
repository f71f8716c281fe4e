#pragma once

#include "scenarios/scene/scene.h"

namespace plumb {

/// m, how far its path has taken a body after t seconds; its velocity's straight way is not included.
Vec path_offset(const Path&, double t);

/// m/s, of a body at the start, its path included.
Vec start_velocity(const Body&);

/// Whether the body is kinematic and ever moves.
bool is_carried(const Body&);

/// Whether any body has a path.
bool has_paths(const Scene&);

}  // namespace plumb
