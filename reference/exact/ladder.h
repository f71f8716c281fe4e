#pragma once

#include "scenarios/scene/scene.h"

namespace plumb {

/// A ladder with its centre midway, released at rest between a rough floor and a frictionless wall: it stands iff
/// tan(angle) >= 1/(2 mu), else its foot slides out. Valid until its head leaves the wall.
class Ladder {
 public:
  struct Setup {
    double half = 0;      // m, from the centre to either end
    double gyration = 0;  // m^2, I/m about the centre
    double angle = 0;     // rad above the horizontal at the start, 0 ... pi/2
    double gravity = 0;   // m/s^2
    double friction = 0;  // of the floor, static and dynamic
  };
  explicit Ladder(const Setup&);

  struct State {
    double angle = 0;  // rad
    double speed = 0;  // rad/s, of the angle: never positive
  };
  State at(double t) const;

  const Setup& given() const { return given_; }
  bool stands() const { return stands_; }
  double valid_until() const { return until_; }  // s, when the head leaves the wall

  /// The normal forces per mass, N/kg: x of the wall, y of the floor.
  Vec push(const State&) const;

 private:
  double angular_acceleration(const State&) const;
  State after(const State&, double h) const;

  Setup given_;
  bool stands_;
  double until_;
};

}  // namespace plumb
