#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenarios/allowance.h"

/// What swinging about a hinge has in closed form, and what it allows.
namespace plumb {

/// m, the length L of the simple pendulum that has this period, s, at this amplitude, rad, under gravity, m/s^2: T = 2
/// pi sqrt(L/g)/agm(1, cos(a/2)) (Gauss). The arithmetic-geometric mean converges quadratically.
inline double simple_pendulum(double period, double amplitude, double gravity) {
  double a = 1;
  double b = std::cos(amplitude / 2);
  for (int i = 0; i < 8; ++i) {
    const double geometric = std::sqrt(a * b);
    a = (a + b) / 2;
    b = geometric;
  }
  const double w = 2 * std::numbers::pi / (period * a);
  return gravity / (w * w);
}

/// A rigid body that is let go from rest about a hinge: angle'' = -w^2 sin(angle), w^2 = m g d/I_p. By a time t it has
/// turned by at most A and reached at most the angular velocity W:
///   first     x and angle are half a step ahead or behind: |drift| h W. (A step of symplectic Euler gives the exact
///             velocity of the half step before.)
///   lost      first-order methods solve a hinge at the velocity level: the centre moves along the tangent, and what is
///             no longer tangential of its velocity is removed. A step that turns by W h loses m d^2/I_p (W h)^2/2 of
///             the speed, and as much of the swing;
///   second    its phase is (w h)^2/24 w t ahead, and after projection back onto the circle it has turned by atan(W h):
///             (W h)^2/3 W t;
///   growth    errors grow like cosh(w t) while the rod is above the pivot; a method that keeps no spring bounded
///             multiplies the energy by at most 1 + (w h)^2 per step;
///   hinge     it may be off by the joint's slop, slop/d in angle.
/// A phase error costs no energy. What does is the drift's torque times its advance, m g d |drift| h W; what is lost,
/// twice its share of the kinetic energy I W^2/2; and the oscillation of the second-order terms.
struct HingedRod {
  double angle = 0;     // rad, at the start, from the downward vertical
  double distance = 0;  // m, from the pivot to the centre
  double weight = 0;    // N
  double inertia = 0;   // kg m^2, about the pivot
  double share = 0;     // the centre's part of the kinetic energy

  double w() const { return std::sqrt(weight * distance / inertia); }
  bool above() const { return std::abs(angle) > std::numbers::pi / 2; }

  // Bounds of the swing. From rest, s'' <= w^2 |sin s|: at most w^2 if it may pass the horizontal, else w^2 sin(angle);
  // and for a rod above the pivot, in terms of its lean, the growth of the linear equation.
  double fastest(double time) const {
    const double by_energy = 2 * w() * std::abs(std::sin(angle / 2));
    const double pull = above() ? 1 : std::abs(std::sin(angle));
    const double lean = std::numbers::pi - std::abs(angle);
    const double by_growth = above() ? lean * w() * std::sinh(w() * time) : by_energy;
    return std::min({by_energy, pull * w() * w() * time, by_growth});
  }
  double swept(double time) const {
    return std::min({2 * std::abs(angle), fastest(time) * time, w() * w() * time * time / 2});
  }

  double second(const Stepping& s, double time) const {
    const double k = w() * s.h;
    const double turned = fastest(time) * s.h;
    return k * k / 24 + turned * turned / 3;
  }
  // Of the speed, in all steps until then.
  double lost(const Stepping& s, double time) const {
    const double turned = fastest(time) * s.h;
    return first_order(s) ? share * turned * turned / 2 * time / s.h : 0;
  }
  double grown(const Stepping& s, double time) const {
    const double k = w() * s.h;
    return grows(s) ? std::pow(1 + k * k, time / (2 * s.h)) - 1 : 0;
  }

  double turn(const Stepping& s, double time) const {
    const double unstable = above() ? std::cosh(w() * time) : 1;
    const double w_max = fastest(time);
    const double round = round_off(s, time, 4 + fastest(10) * time) * unstable;
    if (s.h == 0) return round;
    // No growth of what is lost: it is proportional to the cube of a speed that itself grew like that until then.
    return std::abs(s.drift) * s.h * w_max + lost(s, time) * swept(time) + second(s, time) * w_max * time * unstable +
           grown(s, time) * std::abs(angle) * unstable + s.joint_slop / distance * unstable + round;
  }

  double energy(const Stepping& s, double time) const {
    const double w_max = fastest(time);
    const double round = 2 * weight * distance * round_off(s, time, 4 + w_max * time);
    if (s.h == 0) return round;
    return weight * distance * std::abs(s.drift) * s.h * w_max +
           inertia * w_max * w_max * (lost(s, time) + grown(s, time) + second(s, time)) + weight * s.joint_slop + round;
  }
};

}  // namespace plumb
