#include <cmath>
#include <utility>

#include "reports/study/stability/map.h"

namespace plumb::maps::restitution {
namespace {

constexpr double height = 4;    // m
constexpr double radius = 0.5;  // m
constexpr double gravity = 10;  // m/s^2
constexpr int phases = 4;       // of a step, in which impacts fall

// Apex n is at e^(2n) h. Moments dt apart show it g dt^2/8 too low at most, and never too high. Noticed a step late,
// the disc may be as deep as it falls in that.
Watch bounces_wrong(double dt, double e) {
  constexpr double tolerance = 0.1 * height;  // m
  const double deepest = (std::sqrt(2 * gravity * height) + gravity * dt) * dt + radius;
  return {
      "gains energy: a bounce is higher than restitution allows by more than a tenth of the drop; sinks: the disc is "
      "in the ground, by more than its radius and its way in a step",
      [=, apex = height, falling = true, before = height](const Moment& now) mutable {
        const double y = now.states[1].position.y - radius;
        const bool was_falling = std::exchange(falling, y < before || (falling && y == before));
        if (was_falling && !falling) apex *= e * e;  // it has turned round
        before = y;
        if (y > apex + tolerance) return std::optional(Symptom{Fate::gains_energy, 1});
        return y < -deepest ? std::optional(Symptom{Fate::sinks, 1}) : std::nullopt;
      }};
}

std::vector<Trial> trials(double dt, double e, const EngineConfig&) {
  const auto scene = std::make_shared<const Scene>(scene_of("bounce", {{"restitution", e}, {"height", height}}));
  std::vector<Trial> all;
  for (int k = 1; k <= phases; ++k) {
    const double first_step = static_cast<double>(k) / phases;
    all.push_back({.scene = scene, .dt = dt, .first_step = first_step, .watches = {bounces_wrong(dt, e)}});
  }
  return all;
}

const Catalog<StabilityMap>::Entry entry{
    {.name = "restitution",
     .question = "Up to which step does a disc never bounce higher than its restitution says?",
     .x = {.name = "dt", .unit = "s", .from = 1.0 / 480, .to = 0.2, .logarithmic = true},
     .y = Axis{.name = "restitution", .from = 0.3, .to = 1},
     .typical = 0.8,
     .trials = trials,
     .boundaries = {{.name = "bounces", .grain = 0.01}}}};

}  // namespace
}  // namespace plumb::maps::restitution
