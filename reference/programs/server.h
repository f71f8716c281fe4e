#pragma once

#include "reference/simulation.h"

namespace plumb {

/// The other side of plumb-engine 1: answers on standard output what is asked on standard input, by an engine of this
/// program, until it is told to end. What the engine prints goes to standard error. Returns the exit code.
int serve(const Engine&);

}  // namespace plumb
