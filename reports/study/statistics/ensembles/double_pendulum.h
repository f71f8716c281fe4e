#pragma once

#include <array>
#include <cstdint>

namespace plumb::ensembles {

/// Two slender rods in a plane, the second hinged to the end of the first, which is hinged to the world, under gravity
/// of 10 m/s^2, without any part of an engine.
struct DoublePendulum {
  static constexpr double length = 1;       // m, of each rod
  static constexpr double thickness = 0.1;  // m

  /// Angles a, b from the downward vertical, rad, and their rates, rad/s.
  using State = std::array<double, 4>;

  /// The rates of change of a state (Lagrange's equations).
  static State derivative(const State&);

  /// J per kg of a rod, 0 where both hang at rest.
  static double energy(const State&);

  /// A state of the energy that both rods have at an angle of 2.2 rad, at a random time on a chaotic motion.
  static State drawn(std::uint64_t seed);

  /// After that time, s, by Runge and Kutta's fourth-order method in steps of 1 ms.
  static State after(const State&, double time);
};

/// Between two states, in units in which an angle counts as much as a rate over sqrt(g/l).
double distance(const DoublePendulum::State&, const DoublePendulum::State&);

}  // namespace plumb::ensembles
