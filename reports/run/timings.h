#pragma once

#include <span>
#include <vector>

#include "reports/run/run.h"

/// What steps cost: engine configurations timed on scenes.
namespace plumb {

/// The time of a step of each configuration, repeated in rounds. The configurations must be able to run the case: times
/// of a failed run mean nothing. Throws std::runtime_error if one fails.
std::vector<Timing> time_configs(const Case&, std::span<const EngineConfig>, double dt);

/// The time of one repetition, in s of stepping per simulated second. A repetition runs the scene as often as needed to
/// make the resolution of the clock and single interrupts negligible. The configuration must be able to run it. Throws
/// std::runtime_error if it fails.
double step_cost(const Scene&, const EngineConfig&, double dt);

}  // namespace plumb
