#pragma once

#include "reference/simulation.h"

namespace plumb {

/// A block on a plane under Coulomb friction, along one line: it sticks while static friction can hold the drive, else
/// slides with drive - sign(v) dynamic friction; what comes to a stop may stick from then on. Holds while it lies flat.
class Slide {
 public:
  /// speed m/s at the start; drive m/s^2, what pulls it along; load m/s^2 >= 0, what presses it on, per unit of mass.
  Slide(double speed, double drive, double load, double static_friction, double dynamic_friction);

  struct State {
    double distance = 0;  // m
    double speed = 0;     // m/s
  };
  State at(double t) const;

  double stop() const { return stop_; }  // s, when its first motion ends; infinite if never
  double friction() const;               // largest |friction| met, m/s^2

  /// When it first passes a distance, s; infinite if never.
  double reaches(double distance) const;

 private:
  double speed_;
  double first_;   // m/s^2, until the stop
  double second_;  // m/s^2, after it
  double stop_;    // s
  double friction_;
};

}  // namespace plumb
