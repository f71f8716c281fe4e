#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "bodies/body_set.h"
#include "contacts/contact.h"

namespace impulse::inline IMPULSE_PRECISION {

/// A contact point as solvers iterate on it, in the frame of its contact: normal n and tangent t = perpendicular(n).
/// With the arms r from each centre of mass, the point's relative velocity is
///
///   along n:  n.(vB - vA) + wB (rB x n) - wA (rA x n)
///   along t:  t.(vB - vA) + wB (rB . n) - wA (rA . n)        because r x t = r . n
///
/// so four numbers describe where a point is.
struct PointArms {
  Real cross_a = 0, cross_b = 0;  // r x n, m
  Real dot_a = 0, dot_b = 0;      // r . n, m
  Real turn_a = 0, turn_b = 0;    // the part of r . n that rotates with the body: a disc's rim does not
  Real separation = 0;            // m, at the start of the step
};

/// The arms of the i-th point of a contact.
inline PointArms arms_of(const Contact& contact, std::size_t i) {
  const ContactPoint& from = contact.points[i];
  PointArms to;
  to.cross_a = cross(from.arm_a, contact.normal);
  to.cross_b = cross(from.arm_b, contact.normal);
  // The point lay midway between the surfaces when it was found; each arm ends on its own body's surface.
  to.dot_a = dot(from.arm_a, contact.normal) - contact.found_separation[i] / 2;
  to.dot_b = dot(from.arm_b, contact.normal) + contact.found_separation[i] / 2;
  to.turn_a = to.dot_a - contact.radius_a;
  to.turn_b = to.dot_b + contact.radius_b;
  to.separation = from.separation;
  return to;
}

struct RowPoint : PointArms {
  Real normal_mass = 0, tangent_mass = 0;        // effective, kg
  Real normal_impulse = 0, tangent_impulse = 0;  // N s, of one sub-step
  Real total_normal = 0, total_tangent = 0;      // N s, of the whole step
};

struct ContactRow {
  std::uint32_t a = 0, b = 0;
  Vec2 normal;
  InverseMass mass_a, mass_b;
  Real static_friction = 0, dynamic_friction = 0, restitution = 0;
  int count = 0;
  std::uint32_t contact = 0;  // index of the contact it was made from
  std::array<RowPoint, 2> points;
};

/// The velocities of a row's two bodies along its normal and tangent. Impulses change only this; write_back() applies
/// their sum to the bodies. All terms of a body that neither moves nor can be pushed are 0, so a frame without it gives
/// the same bits.
template <bool has_a, bool has_b>
struct FrameOf {
  static constexpr bool with_a = has_a;
  static constexpr bool with_b = has_b;

  Real normal = 0, tangent = 0;          // relative velocity of the centres, m/s
  Real wa = 0, wb = 0;                   // rad/s
  Real normal_sum = 0, tangent_sum = 0;  // N s applied so far

  FrameOf(const ContactRow& row, const Velocity& a, const Velocity& b) : wa(a.w), wb(b.w) {
    const Vec2 between = difference(a.v, b.v);
    normal = dot(row.normal, between);
    tangent = dot(perpendicular(row.normal), between);
  }

  Real normal_velocity(const RowPoint& p) const { return with_turns(normal, p.cross_a, p.cross_b); }
  Real tangent_velocity(const RowPoint& p) const { return with_turns(tangent, p.dot_a, p.dot_b); }

  void push_normal(const ContactRow& row, const RowPoint& p, Real impulse) {
    normal += impulse * inverse_mass(row);
    turn(row, p.cross_a, p.cross_b, impulse);
    normal_sum += impulse;
  }
  void push_tangent(const ContactRow& row, const RowPoint& p, Real impulse) {
    tangent += impulse * inverse_mass(row);
    turn(row, p.dot_a, p.dot_b, impulse);
    tangent_sum += impulse;
  }
  /// Bodies that cannot be pushed are not written: they may belong to other islands too.
  void write_back(const ContactRow& row, Velocity& a, Velocity& b) const {
    const Vec2 impulse = normal_sum * row.normal + tangent_sum * perpendicular(row.normal);
    if (has_a && row.mass_a.m + row.mass_a.i > 0) {
      a.v -= row.mass_a.m * impulse;
      a.w = wa;
    }
    if (has_b && row.mass_b.m + row.mass_b.i > 0) {
      b.v += row.mass_b.m * impulse;
      b.w = wb;
    }
  }

  static Vec2 difference(Vec2 a, Vec2 b) {
    if constexpr (!has_a) return b;
    if constexpr (!has_b) return -a;
    return b - a;
  }

 private:
  static Real inverse_mass(const ContactRow& row) {
    if constexpr (!has_a) return row.mass_b.m;
    if constexpr (!has_b) return row.mass_a.m;
    return row.mass_a.m + row.mass_b.m;
  }
  Real with_turns(Real straight, Real arm_a, Real arm_b) const {
    if constexpr (has_b) straight += wb * arm_b;
    if constexpr (has_a) straight -= wa * arm_a;
    return straight;
  }
  void turn(const ContactRow& row, Real arm_a, Real arm_b, Real impulse) {
    if constexpr (has_a) wa -= impulse * row.mass_a.i * arm_a;
    if constexpr (has_b) wb += impulse * row.mass_b.i * arm_b;
  }
};
using ContactFrame = FrameOf<true, true>;

/// The effective mass along a direction, 1 / (1/mA + 1/mB + cA^2/IA + cB^2/IB) with c = arm x direction; 0 if neither
/// body can move.
Real effective_mass(const InverseMass& a, const InverseMass& b, Real arm_a, Real arm_b);
inline Real effective_mass(const ContactRow& row, Real arm_a, Real arm_b) {
  return effective_mass(row.mass_a, row.mass_b, arm_a, arm_b);
}

/// Whether a contact has points and a body that can be pushed.
bool solvable(const BodySet& bodies, const Contact& contact);

/// The row of a solvable contact; impulses are those of the last step.
ContactRow make_row(const BodySet& bodies, const std::vector<Contact>& contacts, std::uint32_t index);

/// Rows of all solvable contacts.
void prepare_rows(const BodySet& bodies, const std::vector<Contact>& contacts, std::vector<ContactRow>& rows);

/// Writes a row's impulses back to its contact for the next warm start, and the totals of the step.
void store_row(const ContactRow& row, std::vector<Contact>& contacts);

/// Coulomb friction: limits the impulse `wanted` by the normal impulse. Sticks up to the static coefficient, and slides
/// with the dynamic one beyond.
inline Real within_cone(const ContactRow& row, Real wanted, Real normal_impulse) {
  if (std::abs(wanted) <= row.static_friction * normal_impulse) return wanted;
  const Real most = row.dynamic_friction * normal_impulse;
  return clamp(wanted, -most, most);
}

/// Applies the impulse that changes a point's accumulated normal impulse to `total`.
template <class Frame>
[[gnu::always_inline]] inline void apply_accumulated(const ContactRow& row, RowPoint& p, Frame& frame, Real total) {
  frame.push_normal(row, p, total - p.normal_impulse);
  p.normal_impulse = total;
}

/// Applies the accumulated impulses of a row's points again.
inline void warm_start(const ContactRow& row, ContactFrame& frame) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
    frame.push_normal(row, row.points[i], row.points[i].normal_impulse);
    frame.push_tangent(row, row.points[i], row.points[i].tangent_impulse);
  }
}

/// Friction at all points: stops the sliding as far as the friction cone of the accumulated normal impulse allows.
template <class Frame>
[[gnu::always_inline]] inline void solve_friction(ContactRow& row, Frame& frame) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
    RowPoint& p = row.points[i];
    const Real wanted = p.tangent_impulse - p.tangent_mass * frame.tangent_velocity(p);
    const Real held = within_cone(row, wanted, p.normal_impulse);
    frame.push_tangent(row, p, held - p.tangent_impulse);
    p.tangent_impulse = held;
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
