#pragma once

#include "impulse/shape.h"

namespace impulse::inline IMPULSE_PRECISION {

/// How far two shapes are apart, world frame.
struct Gap {
  Real distance = 0;  // m; 0 where they touch or overlap, and then nothing else is known
  Vec2 a, b;          // the nearest points of the two surfaces
  Vec2 normal;        // unit, from a to b; precise even where the distance is tiny, for it comes from the cores
};

/// Exact, for every two shapes; two half-spaces count as meeting somewhere. A chain's segment has two sides here.
Gap distance(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b);

}  // namespace impulse::inline IMPULSE_PRECISION
