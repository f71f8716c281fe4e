#pragma once

#include <cmath>

#include "bodies/body_set.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The gap up to which two shapes make a speculative contact, so that a solver sees what it is about to hit.
struct Margin {
  Real distance = 0;  // m
  Real time = 0;      // s; adds the distance by which the two may approach in this time at their present velocities
};

/// m/s, the greatest speed at which rotation moves a point of the body's surface.
inline Real rim_speed(const BodySet& bodies, std::size_t i) {
  return std::abs(bodies.velocity[i].w) * bodies.bounding_radius[i];
}

/// m, the greatest displacement of a point of the body within the margin's time.
inline Real travel(const BodySet& bodies, std::size_t i, const Margin& margin) {
  return margin.time * (length(bodies.velocity[i].v) + rim_speed(bodies, i));
}

/// m, the gap up to which these two bodies make a contact. Bodies that move together do not approach each other,
/// however fast they are.
inline Real speculative_gap(const BodySet& bodies, std::size_t a, std::size_t b, const Margin& margin) {
  if (margin.time == 0) return margin.distance;
  const Real turning = rim_speed(bodies, a) + rim_speed(bodies, b);
  return margin.distance + margin.time * (length(bodies.velocity[b].v - bodies.velocity[a].v) + turning);
}

}  // namespace impulse::inline IMPULSE_PRECISION
