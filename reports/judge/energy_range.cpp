#include "reports/judge/energy_range.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/judge/conserved.h"
#include "reports/judge/outline.h"
#include "reports/vec.h"

namespace plumb {
namespace {

// The extent of all dynamic bodies along gravity, m.
double height_of(const Scene& scene, Vec down, const std::vector<BodyState>& start, std::span<const Mass> masses) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Interval all{infinity, -infinity};
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (masses[i].mass == 0) continue;
    for (const Shape& shape : scene.bodies[i].shapes) {
      const auto one =
          range_along(down, placed(outline_of(shape.geometry, masses[i].center), start[i].position, start[i].angle));
      if (one) all = {std::min(all.low, one->low), std::max(all.high, one->high)};
    }
  }
  return std::max(0.0, all.high - all.low);
}

}  // namespace

double energy_range(const Scene& scene, const Trace* truth) {
  const Conserved conserved(scene);
  const std::vector<BodyState> start = initial_states(scene);
  const Energy energy = conserved.energy(start);
  double weight = 0;      // N, all that gravity pulls with
  double by_gravity = 0;  // J, its part of the potential energy
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const double pull = conserved.masses()[i].mass * scene.bodies[i].gravity_scale;
    weight += std::abs(pull) * length(scene.gravity);
    by_gravity -= pull * dot(scene.gravity, start[i].position);
  }
  double range = energy.kinetic() + std::abs(energy.potential - by_gravity);
  if (weight > 0) {
    const Vec down = 1 / length(scene.gravity) * scene.gravity;
    range += weight * height_of(scene, down, start, conserved.masses());
  }
  for (std::size_t i = 0; truth != nullptr && i < truth->size(); ++i) {
    range = std::max(range, conserved.energy(truth->states(i)).kinetic());
  }
  return range;
}

}  // namespace plumb
