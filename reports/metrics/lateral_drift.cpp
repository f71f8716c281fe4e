#include <algorithm>
#include <cmath>

#include "reports/metric.h"
#include "reports/vec.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

bool starts_at_rest(const Scene& scene) {
  return std::all_of(scene.bodies.begin(), scene.bodies.end(),
                     [](const Body& body) { return body.velocity == Vec{} && body.angular_velocity == 0; });
}

std::optional<double> lateral_drift(const Evidence& evidence) {
  const Scene& scene = evidence.scene;
  if (scene.gravity == Vec{} || !starts_at_rest(scene)) return std::nullopt;
  const Vec down = 1 / length(scene.gravity) * scene.gravity;
  const auto start = evidence.trace.states(0);
  const auto end = evidence.trace.states(evidence.trace.size() - 1);
  double largest = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].type != BodyType::dynamic) continue;
    largest = std::max(largest, std::abs(cross(down, end[i].position - start[i].position)));
  }
  return largest;
}

const Catalog<Metric>::Entry entry{
    {.name = "lateral_drift",
     .unit = "m",
     .definition = "farthest that a body ends up across gravity from where it began, in a scene that starts at rest",
     .better = Better::neither,
     .measure = lateral_drift}};

}  // namespace
}  // namespace plumb
