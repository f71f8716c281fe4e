#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "reference/simulation.h"

/// Our own engine with a mistake made on purpose: what a harness is for is to tell it from the right one.
namespace plumb {

using BuildSimulation = std::function<std::unique_ptr<Simulation>(const Scene&, const Settings&)>;

struct Fault {
  std::string name;
  std::string about;   // one line: what is wrong
  std::string source;  // where the mistake comes from, as "row 18" of the seed's list; "" where anyone could make it
  Settings method;     // of our engine: what it spoils; "{}" the default
  BuildSimulation build;
  BuildSimulation right = nullptr;  // what it is held against; null: our engine as it is
};

/// Faults of the question, the reading and the engine, sorted by name.
std::vector<Fault> all_faults();

/// The complete settings of the right method.
Settings settings_of(const Fault&);

/// Two engines that differ in the fault alone; both state the errors of the right method.
Engine right_one(const Fault&);
Engine faulty_one(const Fault&);

/// Joins the catalogue many at a time: what the engine brings.
struct FaultSource {
  std::string name;
  std::vector<Fault> (*faults)();
};

/// Our engine as it is, in double precision.
std::unique_ptr<Simulation> build_ours(const Scene&, const Settings&);

}  // namespace plumb
