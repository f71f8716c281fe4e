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
  ///
  /// Damping is -d v at the velocity after `implicit` seconds: v' = v + h (a - d v') is v' = v + h (a - d v)/(1 + h d),
  /// which no damping makes unstable, and whose speed of fall in air, a/d, is exact; but it is of first order in h, so
  /// a method of higher order passes 0 and gets -d v itself.
  void accelerations(const BodySet& bodies, Real implicit, std::vector<Velocity>& out) const;
};

}  // namespace impulse::inline IMPULSE_PRECISION
