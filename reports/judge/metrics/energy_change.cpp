#include <algorithm>
#include <variant>

#include "reports/judge/conserved.h"
#include "reports/judge/energy_range.h"
#include "reports/judge/metric.h"
#include "reports/judge/observe.h"
#include "reports/vec.h"
#include "scenarios/catalog.h"

namespace plumb::metrics::energy_change {
namespace {

// What does work from outside makes a change of energy no error.
bool works_from_outside(const Scene& scene) {
  const auto pushes = [](const Force& force) { return std::holds_alternative<Constant>(force); };
  const auto drives = [](const Body& body) {
    return body.type == BodyType::kinematic && (length(body.velocity) != 0 || body.angular_velocity != 0);
  };
  return std::any_of(scene.forces.begin(), scene.forces.end(), pushes) ||
         std::any_of(scene.bodies.begin(), scene.bodies.end(), drives);
}

template <class Change>
Metric relative(const char* name, const char* definition, Better better, Change change) {
  return {.name = name,
          .unit = "1",
          .definition = definition,
          .better = better,
          .measure = [change](const MetricContext& context) -> std::optional<double> {
            const double range = energy_range(context.scene, context.truth);
            if (range == 0 || works_from_outside(context.scene)) return std::nullopt;
            const Conserved conserved(context.scene);
            return change(conserved, context.trace) / range;
          }};
}

double largest_rise(const Conserved& conserved, const Trace& trace) {
  return energy_rise(conserved, trace, trace.size() - 1).value;
}

double drift(const Conserved& conserved, const Trace& trace) {
  return conserved.energy(trace.states(trace.size() - 1)).total() - conserved.energy(trace.states(0)).total();
}

const Catalog<Metric>::Entry rise{
    relative("energy_rise", "largest rise of the total energy above an earlier value, over the scene's energy range",
             Better::lower, largest_rise)};
const Catalog<Metric>::Entry change{
    relative("energy_drift", "total energy at the end less that at the start, over the scene's energy range",
             Better::neither, drift)};

}  // namespace
}  // namespace plumb::metrics::energy_change
