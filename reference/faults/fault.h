#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "reference/simulation.h"

/// Our own engine with a deliberate mistake. The harness proves itself by telling it from the right engine.
namespace plumb {

using BuildSimulation = std::function<std::unique_ptr<Simulation>(const Scene&, const Settings&)>;

struct Fault {
  std::string name;
  std::string about;   // one line: what is wrong
  std::string source;  // the part of the article that invites the mistake; "" if it comes from elsewhere
  Settings method;     // settings of our engine that select the mutated method; empty for the default
  BuildSimulation build;
  BuildSimulation right = nullptr;  // what it is compared with; null for our engine as it is
};

/// All faults, sorted by name.
std::vector<Fault> all_faults();

/// The complete settings of the right method.
Settings settings_of(const Fault&);

/// Two engines that differ only by the fault. Both state the errors of the right method.
Engine right_engine(const Fault&);
Engine faulty_engine(const Fault&);

/// Adds many faults to the catalog at once.
struct FaultSource {
  std::string name;
  std::vector<Fault> (*faults)();
};

/// Our engine as it is, in double precision.
std::unique_ptr<Simulation> build_ours(const Scene&, const Settings&);

}  // namespace plumb
