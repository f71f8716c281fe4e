#pragma once

#include <cstddef>
#include <cstdint>

#include "impulse/real.h"

namespace impulse::inline IMPULSE_PRECISION {

/// One number of each of eight contacts.
struct Eight {
  alignas(8 * sizeof(Real)) Real lane[8]{};
};

/// The points that are one of each of eight contacts; the numbers are those of RowPoint (contact_rows.h).
struct PointLanes {
  Eight cross_a, cross_b;                 // r x n, m
  Eight dot_a, dot_b;                     // r . n, m
  Eight turn_a, turn_b;                   // the part of r . n that turns with the body
  Eight separation;                       // m, at the start of the step, less the contact's offset
  Eight gap;                              // m, the same now
  Eight normal_mass, tangent_mass;        // effective, kg
  Eight normal_impulse, tangent_impulse;  // N s, of one sub-step
  Eight total_normal, total_tangent;      // N s, of the whole step
};

/// Eight contacts of `points` points that share no movable body, so that they are solved at once as if one after the
/// other. A lane that holds no contact names a body that nothing moves, and has all numbers 0.
template <std::size_t points>
struct ContactLanes {
  std::uint32_t a[8]{}, b[8]{};  // rows of the body columns
  Eight normal_x, normal_y;
  Eight mass_a, inertia_a, mass_b, inertia_b;  // inverse, 1/kg, 1/(kg m^2)
  Eight static_friction, dynamic_friction;
  Eight strength, rate, relief;  // of the soft contact, see softness.h
  Eight give;                    // m of depth that a load of 1 m/s (impulse / effective mass) explains
  Eight offset;                  // m, standing correction of the separation
  Eight offset_rate;             // share of a depth that the offset takes up in this step; 0 leaves it alone
  Eight fresh;                   // 1 in a contact's first step
  bool any_fresh = false;
  PointLanes point[points];
};

/// Discs about their centres of mass: the normal is that of their centres as they move.
struct DiscLanes : ContactLanes<1> {
  Eight between_x, between_y;  // m, from centre a to centre b at the start of the step
  Eight distance;              // m, sum of the radii
  /// N s, what b was given in the last sub-step. Bodies are given half of it again, along the normals of then, although
  /// it should be along the normal of now; `lack` is the difference.
  Eight given_x, given_y, lack_x, lack_y;
};

/// How lanes are solved.
enum class LanesKind : std::uint8_t {
  one,    // one point
  discs,  // one point, and the normal turns
  two,    // two points in turn
  block,  // two points at once
};

/// All lanes of one colour and kind: none of them shares a movable body with another.
struct LanesRun {
  LanesKind kind;
  std::uint32_t begin, end;
};

/// The contacts of an island in the order in which they are solved.
struct ContactTable {
  ContactLanes<1>* one;
  DiscLanes* discs;
  ContactLanes<2>* two;
  ContactLanes<2>* block;
  const LanesRun* runs;
  const LanesRun* runs_end;
};

/// Bodies as rows of four numbers. Their number is a multiple of eight; rows of no body are 0.
struct BodyRows {
  std::uint32_t count;
  Real* velocity;            // x, y (m/s), angular (rad/s), 0
  Real* before;              // the velocity at the start of the sub-step
  Real* kick;                // what is given before and again after the drift
  Real* motion;              // x, y (m), sine and cosine - 1 of the turn since the start of the step
  Real* turn;                // rad, one number a row
  const Real* acceleration;  // x, y, angular, 0
};

/// Effective masses from arms and inverse masses.
using WeighContacts = void(const ContactTable&);
/// Adds to each body's kick half of what its contacts gave in the last sub-step.
using KickByContacts = void(const ContactTable&, const BodyRows&);
/// Contacts as damped springs on their depth; `h` s is the sub-step.
using PressContacts = void(const ContactTable&, const BodyRows&, Real h);
/// Rigid contacts with friction. `again`: not the first sweep of this sub-step.
using RelaxContacts = void(const ContactTable&, const BodyRows&, bool again);
/// What part of the depth the standing load explains becomes the offset; all of it at once where `settling`.
using SettleOffsets = void(const ContactTable&, bool settling);

/// Before the first sub-step: the kick of the forces alone.
using KickByForces = void(const BodyRows&, Real h);
/// First half of the kick: after the first sub-step it is half of all that the last one changed, but for impacts.
using KickBodies = void(const BodyRows&, bool first);
/// x += h v, then the second half of the kick. Returns whether some body has turned too far for the series within; its
/// sine and cosine must be made anew.
using DriftBodies = bool(const BodyRows&, Real h);

}  // namespace impulse::inline IMPULSE_PRECISION
