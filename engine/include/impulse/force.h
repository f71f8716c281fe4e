#pragma once

#include <cstdint>
#include <limits>
#include <variant>

#include "impulse/body.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Every other dynamic body is accelerated towards the centre of `from` by strength / r^exponent: the article's heavy
/// object. Bodies whose centres coincide with it feel nothing.
struct Attraction {
  BodyId from;
  Real strength = 0;    // m^(1 + exponent)/s^2; negative repels
  Real exponent = 2;    // a multiple of 1/2 from -16 to 16, so that the power is made of products and roots alone
  bool mutual = false;  // `from` feels the opposite forces
  Real reach = std::numeric_limits<Real>::infinity();  // m, bodies farther away feel nothing (`CloseEnoughTo`)
};

/// Pulls two anchors together with stiffness (distance - length) + damping d(distance)/dt. With BodyId{} for one of the
/// bodies, its anchor is a point of the world.
struct Spring {
  BodyId a, b;
  Vec2 anchor_a, anchor_b;  // frame of the body; world frame where there is none
  Real stiffness = 0;       // N/m
  Real length = 0;          // m, at which it pulls nothing
  Real damping = 0;         // N s/m
};

struct ConstantForce {
  BodyId body;
  Vec2 force;       // N at the centre of mass, world frame
  Real torque = 0;  // N m
};

/// What acts on bodies in every step until it is removed. A body that is taken out of the world neither exerts nor
/// feels it.
using Force = std::variant<Attraction, Spring, ConstantForce>;

struct ForceId {
  std::uint32_t index = ~std::uint32_t{0};
  std::uint32_t generation = 0;
  friend bool operator==(const ForceId&, const ForceId&) = default;
};

}  // namespace impulse::inline IMPULSE_PRECISION
