#include "reference/faults/altered_engine.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

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

std::unique_ptr<Simulation> build_ours(const Scene& scene, const Settings& settings) {
  return double_precision::impulse_engine().build(scene, settings);
}

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

Engine engine_of(const Control& control) {
  Engine made = variant_of_ours(control.name, control.build);
  made.about = control.about;
  return made;
}

Control in_altered_scene(std::string name, std::string about, void (*alter)(Scene&)) {
  return {.name = std::move(name), .about = std::move(about), .build = [alter](Scene scene, const Settings& settings) {
            alter(scene);
            return build_ours(scene, settings);
          }};
}

Engine perturbed_engine(const Perturbation& perturbation, double error) {
  Engine made = variant_of_ours(perturbation.name,
                                [build = perturbation.build, error](const Scene& scene, const Settings& settings) {
                                  try {
                                    return build(scene, settings, error);
                                  } catch (const std::invalid_argument& refused) {
                                    throw std::domain_error(refused.what());
                                  }
                                });
  made.unsupported = [](const Scene&, const Settings&) { return std::string(); };
  return made;
}

}  // namespace plumb
