#pragma once

#include "impulse/shape.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Whether a comes before b, whatever the order of the call: exactly one of in_order(a, b) and in_order(b, a) holds,
/// unless both shapes and poses are equal. The lower one along a slanted direction comes first, so that shapes at rest
/// on each other don't trade places when they tremble.
inline bool in_order(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b) {
  constexpr Vec2 slanted{static_cast<Real>(0.52573), static_cast<Real>(0.85065)};  // slope of the golden ratio
  // Differences first: they change their sign exactly when the two are swapped.
  const Vec2 between = (pose_b.p - pose_a.p) + (pose_b.q * b.centroid() - pose_a.q * a.centroid());
  const Real rise = dot(slanted, between);
  if (rise != 0) return rise > 0;
  if (between.x != 0) return between.x > 0;
  if (pose_a.q.c != pose_b.q.c) return pose_a.q.c < pose_b.q.c;
  if (pose_a.q.s != pose_b.q.s) return pose_a.q.s < pose_b.q.s;
  if (a.count() != b.count()) return a.count() < b.count();
  if (a.radius() != b.radius()) return a.radius() < b.radius();
  for (int i = 0; i < a.count(); ++i) {
    if (a.vertex(i).x != b.vertex(i).x) return a.vertex(i).x < b.vertex(i).x;
    if (a.vertex(i).y != b.vertex(i).y) return a.vertex(i).y < b.vertex(i).y;
  }
  return true;
}

}  // namespace impulse::inline IMPULSE_PRECISION
