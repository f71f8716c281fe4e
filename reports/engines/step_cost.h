#pragma once

#include <cstddef>

#include "reference/programs/line_process.h"

namespace plumb {

/// What a step of a program costs beyond the time that it says its engine took, in seconds.
struct StepCost {
  double beyond = 0;  // in all: reading the engine, writing, waking each other, reading
  double plumbs = 0;  // of it, the processor's time that Plumb took
};

/// Of the world that the program has built and not yet stepped. It steps for seconds, until it has stopped to become
/// faster: a program in JavaScript or WebAssembly is slow until it is compiled.
StepCost cost_of_step(LineProcess&, const ProgramLimits&, std::size_t bodies, double dt);

}  // namespace plumb
