#pragma once

#include <memory>

#include "reference/simulation.h"

/// Kinematic bodies on paths, for every engine alike.
namespace plumb {

/// The simulation, with the bodies of the scene that have a path driven along it: before each step they are given the
/// velocity (x(t + dt) - x(t))/dt, so that they are where they should be after it. Within a step they move straight, at
/// most a dt^2/8 beside their path and a dt/2 beside its velocity, a = amplitude (2 pi frequency)^2. Without paths it
/// is the simulation itself. `build` of every engine ends with this.
std::unique_ptr<Simulation> on_paths(const Scene&, std::unique_ptr<Simulation>);

}  // namespace plumb
