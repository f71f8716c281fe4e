#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "scenarios/scenario.h"

/// Error terms that expectations allow for, each derived from how the engine states that it steps.
namespace plumb {

/// Round-off after t seconds of stepping with numbers up to `size`. A step rounds a velocity twice and a position
/// twice, by half an epsilon each, and all these errors may have the same sign. `size` includes the effect of the
/// velocity's error on the position: |x| + |v| t.
inline double round_off(const Stepping& s, double t, double size) {
  const double steps = s.h > 0 ? t / s.h : 1;
  return 4 * s.epsilon * (steps + 1) * size;
}

/// m, the position error after t seconds of constant acceleration: drift a t h.
inline double drifted(const Stepping& s, double acceleration, double t) {
  return std::abs(s.drift) * std::abs(acceleration) * t * s.h;
}

/// s, the longest time between a contact and its detection.
inline double lag(const Stepping& s) { return s.impact_lag * s.h; }

/// m, the distance that friction of mu g = `acceleration` brakes too late where a body that starts on the ground is
/// found to touch it a lag late. Until then it falls, and the impact that ends the fall has just the impulses, of both
/// directions, that were missing: the velocity is right from then on, at the end of the next step.
inline double slid_late(const Stepping& s, double acceleration) { return acceleration * lag(s) * (lag(s) + s.h); }

/// m, by which a contact at rest overlaps if it is a spring of this frequency (see Stepping::contact_frequency):
/// `load`, N, at a point where a unit impulse changes the relative velocity by `inverse_mass`, 1/kg.
inline double spring_depth(double frequency, double load, double inverse_mass) {
  const double w = 2 * std::numbers::pi * frequency;
  return w > 0 ? load * inverse_mass / (w * w) : 0;
}

/// m, by which box k of a tower on the ground, counted from 1 below, sinks where contacts are springs: all depths below
/// it. `masses`, kg, of square boxes, the lowest first. A face rests on its two corners, each with half the load and,
/// of a body of mass m, the inverse mass 1/m + r^2/I = 2.5/m, r being half a side and I = m (2 r)^2/6.
inline double tower_sinks(const Stepping& s, double gravity, std::span<const double> masses, std::size_t k) {
  double sinks = 0;
  for (std::size_t i = 0; i < k; ++i) {
    double above = 0;
    for (const double mass : masses.subspan(i)) above += mass;
    const double inverse_mass = 2.5 / masses[i] + (i > 0 ? 2.5 / masses[i - 1] : 0);
    sinks += spring_depth(i > 0 ? s.contact_frequency : s.fixed_contact_frequency, above * gravity / 2, inverse_mass);
  }
  return sinks;
}

/// m, by which a disc that turns at `spin`, rad/s, is let down at most where contacts hold their points for a step (see
/// Stepping::held_anchors).
inline double rolls_in(const Stepping& s, double radius, double spin) {
  return s.held_anchors ? radius * (1 - std::cos(spin * s.dt)) : 0;
}

/// s, at most, for which the ground has not pressed such a disc at the end of a step: it falls as fast as its point
/// rises, r w sin(w dt), or freely. `gravity` is that towards the ground. An acceleration by friction is missing for as
/// long.
inline double unpressed(const Stepping& s, double radius, double spin, double gravity) {
  return s.held_anchors ? std::min(s.dt, radius * spin * std::sin(spin * s.dt) / gravity) : 0;
}

/// m/s, the speed that friction mu may yet have to take after t seconds of sliding: its impulse is mu times the normal
/// one, which is short by m u while the body sinks in at u, on average slop/t.
inline double still_sinking(const Stepping& s, double mu, double t) { return mu * s.slop / t; }

/// s, by which an impact at this speed may be found late, by the lag, or early, by the skin.
inline double found_off(const Stepping& s, double speed) { return std::max(lag(s), speed > 0 ? s.skin / speed : 0); }

/// Whether smooth motion may have an error proportional to h; also if nothing is stated.
inline bool first_order(const Stepping& s) { return s.h > 0 && s.order <= 1; }

/// 1/s, by which a damping of c, 1/s, is off. Of first order, a step v/(1 + c h) of the interval at which damping acts
/// is the least accurate of the usual ones: (1 + c h)^(-t/h) is at most e^(-ct) e^(c^2 t h/2). Of second order,
/// v (1 - c h/2)/(1 + c h/2) is off by c^3 h^2/12; twice that.
inline double damping_error(const Stepping& s, double c) {
  const double interval = s.damping_interval > 0 ? s.damping_interval : s.h;
  return first_order(s) ? c * c * interval / 2 : c * c * c * s.h * s.h / 6;
}

/// m, by which the way in t s of a body that is damped by c, 1/s, is off; v: m/s, what damping acts on at most. t times
/// the error of the velocity, plus one step at the start; of second order c^2 h^2/4 of the way: the speed of a step's
/// middle is v/(1 + c h/2), of which v (1 - c h/2), half a step of Verlet, lacks that share, the chord c^2 h^2/12, the
/// midpoint c^2 h^2/24. What other forces give, `acceleration`, m/s^2, changes by c of itself per second: a first-order
/// velocity is off by c a t h/2, a second-order one by c^2 a t h^2/12, and a step's way by c a h^3/6; twice that.
inline double damped_way_error(const Stepping& s, double c, double v, double t, double acceleration = 0) {
  const double own = v * t * std::expm1(damping_error(s, c) * t);
  if (first_order(s)) return own + c * t * s.h * v + c * acceleration * t * t * s.h / 2;
  return own + s.h * s.h * c * t * (c * v / 4 + acceleration * (1. / 3 + c * t / 12));
}

/// The same of motion along a contact. Such a method moves bodies along the tangent of the step's start.
inline bool first_order_in_contact(const Stepping& s) { return s.h > 0 && s.order_in_contact <= 1; }

/// Whether a method multiplies the energy of an oscillation in every step, as explicit Euler does, by at most
/// 1 + (w dt)^2. It then states that it keeps no spring bounded.
inline bool grows(const Stepping& s) { return s.drift != 0 && s.spring_limit.value_or(0) == 0; }

/// s, the interval at which forces are evaluated. The methods that do so once, symplectic Euler and Verlet, keep a
/// spring bounded up to w dt = 2; one that does so n times a step up to 2 n.
inline double force_interval(const Stepping& s) {
  if (s.h == 0) return 0;
  const double limit = s.spring_limit.value_or(0);
  return limit > 0 ? std::min(2 * s.dt / limit, s.dt) : s.dt;
}

/// By how much a body that falls on the ground at the speed v may rebound too low or too high, m of its apex.
struct ReboundError {
  double low = 0, high = 0;
};

/// In terms of the apex H that the flight would have reached, an impact at the depth d <= v lag leads to
///   reversed in place               H' = e^2 (H + d) - d
///   lifted out of the ground first  H' = e^2 (H + d), or a skin higher.
/// A method with drift D conserves v^2/(2 g) + y - D h v. What a reversal does to that depends on the order:
///   D > 0  velocities, impact, positions: H' gains D h v (e^2 + e); but if the ground stops the body within the step,
///          on its way from y = h v or less, H' = e^2 (H - y + D h v) - D h e v;
///   D < 0  positions, then the impact with the velocity of before the step: H' gains |D| h v (e - e^2).
/// Found a skin early and reversed there, it gains (1 - e^2) skin.
inline ReboundError rebound_error(const Stepping& s, double e, double v) {
  const double d = v * lag(s);
  const double step = s.h * v;
  const double late = (1 - e * e) * d;
  if (s.drift > 0) {
    return {std::max(late, step * (e * e * (1 - s.drift) + s.drift * e)),
            e * e * d + s.drift * step * (e * e + e) + s.skin};
  }
  return {late, e * e * d - s.drift * step * (e - e * e) + s.skin};
}

/// The fraction of a velocity error that the iterations (projected Gauss-Seidel) leave when k equal bodies in a row
/// collide at once. Each iteration multiplies the error by cos^2(pi/(k+1)), the spectral radius of the chain's matrix
/// [2 -1; -1 2 -1; ...] of k contacts (Young 1971).
inline double unsolved(const Stepping& s, int k) {
  if (s.iterations == 0) return 0;
  const double rate = std::cos(std::numbers::pi / (k + 1));
  return std::pow(rate * rate, s.iterations);
}

}  // namespace plumb
