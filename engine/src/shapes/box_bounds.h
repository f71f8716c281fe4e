#pragma once

#include <cmath>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Of a box with this centre, whose frame is turned so.
inline Aabb box_bounds(Vec2 center, Rotation turn, Vec2 half_extents) {
  const Real c = std::abs(turn.c);
  const Real s = std::abs(turn.s);
  const Vec2 reach{c * half_extents.x + s * half_extents.y, s * half_extents.x + c * half_extents.y};
  return {center - reach, center + reach};
}

}  // namespace impulse::inline IMPULSE_PRECISION
