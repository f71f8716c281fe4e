#pragma once

#include <memory>
#include <string>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/scene/scene.h"

namespace plumb {

/// Our engine as compiled for one precision. The settings it is given are complete.
struct ImpulseEngine {
  std::vector<Option> (*options)();  // as the engine itself names and sets them
  Stepping (*stepping)(const Settings&, double dt);
  std::string (*unsupported)(const Scene&, const Settings&);
  std::unique_ptr<Simulation> (*build)(const Scene&, const Settings&);
};

// impulse_world.cpp is compiled twice, once into each.
namespace single_precision {
ImpulseEngine impulse_engine();
}
namespace double_precision {
ImpulseEngine impulse_engine();
}

}  // namespace plumb
