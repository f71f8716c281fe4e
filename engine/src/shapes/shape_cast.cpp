#include "shapes/shape_cast.h"

#include <limits>

#include "shapes/distance.h"

namespace impulse::inline IMPULSE_PRECISION {

// Newton's method on the distance, which is a convex function of the way: a step never passes the first contact (the
// conservative advancement of B. Mirtich, Impulse-based Dynamic Simulation, 1996, 2.3). Where shapes only graze each
// other, a step halves the rest of the way, so that 64 are enough for any precision.
std::optional<RayHit> shape_cast(const Shape& moving, const Pose& start, Vec2 by, const Shape& other,
                                 const Pose& pose) {
  if (other.in_chain() && dot(by, pose.q * other.normal(0)) >= 0) return std::nullopt;
  constexpr int most_steps = 64;
  // A gap that rounding cannot close: at contact, distance() knows no normal.
  const Real size = length(start.p) + length(by) + length(pose.p) + moving.extent();
  const Real gap_left = 16 * std::numeric_limits<Real>::epsilon() * size;
  RayHit hit{0, start.p, {}};
  for (int i = 0; i < most_steps; ++i) {
    const Gap gap = distance(moving, {start.p + hit.fraction * by, start.q}, other, pose);
    if (gap.distance == 0) return hit;
    hit.point = gap.b;
    hit.normal = -gap.normal;
    const Real closing = dot(by, gap.normal);  // m
    if (closing <= 0) return std::nullopt;
    if (gap.distance <= 2 * gap_left) return hit;
    hit.fraction += (gap.distance - gap_left) / closing;
    if (hit.fraction > 1) return std::nullopt;
  }
  return hit;
}

}  // namespace impulse::inline IMPULSE_PRECISION
