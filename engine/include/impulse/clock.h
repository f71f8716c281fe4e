#pragma once

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Turns irregular frame times into equal steps ("Fix your timestep"): real time is stored and spent in slices of dt.
/// Reads no clock itself: the same frame times give the same steps.
class FrameClock {
 public:
  /// `longest` caps the stored time (s), so that a slow frame cannot demand ever more steps (the "spiral of death").
  /// Throws std::invalid_argument unless 0 < dt <= longest <= 1e6 dt, both finite.
  explicit FrameClock(double dt, double longest = 0.2);

  /// Adds a frame's duration (s; negative or NaN counts as 0) and returns how many steps are due now.
  int advance(double frame_time);

  /// How far the present moment lies between the last two steps, 0 ... 1: draw blend(previous, current, alpha()).
  double alpha() const;
  double dt() const { return dt_; }

 private:
  double dt_;
  double longest_;
  double stored_ = 0;
};

/// previous at alpha = 0, current at alpha = 1. (The article prints it the other way round, which runs backwards.)
constexpr Vec2 blend(Vec2 previous, Vec2 current, double alpha) {
  const Real a = static_cast<Real>(alpha);
  return previous * (1 - a) + current * a;
}
constexpr Real blend(Real previous, Real current, double alpha) {
  const Real a = static_cast<Real>(alpha);
  return previous * (1 - a) + current * a;
}

}  // namespace impulse::inline IMPULSE_PRECISION
