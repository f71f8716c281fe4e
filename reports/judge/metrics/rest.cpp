#include <algorithm>
#include <cmath>

#include "reports/judge/metric.h"
#include "reports/judge/still.h"
#include "reports/vec.h"
#include "scenarios/catalog.h"

namespace plumb::metrics::rest {
namespace {

// The share of the run, at its end, over which what is left of motion is averaged.
constexpr double final_part = 0.1;

bool has_something_to_rest_on(const Scene& scene) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(),
                     [](const Body& body) { return body.type == BodyType::fixed && !body.shapes.empty(); });
}

bool all_still(const Scene& scene, std::span<const BodyState> states) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (scene.bodies[i].type == BodyType::dynamic && !is_still(states[i])) return false;
  }
  return true;
}

std::optional<double> time_to_rest(const MetricContext& context) {
  if (!has_something_to_rest_on(context.scene)) return std::nullopt;
  std::size_t first = context.trace.size();
  while (first > 0 && all_still(context.scene, context.trace.states(first - 1))) --first;
  if (first == context.trace.size()) return std::nullopt;
  return context.trace.time(first);
}

std::optional<double> residual_speed(const MetricContext& context) {
  if (!has_something_to_rest_on(context.scene)) return std::nullopt;
  const double from = (1 - final_part) * context.trace.times().back();
  double squares = 0;
  double count = 0;
  for (std::size_t moment = context.trace.size(); moment-- > 0 && context.trace.time(moment) >= from;) {
    const auto states = context.trace.states(moment);
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (context.scene.bodies[i].type != BodyType::dynamic) continue;
      squares += dot(states[i].velocity, states[i].velocity);
      ++count;
    }
  }
  if (count == 0) return std::nullopt;
  return std::sqrt(squares / count);
}

const Catalog<Metric>::Entry when{
    {.name = "time_to_rest",
     .unit = "s",
     .definition = "from when on no body is faster than 0.01 m/s or 0.01 rad/s; nothing if one still is at the end",
     .better = Better::neither,
     .measure = time_to_rest}};
const Catalog<Metric>::Entry residual{
    {.name = "residual_speed",
     .unit = "m/s",
     .definition = "RMS speed of the bodies over the last tenth of the run, where there is something to rest on",
     .measure = residual_speed}};

}  // namespace
}  // namespace plumb::metrics::rest
