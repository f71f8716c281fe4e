#pragma once

#include "contacts/contact.h"
#include "impulse/shape.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Makes the manifold of two shapes of fixed types, the first of which comes no later in ShapeType; of two of one type,
/// the first is the one that in_order() names.
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

/// Shapes without an inside on the side of both, which never meet: half-spaces and segments among themselves.
Collider never;

/// The part of circle_segment and hull_segment for segments of a chain; the segment comes first.
Collider chain_circle;
Collider chain_hull;

}  // namespace impulse::inline IMPULSE_PRECISION
