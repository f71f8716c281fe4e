#pragma once

namespace plumb {

/// A round body on a plane under Coulomb friction: it slips until its rim stands still on the plane, then rolls if
/// static friction can hold it, else slips on the other way. Holds for ever on an endless plane.
class Roll {
 public:
  struct Case {
    double speed = 0;   // m/s along the plane, at the start
    double spin = 0;    // rad/s, positive where it carries the rim that touches along
    double radius = 0;  // m
    double shape = 2;   // m r^2/I: 2 for a disc
    double drive = 0;   // m/s^2 along the plane
    double load = 0;    // m/s^2 onto the plane
    double static_friction = 0, dynamic_friction = 0;
  };
  explicit Roll(const Case&);

  struct State {
    double distance = 0;  // m
    double speed = 0;     // m/s
    double angle = 0;     // rad
    double spin = 0;      // rad/s
  };
  State at(double t) const;

  double grip() const { return grip_; }  // s, when slip first ends; infinite if never

 private:
  Case given_;
  double first_;   // friction, m/s^2 along, until slip ends
  double second_;  // and after
  double grip_;    // s
};

}  // namespace plumb
