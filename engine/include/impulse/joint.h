#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "impulse/body.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Two bodies connected by a joint do not collide with each other. At least one of them must be dynamic. Anchors and
/// axes are given in the world frame, at the bodies' poses when the joint is created.

struct Limits {
  Real low = 0, high = 0;  // rad or m, of b relative to a, 0 at the initial poses; low <= high
};

struct Motor {
  Real speed = 0;     // rad/s or m/s, of b relative to a
  Real strength = 0;  // N m or N, maximum
};

/// A hinge: the bodies share one point.
struct RevoluteJoint {
  BodyId a, b;
  Vec2 anchor;
  std::optional<Limits> limits = {};
  std::optional<Motor> motor = {};
};

/// Keeps two points at a fixed distance; with a stiffness, connects them by a damped spring instead.
struct DistanceJoint {
  BodyId a, b;
  Vec2 anchor_a, anchor_b;
  Real length = 0;     // m
  Real stiffness = 0;  // N/m; 0 is rigid
  Real damping = 0;    // N s/m, used with a stiffness
};

/// A slider: b moves along an axis fixed in a and does not rotate relative to a.
struct PrismaticJoint {
  BodyId a, b;
  Vec2 anchor;
  Vec2 axis{1, 0};
  std::optional<Limits> limits = {};
  std::optional<Motor> motor = {};
};

/// Two bodies move as one.
struct WeldJoint {
  BodyId a, b;
  Vec2 anchor;
};

using Joint = std::variant<RevoluteJoint, DistanceJoint, PrismaticJoint, WeldJoint>;

struct JointId {
  std::uint32_t index = ~std::uint32_t{0};
  std::uint32_t generation = 0;
  friend bool operator==(const JointId&, const JointId&) = default;
};

}  // namespace impulse::inline IMPULSE_PRECISION
