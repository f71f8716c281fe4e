#pragma once

#include "body_set.h"
#include "joint_set.h"

namespace impulse::inline IMPULSE_PRECISION {

/// How far a body has come since the start of the step. Small numbers, so that float keeps them to the last place.
struct Motion {
  Vec2 d;         // m
  Real turn = 0;  // rad
  Real sine = 0;  // of turn
  Real drop = 0;  // cos(turn) - 1

  void turn_by(Real angle) {
    if (angle == 0) return;
    turn += angle;
    // cos - 1 = -2 sin^2(half): no cancellation for small turns.
    const SinCos half = sin_cos(turn / 2);
    sine = 2 * half.sin * half.cos;
    drop = -2 * half.sin * half.sin;
  }
  void advance(const Velocity& velocity, Real h) {
    d += h * velocity.v;
    turn_by(h * velocity.w);
  }
  Pose from(const Pose& start) const { return {start.p + d, Rotation(1 + drop, sine) * start.q}; }
};

}  // namespace impulse::inline IMPULSE_PRECISION
