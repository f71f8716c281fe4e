#pragma once

#include "scenarios/scene/scene.h"

namespace plumb {

/// Mass properties that follow from shapes and densities alone; no engine is asked.
struct Mass {
  double mass = 0;     // kg; 0 for fixed and kinematic bodies: immovable
  double inertia = 0;  // kg m^2 about the centre of mass; 0 with fixed rotation too
  Vec center;          // of mass, body frame; its origin where there is no mass
};

/// Sources: disc m r^2/2, rectangle m (w^2+h^2)/12, polygon by Green's theorem, capsule as rectangle and two half
/// discs, all moved to the common centre by the parallel-axis theorem. Segments and half-spaces have no area and so no
/// mass.
Mass mass_of(const Body&);

}  // namespace plumb
