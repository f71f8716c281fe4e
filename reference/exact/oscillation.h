#pragma once

/// Oscillations with one degree of freedom: a damped harmonic oscillator, and a pendulum of any amplitude.
namespace plumb {

/// A mass on a spring along one line: m s'' = -k s - c s', s being the stretch. Undamped or underdamped: c^2 < 4 m k.
class Oscillator {
 public:
  /// stretch in m and speed in m/s at the start, mass in kg, stiffness in N/m, damping in N s/m.
  Oscillator(double stretch, double speed, double mass, double stiffness, double damping);

  struct State {
    double stretch = 0;  // m
    double speed = 0;    // m/s
  };
  State at(double t) const;

  double frequency() const { return frequency_; }  // rad/s, of the oscillation
  double amplitude() const;                        // m, at the start; the envelope never exceeds it

 private:
  double decay_;          // 1/s
  double frequency_;      // rad/s
  double cosine_, sine_;  // m
};

/// A rigid body on a frictionless pivot, released at rest at any angle short of upright. Valid for ever.
class Pendulum {
 public:
  /// angle in rad from the downward vertical at the start, |angle| < pi; small in rad/s = sqrt(m g d/I_p), the
  /// frequency of small oscillations.
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

}  // namespace plumb
