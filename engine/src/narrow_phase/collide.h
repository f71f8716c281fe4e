#pragma once

#include "impulse/shape.h"
#include "narrow_phase/manifolds.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Finds the manifold of any two shapes (the article's jump table), in the world frame. Points whose separation exceeds
/// `margin` (m, >= 0) are left out. Swapping a and b flips the manifold exactly.
Manifold collide(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin);

/// Makes the manifold of two shapes of fixed types, the first of which comes no later in ShapeType; for two of one
/// type, collide() chooses the first.
using Collider = Manifold(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Real margin);

Collider circle_circle;
Collider circle_box;
Collider circle_polygon;
Collider circle_capsule;
Collider circle_segment;
Collider circle_half_space;
Collider box_box;
Collider hull_hull;  // box, polygon, capsule, segment
Collider hull_segment;
Collider hull_half_space;

/// The part of circle_segment and hull_segment for segments of a chain; the segment comes first.
Collider chain_circle;
Collider chain_hull;

}  // namespace impulse::inline IMPULSE_PRECISION
