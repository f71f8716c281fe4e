#pragma once

#include "reports/run/run.h"

namespace plumb {

/// s of stepping for a simulated second: of one repetition, which runs the scene as often as it takes for a clock's
/// grain and an interrupt to drown in it. The config must be able to run it.
double step_cost(const Scene&, const EngineConfig&, double dt);

}  // namespace plumb
