#pragma once

#include "scenarios/scene/scene.h"

namespace plumb {

/// Mass properties computed from shapes and densities alone, independently of every engine.
struct Mass {
  double mass = 0;     // kg; 0 for fixed and kinematic bodies
  double inertia = 0;  // kg m^2 about the centre of mass; also 0 with fixed rotation
  Vec center;          // of mass, in the body frame; the origin if there is no mass
};

/// The sum over the shapes, moved to the common centre by the parallel-axis theorem.
Mass mass_of(const Body&);

}  // namespace plumb
