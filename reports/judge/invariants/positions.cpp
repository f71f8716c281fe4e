// Where bodies may be: not deep inside each other, and where they were once they have come to rest.
#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "reports/judge/contacts.h"
#include "reports/judge/invariant.h"
#include "reports/judge/overlap.h"
#include "reports/judge/rounding.h"
#include "reports/judge/states.h"
#include "reports/vec.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/mass.h"

namespace plumb::invariants::positions {
namespace {

// A pair may overlap by the gap that the method states, by the depth at the start of the scene, and by the distance
// that two bodies approach before an impact is noticed: lag h (V_a + V_b), V the largest speed of any point of a body
// so far. How fast a method pushes them apart again is not judged.
std::optional<InvariantCheck> check_overlap(const InvariantContext& context) {
  const auto& [scene, trace, stepping] = context;
  if (scene.bodies.size() < 2) return std::nullopt;
  const Overlap overlap(scene);
  const double nu = trace_rounding(trace, stepping);
  const double at_start = overlap.deepest(trace.states(0)).depth;
  std::vector<double> radii;
  for (const Body& body : scene.bodies) radii.push_back(bounding_radius(body));
  std::vector<double> fastest(scene.bodies.size());
  std::vector<double> farthest(scene.bodies.size());
  WorstViolation worst;
  for (std::size_t moment = 0; moment < trace.size(); ++moment) {
    const auto states = trace.states(moment);
    for (std::size_t i = 0; i < states.size(); ++i) {
      fastest[i] = std::max(fastest[i], length(states[i].velocity) + radii[i] * std::abs(states[i].angular_velocity));
      farthest[i] = std::max(farthest[i], length(states[i].position) + radii[i] * (1 + std::abs(states[i].angle)));
    }
    for (const BodyOverlap& pair : overlap.all(states)) {
      const double rounded =
          farthest[pair.a] + farthest[pair.b] + trace.times().back() / 2 * (fastest[pair.a] + fastest[pair.b]);
      const double late = stepping.impact_lag * stepping.h * (fastest[pair.a] + fastest[pair.b]);
      worst.add(pair.depth, stepping.contact_gap() + at_start + late + nu * rounded, trace.time(moment),
                [&] { return pair_name(context.scene, pair.a, pair.b); });
    }
  }
  return worst.result();
}

constexpr double settling_time = 1;  // s, for which all bodies must have been still

// Whether still bodies of the scene are at rest: they lie on their faces and friction holds them. A disc may roll as
// slowly as it likes, a pendulum may swing and a spring may pull.
bool stays_where_it_rests(const Scene& scene) {
  const auto stays = [](const Body& body) {
    if (body.type == BodyType::kinematic) return false;
    return std::all_of(body.shapes.begin(), body.shapes.end(), [&](const Shape& shape) {
      const bool round =
          std::holds_alternative<Circle>(shape.geometry) || std::holds_alternative<Capsule>(shape.geometry);
      return shape.surface.static_friction > 0 && !(round && body.type == BodyType::dynamic);
    });
  };
  return scene.joints.empty() && scene.forces.empty() && scene.gravity != Vec{} &&
         std::all_of(scene.bodies.begin(), scene.bodies.end(), stays);
}

// Once every body has been still for a second, no body may move by more than the gap it may still close, along gravity
// the gaps of all bodies that may lie below it, and the creep that the method states.
std::optional<InvariantCheck> check_rest(const InvariantContext& context) {
  const auto& [scene, trace, stepping] = context;
  if (!stays_where_it_rests(scene)) return std::nullopt;
  const double bodies = still_bodies(scene, std::vector<BodyState>(scene.bodies.size()));
  const double nu = trace_rounding(trace, stepping);
  WorstViolation worst;
  std::size_t first = 0;  // since when all are still
  std::optional<std::size_t> rest;
  for (std::size_t moment = 0; moment < trace.size() && !rest; ++moment) {
    if (still_bodies(scene, trace.states(moment)) < bodies) first = moment + 1;
    if (first <= moment && trace.time(moment) - trace.time(first) >= settling_time) rest = moment;
  }
  if (!rest) return worst.result();
  const Vec down = 1 / length(scene.gravity) * scene.gravity;
  const auto at_rest = trace.states(*rest);
  for (std::size_t moment = *rest + 1; moment < trace.size(); ++moment) {
    const auto states = trace.states(moment);
    const double time = trace.time(moment) - trace.time(*rest);
    for (std::size_t i = 0; i < states.size(); ++i) {
      const Vec moved = states[i].position - at_rest[i].position;
      const double slack = stepping.creep * time + nu * length(states[i].position);
      const auto where = [&] { return context.scene.bodies[i].name; };
      worst.add(std::abs(cross(down, moved)), stepping.contact_gap() + slack, trace.time(moment), where);
      worst.add(std::abs(dot(down, moved)), bodies * stepping.contact_gap() + slack, trace.time(moment), where);
    }
  }
  return worst.result();
}

const Catalog<Invariant>::Entry overlap_entry{
    {.name = "overlap",
     .unit = "m",
     .definition = "bodies overlap by no more than the stated gap and the distance covered before an impact is noticed",
     .check = check_overlap}};
const Catalog<Invariant>::Entry rest_entry{
    {.name = "rest",
     .unit = "m",
     .definition = "bodies at rest stay at rest: displacement of a body after all have been still for a second",
     .check = check_rest}};

}  // namespace
}  // namespace plumb::invariants::positions
