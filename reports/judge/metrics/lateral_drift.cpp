#include <algorithm>
#include <cmath>

#include "reports/judge/metric.h"
#include "reports/vec.h"
#include "scenarios/catalog.h"

namespace plumb::metrics::lateral_drift {
namespace {

bool starts_at_rest(const Scene& scene) {
  return std::all_of(scene.bodies.begin(), scene.bodies.end(),
                     [](const Body& body) { return body.velocity == Vec{} && body.angular_velocity == 0; });
}

std::optional<double> lateral_drift(const MetricContext& context) {
  const Scene& scene = context.scene;
  if (scene.gravity == Vec{} || !starts_at_rest(scene)) return std::nullopt;
  const Vec down = 1 / length(scene.gravity) * scene.gravity;
  const auto start = context.trace.states(0);
  const auto end = context.trace.states(context.trace.size() - 1);
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
}  // namespace plumb::metrics::lateral_drift
