#pragma once

#include <memory>
#include <string>

#include "reference/simulation.h"

/// A deliberate slowdown, to measure how well the timing gate detects one. Only test programs link it.
namespace plumb {

/// The environment variable that holds the delay, in percent of the CPU time of a step.
constexpr const char* delay_variable = "PLUMB_INJECTED_DELAY";

/// Wraps a simulation so that its steps take that much longer. Steps below 0.5 us may take up to 5 % more on top, the
/// cost of reading the clock. Returns the simulation itself unless the variable holds a number above 0.
std::unique_ptr<Simulation> with_injected_delay(std::unique_ptr<Simulation>);

/// Makes the engine of that name in the catalog build its simulations with the injected delay.
void delay_engine(const std::string& name);

}  // namespace plumb
