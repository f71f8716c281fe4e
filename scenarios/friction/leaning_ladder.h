#pragma once

#include <vector>

#include "scenarios/scenario.h"

namespace plumb {

/// A ladder at rest between a rough floor and a smooth wall; sharp at both ends, so that it touches in two points of
/// its axis. angle rad above the level; duration s.
Scene leaning_ladder(double angle, double friction, double duration);

/// Angle and place of the ladder at a time, s, at most `latest`, at which its head is still at the wall.
std::vector<Expectation> leaning_ladder_expectations(double angle, double friction, double latest);

/// What a ladder's mass counts with against turning about both ends, m^2: I/m + (L/2)^2; and half its length, m.
double ladder_gyration();
double ladder_half();

}  // namespace plumb
