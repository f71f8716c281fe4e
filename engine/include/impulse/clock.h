#pragma once

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Turns irregular frame times into fixed time steps (G. Fiedler, "Fix Your Timestep!"): accumulates real time and
/// spends it in steps of dt. Reads no clock itself, so the same frame times give the same steps.
class FrameClock {
 public:
  /// `longest` caps the accumulated time (s), so that a slow frame cannot demand ever more steps (the "spiral of
  /// death"). Throws std::invalid_argument unless 0 < dt <= longest <= 1e6 dt, both finite.
  explicit FrameClock(double dt, double longest = 0.2);

  /// Adds a frame's duration (s; negative or NaN counts as 0) and returns how many steps to take now.
  int advance(double frame_time);

  /// The fraction of a step left over, 0 ... 1: draw blend(previous, current, alpha()).
  double alpha() const;
  double dt() const { return dt_; }

 private:
  double dt_;
  double longest_;
  double stored_ = 0;
};

/// Interpolates: previous at alpha = 0, current at alpha = 1. (The article prints the opposite, which runs backwards.)
constexpr Vec2 blend(Vec2 previous, Vec2 current, double alpha) {
  const Real a = static_cast<Real>(alpha);
  return previous * (1 - a) + current * a;
}
constexpr Real blend(Real previous, Real current, double alpha) {
  const Real a = static_cast<Real>(alpha);
  return previous * (1 - a) + current * a;
}

}  // namespace impulse::inline IMPULSE_PRECISION
