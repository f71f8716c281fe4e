#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "impulse/body.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Bodies that a joint ties do not collide with each other. At least one of the two must be dynamic. Anchors and axes
/// are given in the world frame, as the bodies stand when the joint is created.

struct Limits {
  Real low = 0, high = 0;  // rad or m, of b against a, 0 as the bodies stand at creation; low <= high
};

struct Motor {
  Real speed = 0;     // rad/s or m/s, of b against a
  Real strength = 0;  // N m or N, the most it gives
};

/// A hinge: one point in common.
struct RevoluteJoint {
  BodyId a, b;
  Vec2 anchor;
  std::optional<Limits> limits = {};
  std::optional<Motor> motor = {};
};

/// Two points a fixed length apart; with a stiffness, a damped spring of that length instead.
struct DistanceJoint {
  BodyId a, b;
  Vec2 anchor_a, anchor_b;
  Real length = 0;     // m
  Real stiffness = 0;  // N/m; 0 is rigid
  Real damping = 0;    // N s/m, with a stiffness
};

/// A slider: b moves along an axis fixed in a and does not turn against it.
struct PrismaticJoint {
  BodyId a, b;
  Vec2 anchor;
  Vec2 axis{1, 0};
  std::optional<Limits> limits = {};
  std::optional<Motor> motor = {};
};

/// Two bodies as one.
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
