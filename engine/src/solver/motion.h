#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "bodies/body_set.h"
#include "contacts/contact_rows.h"
#include "joints/joint_set.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The motion of a body since the start of the step. Small numbers, which float represents precisely.
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

/// Where bodies are at the last time within a sub-step at which that was asked: several contacts of a body ask for the
/// same time.
class FlownMotions {
 public:
  /// Nothing is known of the bodies of these rows, of all bodies in the world.
  template <class Rows>
  void begin(const Rows& rows, std::size_t body_count) {
    flown_.resize(body_count);
    for (const auto& row : rows) {
      forget(row.a);
      forget(row.b);
    }
  }
  void forget(std::uint32_t body) { flown_[body].time = 0; }
  void keep(std::uint32_t body, Real time, const Motion& motion) { flown_[body] = {time, motion}; }
  bool knows(std::uint32_t body, Real time) const { return flown_[body].time == time; }
  const Motion& of(std::uint32_t body) const { return flown_[body].motion; }

 private:
  struct Flown {
    Real time = 0;  // s, since the start of the sub-step; 0: none
    Motion motion;
  };
  std::vector<Flown> flown_;  // of each body
};

inline Rotation rotation(const Motion& by) { return {1 + by.drop, by.sine}; }

/// The separation of a point after these motions of its bodies, exact for rigid motion with a fixed normal:
/// n . (R(turn) r - r) = sine (r x n) + drop (r . n).
inline Real separation(const ContactRow& row, const RowPoint& p, const Motion& a, const Motion& b) {
  return p.separation + dot(row.normal, b.d - a.d) + (b.sine * p.cross_b + b.drop * p.turn_b) -
         (a.sine * p.cross_a + a.drop * p.turn_a);
}

/// Advances a velocity by t seconds of constant acceleration; returns the mean velocity.
inline Velocity flown(Velocity& v, const Velocity& acceleration, Real t) {
  const Velocity mean{v.v + t / 2 * acceleration.v, v.w + t / 2 * acceleration.w};
  v.v += t * acceleration.v;
  v.w += t * acceleration.w;
  return mean;
}

/// Ends a step: adds the motions to the start poses (which may be the bodies' own). Uses only `d` and `turn` of a
/// motion. The rounding error is kept and added in the next step (Kahan 1965), so that in float, too, a body at rest
/// far from the origin stays there.
void place(BodySet& bodies, const std::vector<Pose>& start, const std::vector<Motion>& motion);

}  // namespace impulse::inline IMPULSE_PRECISION
