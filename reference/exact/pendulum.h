#pragma once

namespace plumb {

/// A rigid body on a frictionless pivot, let go at rest, at any angle short of upright. Holds for ever.
class Pendulum {
 public:
  /// angle rad against the downward vertical at the start, |angle| < pi; small rad/s = sqrt(m g d/I_p), the frequency
  /// that small swings have.
  Pendulum(double angle, double small);

  struct State {
    double angle = 0;  // rad
    double speed = 0;  // rad/s
  };
  State at(double t) const;

  double period() const;  // s

 private:
  double small_;
  double sine_, cosine_;  // of half the angle at the start: Jacobi's modulus and its complement
};

/// The arithmetic-geometric mean.
double agm(double a, double b);

}  // namespace plumb
