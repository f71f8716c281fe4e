#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "bodies/body_set.h"
#include "contacts/contact.h"
#include "impulse/settings.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The velocities of two touching bodies while their contact is solved.
struct Touching {
  Velocity a, b;
  InverseMass inverse_a, inverse_b;

  Touching(const BodySet& bodies, const Contact& contact)
      : a(bodies.velocity[contact.body_a]),
        b(bodies.velocity[contact.body_b]),
        inverse_a(bodies.inverse_mass[contact.body_a]),
        inverse_b(bodies.inverse_mass[contact.body_b]) {}
};

/// The formulas and constants of the article's method, one function each; see Article in article.cpp. Misprints in the
/// article are corrected.
struct ArticleFormulas {
  static constexpr Real slop =
      static_cast<Real>(.005);  // m, overlap left alone, so that a resting contact exists in every step
  static constexpr Real percent =
      static_cast<Real>(.4);  // of the overlap beyond it, removed in a step; all at once makes stacks jitter
  static constexpr Real joint_percent =
      static_cast<Real>(0.2);  // of a joint's error, removed in a step (Baumgarte 1972)

  /// m/s. The demo engine's rule: gravity alone presses resting bodies together at |g| dt in every step. That is no
  /// impact, so e = 0 up to this speed; and a tenth more, for what the iterations of the last step left.
  static Real resting_speed(const Settings& settings) {
    return static_cast<Real>(1.1) * length(settings.gravity) * settings.dt;
  }

  static void state_errors(const Settings& settings, StatedErrors& errors) {
    errors.gap = slop;
    // A step of free fall, g dt^2, is what each step adds to a joint's error, and it removes `joint_percent` of it.
    errors.joint_gap = length(settings.gravity) * settings.dt * settings.dt / joint_percent;
    errors.joints = true;
    // Friction is limited by each normal impulse and not by their sum, so the speed that gravity adds along a slope in
    // a step, |g| sin(slope) dt, is never removed completely.
    errors.creep = length(settings.gravity) * settings.dt;
    errors.restitution_threshold = resting_speed(settings);
  }

  static Vec2 relative_velocity(const Touching& pair, const ContactPoint& at) {
    return pair.b.v + cross(pair.b.w, at.arm_b) - pair.a.v - cross(pair.a.w, at.arm_a);
  }

  /// kg, the effective mass along `direction`: 1 / (1/mA + 1/mB + (rA x d)^2/IA + (rB x d)^2/IB).
  static Real mass(const Touching& pair, const ContactPoint& at, Vec2 direction) {
    const Real ra = cross(at.arm_a, direction);
    const Real rb = cross(at.arm_b, direction);
    const Real k = pair.inverse_a.m + pair.inverse_b.m + pair.inverse_a.i * ra * ra + pair.inverse_b.i * rb * rb;
    return k > 0 ? 1 / k : 0;
  }
  static Real normal_mass(const Touching& pair, const ContactPoint& at, Vec2 normal) { return mass(pair, at, normal); }
  static Real tangent_mass(const Touching& pair, const ContactPoint& at, Vec2 normal) {
    return mass(pair, at, perpendicular(normal));
  }

  static void push(Touching& pair, const ContactPoint& at, Vec2 impulse) {
    pair.a.v -= pair.inverse_a.m * impulse;
    pair.a.w -= pair.inverse_a.i * cross(at.arm_a, impulse);
    pair.b.v += pair.inverse_b.m * impulse;
    pair.b.w += pair.inverse_b.i * cross(at.arm_b, impulse);
  }

  /// m/s, the rebound speed for an approach at vn < 0: e |vn|, or 0 up to the resting speed.
  static Real rebound(const Contact& contact, Real vn, Real resting_speed) {
    return -vn > resting_speed ? contact.restitution * -vn : 0;
  }

  /// N s, the impulse that changes the normal velocity to `target`, divided by the number of points.
  static Real normal_impulse(Real target, Real vn, Real normal_mass, int points) {
    return (target - vn) * normal_mass / static_cast<Real>(points);
  }

  static Real tangent_velocity(Vec2 relative, const Contact& contact) {
    return dot(relative, perpendicular(contact.normal));
  }

  /// N s, the friction impulse before Coulomb's law limits it.
  static Real stopping_impulse(const Contact& contact, Real vt, Real tangent_mass) {
    return -vt * tangent_mass / static_cast<Real>(contact.count);
  }

  /// Amontons-Coulomb: sticks up to mu_static j, otherwise slides with mu_dynamic j.
  static Real friction(const Contact& contact, Real jt, Real j) {
    if (std::abs(jt) <= contact.static_friction * j) return jt;
    return std::copysign(contact.dynamic_friction * j, jt);
  }

  /// Part 1 of the article: moves overlapping bodies apart along the normal by a total of `depth`, the lighter one
  /// farther.
  static void part(BodySet& bodies, const Contact& contact, Real depth) {
    const Real ma = bodies.inverse_mass[contact.body_a].m;
    const Real mb = bodies.inverse_mass[contact.body_b].m;
    const Vec2 correction = depth / (ma + mb) * contact.normal;
    bodies.pose[contact.body_a].p -= ma * correction;
    bodies.pose[contact.body_b].p += mb * correction;
  }
};

}  // namespace impulse::inline IMPULSE_PRECISION
