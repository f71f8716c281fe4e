#pragma once

#include <cstdint>
#include <limits>
#include <variant>

#include "impulse/body.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Accelerates every other dynamic body towards the centre of mass of `from` by strength / r^exponent: the article's
/// heavy object. Bodies exactly at that centre are not accelerated.
struct Attraction {
  BodyId from;
  Real strength = 0;    // m^(1 + exponent)/s^2; negative repels
  Real exponent = 2;    // a multiple of 1/2 from -16 to 16, so that powers need only products and square roots
  bool mutual = false;  // whether the opposite forces act on `from`
  Real reach = std::numeric_limits<Real>::infinity();  // m, bodies farther away are not accelerated
};

/// Pulls two anchors together with the force stiffness (distance - length) + damping d(distance)/dt. If one of the
/// bodies is BodyId{}, its anchor is a point in the world.
struct Spring {
  BodyId a, b;
  Vec2 anchor_a, anchor_b;  // body frame; world frame for BodyId{}
  Real stiffness = 0;       // N/m
  Real length = 0;          // m, rest length
  Real damping = 0;         // N s/m
};

struct ConstantForce {
  BodyId body;
  Vec2 force;       // N at the centre of mass, world frame
  Real torque = 0;  // N m
};

/// A force that acts in every step until it is removed. A body that is not in the world neither exerts nor feels it.
using Force = std::variant<Attraction, Spring, ConstantForce>;

struct ForceId {
  std::uint32_t index = ~std::uint32_t{0};
  std::uint32_t generation = 0;
  friend bool operator==(const ForceId&, const ForceId&) = default;
};

}  // namespace impulse::inline IMPULSE_PRECISION
