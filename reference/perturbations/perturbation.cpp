#include "reference/perturbations/perturbation.h"

#include <stdexcept>

namespace plumb {

Engine perturbed_engine(const Perturbation& perturbation, double error) {
  Engine engine = *Catalog<Engine>::find("impulse");
  engine.name = perturbation.name;
  engine.chooses = nullptr;
  engine.unsupported = [](const Scene&, const Settings&) { return std::string(); };
  engine.build = [build = perturbation.build, error](const Scene& scene, const Settings& settings) {
    try {
      return build(scene, settings, error);
    } catch (const std::invalid_argument& refused) {
      throw std::domain_error(refused.what());
    }
  };
  return engine;
}

}  // namespace plumb
