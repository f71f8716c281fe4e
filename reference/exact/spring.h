#pragma once

namespace plumb {

/// A mass on a spring along one line: m s'' = -k s - c s', s the stretch. Undamped or underdamped: c^2 < 4 m k.
class Oscillator {
 public:
  /// stretch m and speed m/s at the start, mass kg, stiffness N/m, damping N s/m.
  Oscillator(double stretch, double speed, double mass, double stiffness, double damping);

  struct State {
    double stretch = 0;  // m
    double speed = 0;    // m/s
  };
  State at(double t) const;

  double frequency() const { return frequency_; }  // rad/s, of the swing
  double amplitude() const;                        // m, at the start; the envelope never exceeds it

 private:
  double decay_;          // 1/s
  double frequency_;      // rad/s
  double cosine_, sine_;  // m
};

}  // namespace plumb
