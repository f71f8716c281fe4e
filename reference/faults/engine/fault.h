#pragma once

#include <string>
#include <vector>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// One of the engine's methods with a deliberate mistake, which a harness should tell from the right one. World accepts
/// its name like any method's, but solvers(), integrators() and broad_phases() do not list it, and only programs that
/// link this file contain it.
struct Fault {
  std::string name;
  std::string about;    // one line: what is wrong
  std::string source;   // where the mistake is printed; "" for one that anyone could make
  std::string mutates;  // name of the right method
  std::string kind;     // "solver", "integrator" or "broad-phase"
};

/// Adds a fault to faults().
void note(Fault fault);

/// All that are linked, sorted by name.
std::vector<Fault> faults();

}  // namespace impulse::inline IMPULSE_PRECISION
