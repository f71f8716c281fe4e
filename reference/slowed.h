#pragma once

#include <memory>

#include "reference/simulation.h"

namespace plumb {

/// The environment variable that asks for the fault below.
constexpr const char* slowdown_variable = "PLUMB_SLOWDOWN";

/// A fault for the proof of the timing gate: where slowdown_variable holds a percentage, steps
/// take that much longer; those of less than 0.5 us up to some 5 % more, since the clock must be read. Anything else
/// than a number above 0: the simulation itself, which then costs nothing more.
std::unique_ptr<Simulation> slowed(std::unique_ptr<Simulation>);

}  // namespace plumb
