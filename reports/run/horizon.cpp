#include "reports/run/horizon.h"

#include <algorithm>
#include <cmath>

#include "reference/scene_facts.h"
#include "reports/vec.h"
#include "scenarios/transformed.h"

namespace plumb {
namespace {

// Differences grow by the same factor a second whatever their direction, but one direction may begin as the one that
// shrinks.
constexpr int neighbours = 2;

bool far(const Scene& scene, std::span<const BodyState> a, std::span<const BodyState> b, double limit) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].type == BodyType::dynamic && !(length(a[i].position - b[i].position) <= limit)) return true;
  }
  return false;
}

}  // namespace

double smallest_difference(const Scene& scene, const Stepping& stepping) {
  constexpr double billionth = 1e-9;  // m
  double farthest = 0;
  for (const Body& body : scene.bodies) {
    if (body.type == BodyType::dynamic) farthest = std::max(farthest, length(body.position));
  }
  return std::max(billionth, 8 * stepping.epsilon * farthest);
}

double parted_by(const Scene& scene) { return 0.1 * smallest_body(scene); }

std::optional<double> horizon_of(const Scene& scene, const EngineConfig& config, double dt, const Trace& trace) {
  const double size = smallest_difference(scene, config.engine->stepping(config.settings, dt));
  std::optional<double> horizon;
  for (int seed = 1; seed <= neighbours; ++seed) {
    const Outcome other = run(perturbed(scene, size, static_cast<std::uint64_t>(seed)), config, dt);
    if (!other.trace) continue;
    const std::size_t both = std::min(trace.size(), other.trace->size());
    for (std::size_t moment = 0; moment < both; ++moment) {
      if (horizon && trace.time(moment) >= *horizon) break;
      if (!far(scene, trace.states(moment), other.trace->states(moment), parted_by(scene))) continue;
      horizon = trace.time(moment);
      break;
    }
  }
  return horizon;
}

}  // namespace plumb
