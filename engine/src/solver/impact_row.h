#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "bodies/body_set.h"
#include "contacts/contact.h"
#include "contacts/contact_effect.h"
#include "contacts/contact_rows.h"

namespace impulse::inline IMPULSE_PRECISION {

/// m/s, a velocity that rounding may leave of none.
constexpr Real no_speed = static_cast<Real>(1e-4);
/// m, between bodies that may push each other within a step.
constexpr Real near_by = static_cast<Real>(0.005);
/// m; bodies that overlap by more were not pressed into each other by loads.
constexpr Real deep_overlap = static_cast<Real>(0.005);
/// Whether one of two points does.
template <class Points>
bool is_deep(const Points& points) {
  return std::min(points[0].separation, points[1].separation) <= -deep_overlap;
}
/// m/s, sliding that rounding may leave of none: a contact that bears all of its static friction holds below that.
constexpr Real no_slip = static_cast<Real>(sizeof(Real) == 8 ? 1e-9 : 1e-6);

/// The inverse of the matrix k of inverse effective masses of two points: maps velocity changes to impulses.
struct PairMatrix {
  Real i11 = 0, i22 = 0, i12 = 0;  // kg
  bool usable = false;  // false for points almost in one place: k does not determine the difference of their loads

  PairMatrix() = default;
  PairMatrix(Real k11, Real k22, Real k12) {
    const Real determinant = k11 * k22 - k12 * k12;
    constexpr Real worst_condition = 1000;
    usable = k11 * k22 <= worst_condition * determinant;
    if (!usable) return;
    const Real inverse = 1 / determinant;
    i11 = k22 * inverse;
    i22 = k11 * inverse;
    i12 = -k12 * inverse;
  }
  Vec2 operator*(Vec2 v) const { return {i11 * v.x + i12 * v.y, i12 * v.x + i22 * v.y}; }
};

/// Two points that are solved together.
struct PointPair {
  Real strength = 0;                   // of the soft constraint this was made for; 0: none
  std::array<Real, 2> inverse_mass{};  // 1/kg, effective, of each alone
  Real coupling = 0;                   // 1/kg, velocity change at one for an impulse at the other
  std::array<Real, 2> give{};          // 1/kg, compliance of the soft constraints
  PairMatrix rigid;
  PairMatrix soft;  // both points soft

  PairMatrix matrix(const std::array<Real, 2>& springs) const {
    return {inverse_mass[0] + springs[0], inverse_mass[1] + springs[1], coupling};
  }
};

/// A row with the additional data of the sub-step of `accurate`.
struct ImpactRow : ContactRow {
  Real offset = 0;           // m, lasting correction of the separation (see OffsetRule)
  Real disc_distance = 0;    // m, sum of radii when both are discs about their centres: their normal turns as they move
  Vec2 between;              // of those centres at the start of the step
  Vec2 led;                  // their normal before the sub-step's drift
  std::array<Vec2, 2> half;  // of each point's last impulse, along normal and tangent
  // m/s, at which each point must part in this sub-step, for impacts have moved the start of its path into overlap.
  std::array<Real, 2> parts{};
  std::array<Real, 2> gaps{};  // m, separations less the offset, where the bodies are while this is solved
  ContactEffect effect;        // if its normal rotates
  int age = 0;                 // steps since the contact began
  bool made = false;           // still valid if the contact's points are those below
  Pose found_a, found_b;
  std::array<Real, 2> found_separation{};
  NormalOf normal_of = NormalOf::between;  // set if it turns
  bool stirs_a = true;                     // the body can move, see BodySet::stirs
  bool stirs_b = true;
  bool turns = false;    // its normal follows the bodies within a step
  bool strikes = false;  // its impacts are events
  bool active = true;    // takes part in this sub-step's solve
  bool fresh = false;    // first step of the contact
  bool slips = false;    // slides, so that the dynamic coefficient limits friction
  bool web = false;      // a body of it touches more than two others, as in a pyramid and not in a column
  bool block = false;    // its two points are solved together, by `pair`
  PointPair pair;

  /// m, the lesser of the gaps.
  Real nearest() const { return count < 2 ? gaps[0] : std::min(gaps[0], gaps[1]); }
  bool two_frictions() const { return static_friction != dynamic_friction; }
  /// The coefficient that limits friction now.
  Real friction() const { return slips ? dynamic_friction : static_friction; }
  /// Adds an impulse j, N s, which acted at `at` along n and its tangent, to a point's totals of the step.
  void note(RowPoint& p, const PointArms& at, Vec2 n, Vec2 j) {
    if (j == Vec2{}) return;
    p.total_normal += j.x;
    p.total_tangent += j.y;
    if (turns) effect.note(at, n, j);
  }
};

/// m/s, a bound of how fast points of a row's bodies near each other.
inline Real fastest_nearing(const ImpactRow& row, const BodySet& bodies) {
  const Velocity& a = bodies.velocity[row.a];
  const Velocity& b = bodies.velocity[row.b];
  const std::vector<Real>& reach = bodies.bounding_radius;
  return length(b.v - a.v) + std::abs(a.w) * reach[row.a] + std::abs(b.w) * reach[row.b];
}

}  // namespace impulse::inline IMPULSE_PRECISION
