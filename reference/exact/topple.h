#pragma once

#include "reference/exact/oscillation.h"
#include "scenarios/scene/scene.h"

/// What stands on a rough floor or falls from rest: a body on the edge of its base, and a ladder against a wall.
namespace plumb {

/// A rigid body at rest on a rough floor that may turn about the edge of its base. With its centre beyond the edge it
/// topples as an inverted pendulum; with its centre above the base it stands. Valid until the edge slips or leaves the
/// floor, or the body lands on its side.
class Topple {
 public:
  struct Setup {
    double arm = 0;       // m, from the edge to the centre
    double lean = 0;      // rad, of the arm beyond the vertical at the start; the body stands if it is at most 0
    double gyration = 0;  // m^2, I/m about the centre
    double gravity = 0;   // m/s^2
    double slope = 0;     // rad, of the floor, downwards in the direction of the fall
    double friction = 0;  // static
    double landing = 0;   // rad, rotation at which it lands
  };
  explicit Topple(const Setup&);

  struct State {
    double turn = 0;  // rad, in the direction of the fall
    double spin = 0;  // rad/s
  };
  State at(double t) const;

  /// The floor's force on the body per mass, N/kg: x along the floor in the direction of the fall, y normal to it.
  Vec push(double t) const;

  double valid_until() const { return until_; }  // s; 0 if it slips from the start

 private:
  bool stands() const { return given_.lean <= 0; }
  bool holds(double t) const;

  Setup given_;
  Pendulum pendulum_;
  double until_;
};

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
