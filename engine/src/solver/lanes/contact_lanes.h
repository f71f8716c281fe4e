#pragma once

#include <cstddef>
#include <cstdint>

#include "bodies/body_set.h"
#include "contacts/contact.h"
#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// An edge of the contact graph: what sorting a contact needs to know of it.
struct Tie {
  std::uint32_t contact = 0;  // index
  std::uint32_t a = 0, b = 0;
  bool pushes_a = false, pushes_b = false;  // whether the body can be pushed
  bool moves_both = false;                  // whether both move, so that they share an island
  std::uint8_t points = 0;
  bool discs = false;
  bool smooth = false;  // frictionless, and of discs or fixed shapes: it rotates nothing
  bool two_frictions = false;
  friend bool operator==(const Tie&, const Tie&) = default;
};

/// The contact of one lane.
struct Slot {
  static constexpr std::uint32_t empty = ~std::uint32_t{0};
  Tie tie{.contact = empty};
  bool web = false;  // see ImpactRow
};

/// One number of each of `width` contacts: eight, or sixteen where a register holds so many.
template <std::size_t width>
struct Row {
  alignas(width * sizeof(Real)) Real lane[width]{};
};

/// One point of each of `width` contacts; the numbers are those of RowPoint (contact_rows.h).
template <std::size_t width>
struct SmoothPointLanes {
  using Row = impulse::Row<width>;
  Row separation;      // m, at the start of the step, less the contact's offset
  Row total_normal;    // N s, of the whole step
  Row gap;             // m, separation now
  Row normal_mass;     // effective, kg
  Row normal_impulse;  // N s, of one sub-step
};
template <std::size_t width>
struct PointLanes : SmoothPointLanes<width> {
  using Row = impulse::Row<width>;
  Row cross_a, cross_b;  // r x n, m
  Row dot_a, dot_b;      // r . n, m
  Row tangent_mass;      // effective, kg
  Row tangent_impulse;   // N s, of one sub-step
  Row total_tangent;     // N s, of the whole step
};

/// Contacts that share no movable body, so that solving them at once equals solving them one after the other. An empty
/// lane refers to a body that nothing moves, and all its numbers are 0.
///
/// Large piles do not fit into the caches, so the time of each pass is proportional to the memory it touches: what is
/// the same for many lanes is one bit of each or left to SoftRule, and masses come with the bodies.
template <std::size_t width>
struct NormalLanes {
  using Row = impulse::Row<width>;
  Row offset;  // m, standing correction of the separation
  // Bit i belongs to lane i.
  std::uint32_t web = 0;                 // see ImpactRow
  std::uint32_t fixed = 0;               // one body cannot move
  std::uint32_t aged = 0;                // old enough that the offset follows the depth
  std::uint32_t fresh = 0;               // in its first step
  bool rounded = false;                  // whether some shape is, see ContactLanes
  std::uint32_t a[width]{}, b[width]{};  // where the bodies' rows of four begin
  Row normal_x, normal_y;
};

/// Those of `points` points.
template <std::size_t points, std::size_t width>
struct ContactLanes : NormalLanes<width> {
  using Row = impulse::Row<width>;
  Row inertia_a, inertia_b;  // inverse, 1/(kg m^2)
  Row static_friction, dynamic_friction;
  Row friction;                     // the one of these that limits it now
  std::uint32_t two_frictions = 0;  // a bit for each lane: they differ
  std::uint32_t slips = 0;          // see ImpactRow
  PointLanes<width> point[points];
  Row radius_a, radius_b;  // m, by which the shapes are rounded: that part of r . n does not turn with the body
};

/// Contacts of one point that rotate nothing: a disc about its centre of mass has r x n = 0, and without friction no
/// impulse acts along r . n.
template <std::size_t width>
struct SmoothLanes : NormalLanes<width> {
  SmoothPointLanes<width> point[1];
};

/// Contacts of discs about their centres of mass: the normal follows the centres.
template <class Lanes>
struct DiscsOf : Lanes {
  using Row = typename Lanes::Row;
  Row between_x, between_y;  // m, from centre a to centre b at the start of the step
  Row distance;              // m, sum of the radii
};
template <std::size_t width>
using DiscLanes = DiscsOf<ContactLanes<1, width>>;
template <std::size_t width>
using SmoothDiscLanes = DiscsOf<SmoothLanes<width>>;

/// How lanes are solved.
enum class LanesKind : std::uint8_t {
  one,           // one point
  discs,         // one point, and the normal turns
  two,           // two points in turn, in a web
  block,         // two points at once, in a column
  smooth,        // one point that turns nothing
  smooth_discs,  // the same, and the normal turns
};
constexpr std::size_t lanes_kinds = 6;

/// All lanes of one colour and kind: none of them shares a movable body with another.
struct LanesRun {
  LanesKind kind;
  std::uint32_t begin, end;
};

/// The contacts of an island in the order in which they are solved.
template <std::size_t width>
struct ContactTable {
  ContactLanes<1, width>* one;
  DiscLanes<width>* discs;
  ContactLanes<2, width>* two;
  ContactLanes<2, width>* block;
  SmoothLanes<width>* smooth;
  SmoothDiscLanes<width>* smooth_discs;
  const LanesRun* runs;
  const LanesRun* runs_end;
};

/// Bodies as rows of four numbers. Their number is a multiple of sixteen; unused rows are 0.
struct BodyRows {
  std::uint32_t count;
  Real* velocity;            // x, y (m/s), angular (rad/s), inverse mass (1/kg)
  Real* before;              // the velocity at the start of the sub-step
  Real* kick;                // velocity change applied before and again after the drift; 0
  Real* motion;              // x, y (m), sine and cosine - 1 of the turn since the start of the step
  Real* turn;                // rad, one number a row
  const Real* acceleration;  // x, y, angular, 0
};

/// The soft constraint parameters of a pile: by [web][one body cannot move].
struct SoftRule {
  using Choice = Real[2][2];
  Choice strength, rate, relief;  // see softness.h
  Choice give;                    // m of depth under a load of 1 m/s (impulse / effective mass)
  Choice gain;                    // see OffsetRule
  Real leak;
};

/// The input of the layout.
struct LayoutInput {
  const Slot* slots[lanes_kinds];     // of each LanesKind, a multiple of the width
  std::uint32_t groups[lanes_kinds];  // how many widths
  Contact* contacts;
  const Contact* no_contact;
  const InverseMass* masses;  // of the bodies of the world
  const Pose* poses;
  const std::uint32_t* row_of;  // where in BodyRows
  std::uint32_t nobody;         // an unused row
  int offset_from_age;          // steps, from which offsets follow the depth
  Real substeps;
};

/// The passes over all contacts of an island.
template <std::size_t width>
struct ContactPasses {
  /// Copies contacts into lanes, with their effective masses.
  void (*lay_out)(const ContactTable<width>&, const LayoutInput&);
  /// For contacts just laid out whose bodies have moved before: subtracts the motion so far.
  void (*begin_late)(const ContactTable<width>&, const BodyRows&);
  /// Adds to each body's kick half of its contacts' impulses in the last sub-step, and resets the totals of the step.
  void (*kick)(const ContactTable<width>&, const BodyRows&);
  /// Contacts as soft constraints on their depth; `h` is the sub-step, s.
  void (*press)(const ContactTable<width>&, const BodyRows&, const SoftRule&, Real h);
  /// Rigid contacts with friction. `again`: not the first iteration in this sub-step.
  void (*relax)(const ContactTable<width>&, const BodyRows&, bool again);
  /// See ScalarContacts.
  void (*meet)(const ContactTable<width>&, const BodyRows&, Real slow);
  bool (*stick_or_slip)(const ContactTable<width>&, const BodyRows&, Real slow, Real slow_in_web);
  /// Moves the offsets towards the depth that the load explains; at once if `settling`.
  void (*settle)(const ContactTable<width>&, const SoftRule&, bool settling);
  /// Writes impulses and offsets back to the contacts.
  void (*store)(const ContactTable<width>&, const LayoutInput&);
};

/// Sets the kicks before the first sub-step: half a sub-step of the forces.
using KickByForces = void(const BodyRows&, Real h);
/// First half of the kick: after the first sub-step, half of the whole velocity change of the last one.
using KickBodies = void(const BodyRows&, bool first);
/// x += h v, then the second half of the kick. Returns whether some body has rotated too far for the series of the
/// kernel; its sine and cosine must be recomputed.
using DriftBodies = bool(const BodyRows&, Real h);

}  // namespace impulse::inline IMPULSE_PRECISION
