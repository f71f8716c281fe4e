#include "reports/judge/still.h"

#include <cmath>

#include "reports/vec.h"

namespace plumb {

bool is_still(const BodyState& state) {
  return length(state.velocity) <= still_speed && std::abs(state.angular_velocity) <= still_spin;
}

double still_bodies(const Scene& scene, std::span<const BodyState> states) {
  double count = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (scene.bodies[i].type == BodyType::dynamic && is_still(states[i])) ++count;
  }
  return count;
}

}  // namespace plumb
