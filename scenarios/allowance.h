#pragma once

#include <cmath>
#include <numbers>

#include "scenarios/scenario.h"

/// Parts of what an Expectation allows, each derived from how the engine says it steps.
namespace plumb {

/// After t seconds of stepping with numbers up to `size`: a step rounds a speed twice and a place twice, by half an
/// epsilon each, and every such error may point the same way. `size` counts what the speed's error moves: |x| + |v| t.
inline double round_off(const Stepping& s, double t, double size) {
  const double steps = s.h > 0 ? t / s.h : 1;
  return 4 * s.epsilon * (steps + 1) * size;
}

/// m, by which a place is off after t seconds under a constant acceleration: drift a t h.
inline double drifted(const Stepping& s, double acceleration, double t) {
  return std::abs(s.drift) * std::abs(acceleration) * t * s.h;
}

/// s, between a contact and its being noticed.
inline double lag(const Stepping& s) { return s.impact_lag * s.h; }

/// Share of a speed that sweeps (projected Gauss-Seidel) leave unsolved where k equal bodies in a row are struck
/// together: each sweep takes cos^2(pi/(k+1)) of it, the spectral radius for the chain's matrix [2 -1; -1 2 -1; ...] of
/// k contacts (Young 1971).
inline double unsolved(const Stepping& s, int k) {
  if (s.iterations == 0) return 0;
  const double rate = std::cos(std::numbers::pi / (k + 1));
  return std::pow(rate * rate, s.iterations);
}

}  // namespace plumb
