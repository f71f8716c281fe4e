#pragma once

#include "reference/plane.h"

namespace plumb {

/// An ellipse about a centre that attracts with strength/r^2 (Kepler). Holds for ever.
class Orbit {
 public:
  /// place m and velocity m/s against the centre at the start, strength m^3/s^2. Needs v^2/2 < strength/r.
  Orbit(Vec place, Vec velocity, double strength);

  struct State {
    Vec place, velocity;
  };
  State at(double t) const;

  double period() const;  // s
  double semi_major_axis() const { return axis_; }

 private:
  Vec place_, velocity_;
  double strength_;
  double axis_;  // m
};

}  // namespace plumb
