#include <algorithm>

#include "reports/judge/metric.h"
#include "reports/judge/overlap.h"
#include "scenarios/catalog.h"

namespace plumb::metrics::penetration {
namespace {

bool can_overlap(const Scene& scene) { return scene.bodies.size() > 1; }

std::optional<double> largest(const MetricContext& context) {
  if (!can_overlap(context.scene)) return std::nullopt;
  const Overlap overlap(context.scene);
  double deepest = 0;
  for (std::size_t i = 0; i < context.trace.size(); ++i) {
    deepest = std::max(deepest, overlap.deepest(context.trace.states(i)).depth);
  }
  return deepest;
}

std::optional<double> at_the_end(const MetricContext& context) {
  if (!can_overlap(context.scene)) return std::nullopt;
  return Overlap(context.scene).deepest(context.trace.states(context.trace.size() - 1)).depth;
}

const Catalog<Metric>::Entry ever{
    {.name = "penetration_max",
     .unit = "m",
     .definition = "deepest overlap of two bodies that may touch, by the scene's geometry, at any recorded moment",
     .measure = largest}};
const Catalog<Metric>::Entry end{{.name = "penetration_end",
                                  .unit = "m",
                                  .definition = "deepest overlap of two bodies that may touch at the end",
                                  .measure = at_the_end}};

}  // namespace
}  // namespace plumb::metrics::penetration
