#pragma once

#include <optional>

#include "impulse/shape.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The gap between two shapes, world frame.
struct Gap {
  Real distance = 0;  // m; 0 if they touch or overlap, and then the other members are not set
  Vec2 a, b;          // the nearest points of the two surfaces
  Vec2 normal;        // unit, from a to b; precise even for tiny distances, because it is that of the cores
};

/// Exact for all pairs of shapes. Two half-spaces always count as touching; segments of a chain are two-sided here.
Gap distance(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b);

/// Where `moving`, which starts at a pose and moves by `by` without rotating, first touches `other`: the share of the
/// way, and point and normal of `other`, world frame. The normal is 0 if they overlap at the start. Segments of a chain
/// are hit only from their free side.
std::optional<RayHit> shape_cast(const Shape& moving, const Pose& start, Vec2 by, const Shape& other, const Pose& pose);

}  // namespace impulse::inline IMPULSE_PRECISION
