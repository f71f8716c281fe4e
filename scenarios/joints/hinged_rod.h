#pragma once

#include <vector>

#include "scenarios/scenario.h"

namespace plumb {

/// A rod hinged at its end to the world and let go at rest: a pendulum, or, from near upright, a tower that topples.
/// length m; angle rad against the downward vertical; duration s.
Scene hinged_rod(double length, double angle, double duration);

/// Angle, place and energy of the rod at the end.
std::vector<Expectation> hinged_rod_expectations(double length, double angle, double duration);

}  // namespace plumb
