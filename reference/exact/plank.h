#pragma once

namespace plumb {

/// A round body on a plank that is pulled over a floor without friction, all at rest at first. The body rolls on the
/// plank while static friction can hold it, else slips. Holds until the body reaches the plank's end.
class Plank {
 public:
  struct Case {
    double plank = 0, body = 0;  // kg
    double radius = 0;           // m, of the body
    double shape = 2;            // m r^2/I of the body: 2 for a disc
    double pull = 0;             // N on the plank
    double gravity = 0;          // m/s^2
    double static_friction = 0, dynamic_friction = 0;
  };
  explicit Plank(const Case&);

  double plank() const { return plank_; }  // m/s^2, along the pull
  double body() const { return body_; }    // m/s^2, of the body's centre
  double spin() const { return spin_; }    // rad/s^2, positive where the rim below goes along the pull
  bool rolls() const { return rolls_; }

 private:
  double plank_, body_, spin_;
  bool rolls_;
};

}  // namespace plumb
