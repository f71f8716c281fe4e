#pragma once

#include <cmath>
#include <numbers>

#include "scenarios/scenario.h"

/// Error terms that expectations allow for, each derived from how the engine states that it steps.
namespace plumb {

/// Round-off after t seconds of stepping with numbers up to `size`. A step rounds a velocity twice and a position
/// twice, by half an epsilon each, and all these errors may have the same sign. `size` includes the effect of the
/// velocity's error on the position: |x| + |v| t.
inline double round_off(const Stepping& s, double t, double size) {
  const double steps = s.h > 0 ? t / s.h : 1;
  return 4 * s.epsilon * (steps + 1) * size;
}

/// m, the position error after t seconds of constant acceleration: drift a t h.
inline double drifted(const Stepping& s, double acceleration, double t) {
  return std::abs(s.drift) * std::abs(acceleration) * t * s.h;
}

/// s, the longest time between a contact and its detection.
inline double lag(const Stepping& s) { return s.impact_lag * s.h; }

/// The fraction of a velocity error that the iterations (projected Gauss-Seidel) leave when k equal bodies in a row
/// collide at once. Each iteration multiplies the error by cos^2(pi/(k+1)), the spectral radius of the chain's matrix
/// [2 -1; -1 2 -1; ...] of k contacts (Young 1971).
inline double unsolved(const Stepping& s, int k) {
  if (s.iterations == 0) return 0;
  const double rate = std::cos(std::numbers::pi / (k + 1));
  return std::pow(rate * rate, s.iterations);
}

}  // namespace plumb
