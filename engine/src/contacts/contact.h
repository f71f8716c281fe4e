#pragma once

#include <array>
#include <cstdint>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// What a pair of shapes reports: up to two points along one normal.
struct ManifoldPoint {
  Vec2 point;                 // midway between the two surfaces; frame as the manifold's
  Real separation = 0;        // m, along the normal; negative when they overlap
  std::uint32_t feature = 0;  // which edge and vertex made it; equal from step to step while the contact is the same
};

struct Manifold {
  Vec2 normal;  // unit, from a to b
  int count = 0;
  std::array<ManifoldPoint, 2> points;
};

/// Kernels read its numbers in rows of four.
struct ContactPoint {
  Vec2 arm_a, arm_b;              // from each centre of mass to the point, world frame
  Real normal_impulse = 0;        // N s: what the last step ended with (warm start), for a step of dt
  Real tangent_impulse = 0;       // along perpendicular(normal)
  Real total_normal_impulse = 0;  // N s over the whole step, sub-steps and events included: for the outside
  Real total_tangent_impulse = 0;
  Real separation = 0;  // m, when it was found
  std::uint32_t feature = 0;
  bool fresh = true;  // was not there in the last step
};

/// Two touching (or nearly touching) shapes of two bodies. Rows are sorted by (body_a, body_b, part_a, part_b) with
/// body_a < body_b, whatever broad phase found them, so that results never depend on which. Kernels read numbers in
/// rows of four: from the normal, from the friction, of poses, of points.
struct Contact {
  std::uint32_t body_a = 0, body_b = 0;
  std::uint16_t part_a = 0, part_b = 0;
  int count = 0;
  Vec2 normal;                             // unit, from a to b
  std::array<Real, 2> found_separation{};  // m, of each point when it was found
  Real static_friction = 0, dynamic_friction = 0;
  Real radius_a = 0, radius_b = 0;  // m, by which the shapes are rounded
  Real restitution = 0;
  Real offset = 0;                      // m, for solvers that keep a standing correction of the separation
  int age = 0;                          // steps since it began
  bool disc_a = false, disc_b = false;  // a circle about its body's centre of mass
  Pose found_a, found_b;                // of the bodies when points and separations were found
  std::array<ContactPoint, 2> points;

  bool discs() const { return disc_a && disc_b; }
};

}  // namespace impulse::inline IMPULSE_PRECISION
