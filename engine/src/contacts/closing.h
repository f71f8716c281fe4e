#pragma once

#include <cmath>

#include "bodies/body_set.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

/// m/s, the fastest that turning moves a point of the body's surface.
inline Real rim_speed(const BodySet& bodies, std::size_t i) { return std::abs(bodies.velocity[i].w) * bodies.bounding_radius[i]; }

/// m, the farthest that a body's surface can go in the margin's time.
inline Real travel(const BodySet& bodies, std::size_t i, const Margin& margin) {
  return margin.time * (length(bodies.velocity[i].v) + rim_speed(bodies, i));
}

/// m, the gap within which two bodies make a contact. Two that move together close no distance, however fast they are.
inline Real closing(const BodySet& bodies, std::size_t a, std::size_t b, const Margin& margin) {
  if (margin.time == 0) return margin.distance;
  const Real turning = rim_speed(bodies, a) + rim_speed(bodies, b);
  return margin.distance + margin.time * (length(bodies.velocity[b].v - bodies.velocity[a].v) + turning);
}

}  // namespace impulse::inline IMPULSE_PRECISION
