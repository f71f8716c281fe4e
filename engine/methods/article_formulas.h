#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "bodies/body_set.h"
#include "contacts/contact.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Two bodies that touch, for as long as their contact is worked on.
struct Touching {
  Velocity a, b;
  InverseMass inverse_a, inverse_b;

  Touching(const BodySet& bodies, const Contact& contact)
      : a(bodies.velocity[contact.body_a]),
        b(bodies.velocity[contact.body_b]),
        inverse_a(bodies.inverse_mass[contact.body_a]),
        inverse_b(bodies.inverse_mass[contact.body_b]) {}
};

/// The formulas of the seed, one function each, as Article puts them together (see article.h). The print has some of
/// them wrong; engine/faults prints them so again, one at a time.
struct ArticleFormulas {
  static Vec2 relative_velocity(const Touching& pair, const ContactPoint& at) {
    return pair.b.v + cross(pair.b.w, at.arm_b) - pair.a.v - cross(pair.a.w, at.arm_a);
  }

  /// The mass that an impulse along `direction` feels: 1 / (1/mA + 1/mB + (rA x d)^2/IA + (rB x d)^2/IB).
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

  /// m/s, the speed of parting that an approach at vn < 0 asks for: e |vn|, faster than gravity alone presses.
  static Real rebound(const Contact& contact, Real vn, Real resting_speed) {
    return -vn > resting_speed ? contact.restitution * -vn : 0;
  }

  /// N s, what brings a normal velocity to `target`.
  static Real normal_impulse(Real target, Real vn, Real normal_mass, int points) {
    return (target - vn) * normal_mass / static_cast<Real>(points);
  }

  static Real tangent_velocity(Vec2 relative, const Contact& contact) {
    return dot(relative, perpendicular(contact.normal));
  }

  /// N s, friction before the law of Coulomb limits it.
  static Real stopping_impulse(const Contact& contact, Real vt, Real tangent_mass) {
    return -vt * tangent_mass / static_cast<Real>(contact.count);
  }

  /// Amontons-Coulomb: sticks up to mu_static j, else slides with mu_dynamic j.
  static Real friction(const Contact& contact, Real jt, Real j) {
    if (std::abs(jt) <= contact.static_friction * j) return jt;
    return std::copysign(contact.dynamic_friction * j, jt);
  }

  /// Part 1: moves overlapping bodies apart along the normal by `depth` in all, the lighter one farther.
  static void part(BodySet& bodies, const Contact& contact, Real depth, Real /*dt*/) {
    const Real ma = bodies.inverse_mass[contact.body_a].m;
    const Real mb = bodies.inverse_mass[contact.body_b].m;
    const Vec2 correction = depth / (ma + mb) * contact.normal;
    bodies.pose[contact.body_a].p -= ma * correction;
    bodies.pose[contact.body_b].p += mb * correction;
  }
};

}  // namespace impulse::inline IMPULSE_PRECISION
