#pragma once

#include <algorithm>
#include <string>
#include <utility>
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

/// Those that note() added so far, in the order of linking.
inline std::vector<Fault>& noted_faults() {
  static std::vector<Fault> list;
  return list;
}

/// Adds a fault to faults().
inline void note(Fault fault) { noted_faults().push_back(std::move(fault)); }

/// All that are linked, sorted by name.
inline std::vector<Fault> faults() {
  std::vector<Fault> sorted = noted_faults();
  std::sort(sorted.begin(), sorted.end(), [](const Fault& a, const Fault& b) { return a.name < b.name; });
  return sorted;
}

}  // namespace impulse::inline IMPULSE_PRECISION
