#pragma once

#include <optional>

#include "reference/plane.h"

namespace plumb {

/// A rigid body meeting something immovable in one point.
struct Meeting {
  double mass = 0;     // kg
  double inertia = 0;  // kg m^2
  Vec normal;          // unit, out of the obstacle
  Vec arm;             // from the centre of mass to the point, m
  Vec velocity;        // of the centre of mass, m/s
  double spin = 0;     // rad/s
  double friction = 0, restitution = 0;
};

/// The impulse in N s: Newton's restitution (normal speed times -e) under Coulomb's law (|tangential| <= mu normal).
/// Nothing where the classical laws part (Newton, Poisson-Keller, Stronge): where the slip would stop or turn round
/// while normal and tangential motion are coupled; and for a point that does not approach.
std::optional<Vec> impulse(const Meeting&);

}  // namespace plumb
