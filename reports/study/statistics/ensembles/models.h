#pragma once

#include <array>
#include <cstdint>

namespace plumb::ensembles {

/// A row of dominoes on edge that topple about their front feet, without friction between them and with impacts of
/// restitution 0.
struct DominoRow {
  double height = 1;     // m
  double thickness = 0;  // m
  double pitch = 0;      // m, from one to the next

  /// Speed of the front, m/s, far along a row in which the last so many that were struck lean on each other and push
  /// with all their weight, and those behind them no longer. One: each is struck by one other and then falls alone (W.
  /// J. Stronge, Proc. R. Soc. A 409, 1987). Many: no loss but at impacts (J. M. J. van Leeuwen, Am. J. Phys. 78,
  /// 2010).
  double speed(int pushing) const;

  /// rad, how far one turns before it strikes the next.
  double strikes_at() const;
};

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
