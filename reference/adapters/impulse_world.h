#pragma once

#include <memory>
#include <string>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/scene/scene.h"

namespace plumb {

/// Our engine compiled for one precision. All settings passed to it must be complete.
struct ImpulseEngine {
  std::vector<Option> (*options)();  // with the names and defaults of the engine
  Stepping (*stepping)(const Settings&, double dt);
  std::string (*unsupported)(const Scene&, const Settings&);
  std::unique_ptr<Simulation> (*build)(const Scene&, const Settings&);
};

// impulse_world.cpp is compiled once into each of these.
namespace single_precision {
ImpulseEngine impulse_engine();
}
namespace double_precision {
ImpulseEngine impulse_engine();
}

}  // namespace plumb
