#pragma once

#include <string>
#include <vector>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// One of the engine's methods with a mistake made on purpose, for a harness to tell from the right one. World takes
/// its name as it takes any method's; solvers(), integrators() and broad_phases() do not offer it, and the engine that
/// games get does not hold it.
struct Fault {
  std::string name;
  std::string about;   // one line: what is wrong
  std::string source;  // where the mistake comes from; "" where anyone could make it
  std::string spoils;  // the right method
  std::string kind;    // "solver", "integrator" or "broad-phase"
};

/// All that are linked, sorted by name.
std::vector<Fault> faults();

}  // namespace impulse::inline IMPULSE_PRECISION
