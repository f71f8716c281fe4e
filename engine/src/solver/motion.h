#pragma once

#include <vector>

#include "bodies/body_set.h"
#include "contacts/contact_rows.h"
#include "joints/joint_set.h"

namespace impulse::inline IMPULSE_PRECISION {

/// How far a body has come since the start of the step. Small numbers, so that float keeps them to the last place.
struct Motion {
  Vec2 d;         // m
  Real turn = 0;  // rad
  Real sine = 0;  // of turn
  Real drop = 0;  // cos(turn) - 1

  void turn_by(Real angle);
  void advance(const Velocity& velocity, Real h) {
    d += h * velocity.v;
    turn_by(h * velocity.w);
  }
  Pose from(const Pose& start) const { return {start.p + d, Rotation(1 + drop, sine) * start.q}; }
};

/// s of a point whose bodies have come so far, exact for rigid motion against a normal that stands still:
/// n . (R(turn) r - r) = sine (r x n) + drop (r . n).
inline Real separation(const ContactRow& row, const RowPoint& p, const Motion& a, const Motion& b) {
  return p.separation + dot(row.normal, b.d - a.d) + (b.sine * p.cross_b + b.drop * p.turn_b) -
         (a.sine * p.cross_a + a.drop * p.turn_a);
}
/// The same in a frame that leaves out a body that stands still.
template <class Frame>
Real separation(const ContactRow& row, const RowPoint& p, const Motion& a, const Motion& b) {
  Real s = p.separation + dot(row.normal, Frame::difference(a.d, b.d));
  if constexpr (Frame::with_b) s += b.sine * p.cross_b + b.drop * p.turn_b;
  if constexpr (Frame::with_a) s -= a.sine * p.cross_a + a.drop * p.turn_a;
  return s;
}

/// Carries a velocity over t seconds of constant acceleration; returns the mean one.
inline Velocity flown(Velocity& v, const Velocity& acceleration, Real t) {
  const Velocity mean{v.v + t / 2 * acceleration.v, v.w + t / 2 * acceleration.w};
  v.v += t * acceleration.v;
  v.w += t * acceleration.w;
  return mean;
}

/// Ends a step: adds the motions to the poses that the bodies started from (which may be those they have); of a motion
/// only the sums count, sine and drop may be left out. What rounding leaves out is kept and added in the next step
/// (Kahan 1965), so that in float, too, a body at rest far from the origin stays there.
void place(BodySet& bodies, const std::vector<Pose>& start, const std::vector<Motion>& motion);

}  // namespace impulse::inline IMPULSE_PRECISION
