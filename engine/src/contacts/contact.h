#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

struct BodySet;

/// m, the gap up to which a point touches: rounding must not decide which points act.
constexpr Real touching_gap = static_cast<Real>(1e-6);

/// Kernels read its numbers in rows of four.
struct ContactPoint {
  Vec2 arm_a, arm_b;              // from each centre of mass to the point, world frame
  Real normal_impulse = 0;        // N s: at the end of the last step (warm start), for a step of dt
  Real tangent_impulse = 0;       // along perpendicular(normal)
  Real total_normal_impulse = 0;  // N s over the whole step, sub-steps and impacts included; for readers
  Real total_tangent_impulse = 0;
  Real separation = 0;  // m, in this step
  std::uint32_t feature = 0;
};

/// Two touching (or nearly touching) shapes of two bodies. Contacts are sorted by (body_a, body_b, part_a, part_b) with
/// body_a < body_b, so that results never depend on the broad phase. Kernels read numbers in rows of four: from the
/// normal, from the friction, of poses, of points.
struct Contact {
  std::uint32_t body_a = 0, body_b = 0;
  std::uint16_t part_a = 0, part_b = 0;
  int count = 0;
  Vec2 normal;                             // unit, from a to b
  std::array<Real, 2> found_separation{};  // m, of each point when it was found
  Real static_friction = 0, dynamic_friction = 0;
  Real radius_a = 0, radius_b = 0;  // m, by which the shapes are rounded
  Real restitution = 0;
  Real offset = 0;                      // m, for solvers that keep a lasting correction of the separation
  int age = 0;                          // steps since it began
  bool disc_a = false, disc_b = false;  // a circle about its body's centre of mass
  bool joins = false;                   // with a fixed shape that continues in another which the part meets
  bool in_corner = false;               // that the fixed shape forms with another which the part meets
  bool slips = false;                   // for solvers that remember it: it slid at the end of the last step
  Pose found_a, found_b;                // of the bodies when points and separations were found
  std::array<ContactPoint, 2> points;

  /// Its points are not those found at its bodies' poses, so that the next search must find them anew.
  void forget_place() { found_a.p = found_b.p = Vec2{1, 1} * std::numeric_limits<Real>::infinity(); }
  bool discs() const { return disc_a && disc_b; }
  /// Whether friction depends on what it did before.
  bool two_frictions() const { return static_friction != dynamic_friction; }
};

/// The reference face that determines a contact's normal; `between`: the line between the nearest points.
enum class NormalOf : std::uint8_t { between, a, b };

/// Where the normal of a contact comes from, at the poses in which its points were found.
NormalOf owner(const Contact& contact, const BodySet& bodies);

}  // namespace impulse::inline IMPULSE_PRECISION
