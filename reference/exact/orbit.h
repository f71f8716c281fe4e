#pragma once

#include "scenarios/scene/scene.h"

namespace plumb {

/// An ellipse about a centre that attracts with strength/r^2 (Kepler). Valid for ever.
class Orbit {
 public:
  /// position in m and velocity in m/s relative to the centre at the start, strength in m^3/s^2. Needs
  /// v^2/2 < strength/r.
  Orbit(Vec position, Vec velocity, double strength);

  struct State {
    Vec position, velocity;
  };
  State at(double t) const;

  double period() const;  // s
  double semi_major_axis() const { return axis_; }

 private:
  Vec position_, velocity_;
  double strength_;
  double axis_;  // m
};

}  // namespace plumb
