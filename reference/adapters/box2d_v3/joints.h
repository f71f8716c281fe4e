#pragma once

#include <box2d/box2d.h>

#include <span>
#include <string>

#include "scenarios/scene/scene.h"

namespace plumb::box2d_v3 {

/// Adds the scene's joints to a world that holds its bodies, given in Scene order and centred (see plumb::centered).
void add_joints(b2WorldId, const Scene&, std::span<const b2BodyId>);

/// Why the stiffness of a soft distance joint cannot be had; "" when it can.
std::string needs_eccentric_spring(const Scene&);

}  // namespace plumb::box2d_v3
