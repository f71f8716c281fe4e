// How well a scene comes to rest: when, how fast it still moves, how deep it overlaps, how far it drifts.
#include <algorithm>
#include <cmath>

#include "reports/judge/metric.h"
#include "reports/judge/overlap.h"
#include "reports/judge/states.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/vec.h"

namespace plumb::metrics::rest {
namespace {

// The part of the run, at its end, over which the residual speed is averaged.
constexpr double final_part = 0.1;

std::optional<double> settling_time(const MetricContext& context) { return time_to_rest(context.scene, context.trace); }

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

const Catalog<Metric>::Entry rest_time{
    {.name = "time_to_rest",
     .unit = "s",
     .definition = "time after which no body is faster than 0.01 m/s or 0.01 rad/s; missing if one still is at the end",
     .better = Better::neither,
     .measure = settling_time}};
const Catalog<Metric>::Entry remaining_speed{
    {.name = "residual_speed",
     .unit = "m/s",
     .definition = "RMS speed of the bodies over the last tenth of the run, in scenes with a fixed body to rest on",
     .measure = residual_speed}};

bool can_overlap(const Scene& scene) { return scene.bodies.size() > 1; }

std::optional<double> largest_penetration(const MetricContext& context) {
  if (!can_overlap(context.scene)) return std::nullopt;
  const Overlap overlap(context.scene);
  double deepest = 0;
  for (std::size_t i = 0; i < context.trace.size(); ++i) {
    deepest = std::max(deepest, overlap.deepest(context.trace.states(i)).depth);
  }
  return deepest;
}

std::optional<double> final_penetration(const MetricContext& context) {
  if (!can_overlap(context.scene)) return std::nullopt;
  return Overlap(context.scene).deepest(context.trace.states(context.trace.size() - 1)).depth;
}

const Catalog<Metric>::Entry penetration_max{
    {.name = "penetration_max",
     .unit = "m",
     .definition = "deepest overlap of two bodies that may touch, from the scene's geometry, at any recorded moment",
     .measure = largest_penetration}};
const Catalog<Metric>::Entry penetration_end{{.name = "penetration_end",
                                              .unit = "m",
                                              .definition = "deepest overlap of two bodies that may touch at the end",
                                              .measure = final_penetration}};

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

const Catalog<Metric>::Entry sideways{
    {.name = "lateral_drift",
     .unit = "m",
     .definition =
         "largest displacement of a body perpendicular to gravity from start to end, in scenes that start at rest",
     .better = Better::neither,
     .measure = lateral_drift}};

}  // namespace
}  // namespace plumb::metrics::rest
