#pragma once

#include "reference/exact/pendulum.h"
#include "reference/plane.h"

namespace plumb {

/// A rigid body at rest on a rough floor, about to turn about the edge of its base: with its centre beyond the edge it
/// topples, an upside-down pendulum; with its centre above the base it stands. Holds until the edge slips or leaves
/// the floor, or the body lands on its side.
class Topple {
 public:
  struct Case {
    double arm = 0;       // m, from the edge to the centre
    double lean = 0;      // rad, of the arm beyond the vertical at the start; at most 0: it stands
    double gyration = 0;  // m^2, I/m about the centre
    double gravity = 0;   // m/s^2
    double slope = 0;     // rad, of the floor, down in the direction of the fall
    double friction = 0;  // static
    double landing = 0;   // rad, turned when it lands
  };
  explicit Topple(const Case&);

  struct State {
    double turn = 0;  // rad, in the direction of the fall
    double spin = 0;  // rad/s
  };
  State at(double t) const;

  /// The floor's force on the body per mass, N/kg: x along the floor in the direction of the fall, y off the floor.
  Vec push(double t) const;

  double valid_until() const { return until_; }  // s; 0 where it slips from the start

 private:
  bool stands() const { return given_.lean <= 0; }
  bool holds(double t) const;

  Case given_;
  Pendulum pendulum_;
  double until_;
};

}  // namespace plumb
