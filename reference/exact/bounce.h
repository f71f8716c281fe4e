#pragma once

#include <span>
#include <vector>

#include "reference/simulation.h"

namespace plumb {

/// A point dropped on a floor at right angles: parabola after parabola, each landing at e times the speed of the last.
/// Holds for ever: where e < 1 the landings pile up at a finite time and it rests from there on.
class Bounce {
 public:
  /// height m above the floor, speed m/s upwards at the start, gravity m/s^2 > 0, restitution 0 ... 1.
  Bounce(double height, double speed, double gravity, double restitution);

  struct State {
    double height = 0;  // m
    double speed = 0;   // m/s upwards
  };
  State at(double t) const;

  double apex(int n) const;    // m, after the n-th landing
  double impact(int n) const;  // s, of the n-th landing
  double rest() const;         // s, infinite for e = 1

 private:
  State start_;
  double gravity_;
  double restitution_;
  double landing_;        // s, of the first
  double landing_speed_;  // m/s downwards, of the first
};

}  // namespace plumb
