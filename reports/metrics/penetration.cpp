#include <algorithm>

#include "reports/metric.h"
#include "reports/overlap.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

bool can_overlap(const Scene& scene) { return scene.bodies.size() > 1; }

std::optional<double> largest(const Evidence& evidence) {
  if (!can_overlap(evidence.scene)) return std::nullopt;
  const Overlap overlap(evidence.scene);
  double deepest = 0;
  for (std::size_t i = 0; i < evidence.trace.size(); ++i) {
    deepest = std::max(deepest, overlap.deepest(evidence.trace.states(i)).depth);
  }
  return deepest;
}

std::optional<double> at_the_end(const Evidence& evidence) {
  if (!can_overlap(evidence.scene)) return std::nullopt;
  return Overlap(evidence.scene).deepest(evidence.trace.states(evidence.trace.size() - 1)).depth;
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
}  // namespace plumb
