#pragma once

namespace plumb {

/// A point dropped vertically onto a floor: a sequence of parabolas, each starting at e times the speed of the last.
/// Valid for ever: if e < 1 the landings accumulate at a finite time, and the point rests from then on.
class Bounce {
 public:
  /// height in m above the floor and speed in m/s upwards at the start, gravity in m/s^2 > 0, restitution 0 ... 1.
  Bounce(double height, double speed, double gravity, double restitution);

  struct State {
    double height = 0;  // m
    double speed = 0;   // m/s upwards
  };
  State at(double t) const;

  double apex(int n) const;    // m, height after the n-th landing
  double impact(int n) const;  // s, time of the n-th landing
  double rest() const;         // s, time when it comes to rest; infinite for e = 1

 private:
  State start_;
  double gravity_;
  double restitution_;
  double landing_;        // s, of the first
  double landing_speed_;  // m/s downwards, of the first
};

}  // namespace plumb
