#include <algorithm>
#include <cmath>

#include "reports/judge/invariant.h"
#include "reports/judge/roundings.h"
#include "reports/judge/still.h"
#include "reports/vec.h"
#include "scenarios/catalog.h"

// A scene of which every body has been still for a second, on its faces and held by friction, has come to rest: from
// then on nothing may move by more than the gap it may still take up, along gravity as many as bodies may lie below it,
// and the creep that the method states. A disc may
// roll as slowly as it likes, a pendulum swing, and a spring pull: there, still is not at rest.
namespace plumb::invariants::rest {
namespace {

constexpr double settled = 1;  // s

bool rests_where_it_is(const Scene& scene) {
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

std::optional<InvariantCheck> check(const InvariantContext& context) {
  const auto& [scene, trace, stepping] = context;
  if (!rests_where_it_is(scene)) return std::nullopt;
  const double bodies = still_bodies(scene, std::vector<BodyState>(scene.bodies.size()));
  const double nu = roundings(trace, stepping);
  Worst worst;
  std::size_t first = 0;  // since when all are still
  std::optional<std::size_t> rest;
  for (std::size_t moment = 0; moment < trace.size() && !rest; ++moment) {
    if (still_bodies(scene, trace.states(moment)) < bodies) first = moment + 1;
    if (first <= moment && trace.time(moment) - trace.time(first) >= settled) rest = moment;
  }
  if (!rest) return worst.result();
  const Vec down = 1 / length(scene.gravity) * scene.gravity;
  const auto there = trace.states(*rest);
  for (std::size_t moment = *rest + 1; moment < trace.size(); ++moment) {
    const auto states = trace.states(moment);
    const double time = trace.time(moment) - trace.time(*rest);
    for (std::size_t i = 0; i < states.size(); ++i) {
      const Vec way = states[i].position - there[i].position;
      const double slack = stepping.creep * time + nu * length(states[i].position);
      const auto where = [&] { return context.scene.bodies[i].name; };
      worst.see(std::abs(cross(down, way)), stepping.gap + slack, trace.time(moment), where);
      worst.see(std::abs(dot(down, way)), bodies * stepping.gap + slack, trace.time(moment), where);
    }
  }
  return worst.result();
}

const Catalog<Invariant>::Entry entry{
    {.name = "rest",
     .unit = "m",
     .definition = "what has come to rest stays: way of a body from where it was when all had been still for a second",
     .check = check}};

}  // namespace
}  // namespace plumb::invariants::rest
