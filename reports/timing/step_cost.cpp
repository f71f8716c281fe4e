#include "reports/timing/step_cost.h"

namespace plumb {

double step_cost(const Scene& scene, const EngineConfig& config, double dt) {
  constexpr double least_time = 1.5e-3;  // s
  double spent = 0;
  double runs = 0;
  while (spent < least_time) {
    spent += time_of_steps(scene, config, dt);
    ++runs;
  }
  return spent / (runs * static_cast<double>(steps_in(scene.duration, dt)) * dt);
}

}  // namespace plumb
