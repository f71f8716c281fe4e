#pragma once

#include "contacts/contact.h"
#include "impulse/shape.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The article's jump table: finds the manifold of any two shapes, world frame. Points whose separation exceeds
/// `margin` (m, >= 0) are left out. Swapping a and b turns the normal around exactly and keeps everything else.
Manifold collide(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin);

}  // namespace impulse::inline IMPULSE_PRECISION
