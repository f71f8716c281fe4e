#include "reports/judge/conserved.h"
#include "reports/judge/metric.h"
#include "scenarios/catalog.h"

namespace plumb::metrics::energy {
namespace {

template <class Part>
Metric at_the_end(const char* name, const char* definition, Part part) {
  return {.name = name,
          .unit = "J",
          .definition = definition,
          .better = Better::neither,
          .measure = [part](const MetricContext& context) -> std::optional<double> {
            return part(Conserved(context.scene).energy(context.trace.states(context.trace.size() - 1)));
          }};
}

const Catalog<Metric>::Entry linear{
    at_the_end("kinetic_energy_end", "sum of m v^2/2 at the end", [](const Energy& energy) { return energy.linear; })};
const Catalog<Metric>::Entry rotational{at_the_end("rotational_energy_end", "sum of I w^2/2 at the end",
                                                   [](const Energy& energy) { return energy.rotational; })};
const Catalog<Metric>::Entry potential{at_the_end("potential_energy_end",
                                                  "potential of gravity (-m g.r), springs and attractions at the end",
                                                  [](const Energy& energy) { return energy.potential; })};

}  // namespace
}  // namespace plumb::metrics::energy
