#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "impulse/body.h"

namespace impulse::inline IMPULSE_PRECISION {

/// One point of a touching pair after the last step.
struct ContactInfo {
  BodyId a, b;
  Vec2 point;                // world frame
  Vec2 normal;               // unit, from a to b
  Real separation = 0;       // m, negative when they overlap
  Real normal_impulse = 0;   // N s on b along the normal, summed over the last step
  Real tangent_impulse = 0;  // N s on b along perpendicular(normal), summed over the last step
};

/// Two parts that touched during a step: they overlapped at its start or exchanged an impulse.
struct TouchingParts {
  BodyId a, b;
  std::uint16_t part_a = 0, part_b = 0;  // indices into Body::parts()
  Vec2 point;                            // world frame, mean of the contact points
  Vec2 normal;                           // unit, from a to b
  Real normal_impulse = 0;               // N s on b along the normal, summed over all points and the step
  Real tangent_impulse = 0;              // N s on b along perpendicular(normal), likewise
};

/// Contacts that began or ended in the last step, sorted by bodies and parts. The spans are valid until the next step.
struct ContactEvents {
  std::span<const TouchingParts> begun;     // did not touch in the step before
  std::span<const TouchingParts> touching;  // all, including those that begun
  /// No longer touching; holds their last contact. The contacts of a destroyed or removed body end in the next step:
  /// check contains() before using its handle.
  std::span<const TouchingParts> ended;
};

/// One part of a body.
struct PartId {
  BodyId body;
  std::uint16_t part = 0;  // index into Body::parts()
  friend bool operator==(const PartId&, const PartId&) = default;
};

/// A sensor and a part of another body, not itself a sensor, that touch or overlap at the end of a step.
struct SensorOverlap {
  PartId sensor, visitor;
};

/// What began and stopped overlapping sensors in the last step, sorted by sensors and visitors. The spans are valid
/// until the next step.
struct SensorEvents {
  std::span<const SensorOverlap> begun;
  std::span<const SensorOverlap> overlapping;  // all, including those that begun
  /// Overlaps with a destroyed or removed body end in the next step: check contains() before using its handle.
  std::span<const SensorOverlap> ended;
};

/// Whether two parts may collide. Must not throw, and always give the same answer for the same two parts.
using PartFilter = std::function<bool(PartId a, PartId b)>;

/// A contact before it is solved. What a callback changes holds for this step only.
struct PreSolveContact {
  BodyId a, b;
  std::uint16_t part_a = 0, part_b = 0;  // indices into Body::parts()
  Vec2 point;                            // world frame, mean of the contact points
  Vec2 normal;                           // unit, from a to b
  Real separation = 0;                   // m, of the nearest point; negative when they overlap

  bool enabled = true;                             // if not, the two parts pass through each other in this step
  Real static_friction = 0, dynamic_friction = 0;  // Coulomb coefficients, 0 <= dynamic <= static
  Real restitution = 0;                            // 0 ... 1
};

/// Must not throw.
using PreSolve = std::function<void(PreSolveContact& contact)>;

}  // namespace impulse::inline IMPULSE_PRECISION
