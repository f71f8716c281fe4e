#pragma once

#include "reference/plane.h"

namespace plumb {

/// A ladder, its centre midway, let go at rest between a rough floor and a smooth wall: it stands iff
/// tan(angle) >= 1/(2 mu), else its foot slides out. Holds until its head leaves the wall.
class Ladder {
 public:
  struct Case {
    double half = 0;      // m, from the centre to either end
    double gyration = 0;  // m^2, I/m about the centre
    double angle = 0;     // rad above the level at the start, 0 ... pi/2
    double gravity = 0;   // m/s^2
    double friction = 0;  // of the floor, sticking and sliding
  };
  explicit Ladder(const Case&);

  struct State {
    double angle = 0;  // rad
    double speed = 0;  // rad/s, of the angle: not positive
  };
  State at(double t) const;

  const Case& given() const { return given_; }
  bool stands() const { return stands_; }
  double valid_until() const { return until_; }  // s, when the head leaves the wall

  /// Per mass, N/kg: x the wall's push out of it, y the floor's push up.
  Vec push(const State&) const;

 private:
  double turning(const State&) const;
  State after(const State&, double h) const;

  Case given_;
  bool stands_;
  double until_;
};

}  // namespace plumb
