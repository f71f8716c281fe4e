#pragma once

#include <vector>

#include "body_set.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Everything that accelerates bodies other than contacts and joints: gravity, collected forces, generators, damping.
class ForceField {
 public:
  Vec2 gravity;

  /// Acceleration of every row at the bodies' present poses and velocities: v in m/s^2, w in rad/s^2. Rows with inverse
  /// mass 0 get 0. `out` is resized to the bodies.
  void accelerations(const BodySet& bodies, std::vector<Velocity>& out) const;
};

}  // namespace impulse::inline IMPULSE_PRECISION
