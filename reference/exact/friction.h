#pragma once

/// Bodies that slide or roll under Coulomb friction. Forces are per unit of mass unless stated otherwise.
namespace plumb {

/// A block on a plane, moving along one line: it sticks while static friction can hold the drive, else it slides with
/// acceleration drive - sign(v) dynamic friction. A block that comes to a stop may stick from then on. Valid while it
/// lies flat.
class Slide {
 public:
  /// speed in m/s at the start; drive in m/s^2, the acceleration along the plane without friction; load in m/s^2 >= 0,
  /// the normal force per unit of mass.
  Slide(double speed, double drive, double load, double static_friction, double dynamic_friction);

  struct State {
    double distance = 0;  // m
    double speed = 0;     // m/s
  };
  State at(double t) const;

  double stop() const { return stop_; }  // s, when the first motion ends; infinite if never
  double friction() const;               // m/s^2, the largest |friction| that occurs

  /// When it first reaches a distance, s; infinite if never.
  double reaches(double distance) const;

 private:
  double speed_;
  double first_;   // m/s^2, acceleration until the stop
  double second_;  // m/s^2, acceleration after it
  double stop_;    // s
  double friction_;
};

/// A round body on a plane: it slips until its lowest point is at rest on the plane, then rolls if static friction can
/// hold it, else slips on in the other direction. Valid for ever on an endless plane.
class Roll {
 public:
  struct Setup {
    double speed = 0;   // m/s along the plane, at the start
    double spin = 0;    // rad/s, positive if it moves the lowest point along the plane
    double radius = 0;  // m
    double shape = 2;   // m r^2/I: 2 for a disc
    double drive = 0;   // m/s^2 along the plane
    double load = 0;    // m/s^2 onto the plane
    double static_friction = 0, dynamic_friction = 0;
  };
  explicit Roll(const Setup&);

  struct State {
    double distance = 0;  // m
    double speed = 0;     // m/s
    double angle = 0;     // rad
    double spin = 0;      // rad/s
  };
  State at(double t) const;

  double grip() const { return grip_; }  // s, when the first slip ends; infinite if never

 private:
  Setup given_;
  double first_;   // m/s^2, friction along the plane until the slip ends
  double second_;  // m/s^2, after it
  double grip_;    // s
};

/// A round body on a plank that is pulled over a frictionless floor, all at rest at the start. The body rolls on the
/// plank while static friction can hold it, else it slips. Valid until the body reaches the end of the plank.
class Plank {
 public:
  struct Setup {
    double plank = 0, body = 0;  // kg
    double radius = 0;           // m, of the body
    double shape = 2;            // m r^2/I of the body: 2 for a disc
    double pull = 0;             // N on the plank
    double gravity = 0;          // m/s^2
    double static_friction = 0, dynamic_friction = 0;
  };
  explicit Plank(const Setup&);

  double plank() const { return plank_; }  // m/s^2, along the pull
  double body() const { return body_; }    // m/s^2, of the body's centre
  double spin() const { return spin_; }    // rad/s^2, positive if it moves the lowest point along the pull
  bool rolls() const { return rolls_; }

 private:
  double plank_, body_, spin_;
  bool rolls_;
};

}  // namespace plumb
