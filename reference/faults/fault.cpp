#include "reference/faults/fault.h"

#include <algorithm>

#include "reference/adapters/impulse_world.h"

namespace plumb {
namespace {

const Engine& our_engine() { return *Catalog<Engine>::find("impulse"); }

Engine variant_of_ours(const std::string& name, BuildSimulation build) {
  Engine made = our_engine();
  made.name = name;
  made.build = std::move(build);
  made.chooses = nullptr;
  return made;
}

}  // namespace

std::vector<Fault> all_faults() {
  std::vector<Fault> all;
  for (const Fault* fault : Catalog<Fault>::all()) all.push_back(*fault);
  for (const FaultSource* source : Catalog<FaultSource>::all()) {
    for (Fault& fault : source->faults()) all.push_back(std::move(fault));
  }
  std::sort(all.begin(), all.end(), [](const Fault& a, const Fault& b) { return a.name < b.name; });
  return all;
}

Settings settings_of(const Fault& fault) { return complete(our_engine(), fault.method); }

Engine right_engine(const Fault& fault) {
  return variant_of_ours("impulse", fault.right == nullptr ? build_ours : fault.right);
}

Engine faulty_engine(const Fault& fault) { return variant_of_ours(fault.name, fault.build); }

std::unique_ptr<Simulation> build_ours(const Scene& scene, const Settings& settings) {
  return double_precision::impulse_engine().build(scene, settings);
}

}  // namespace plumb
