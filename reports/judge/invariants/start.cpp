// A run starts where its scene does.
#include <algorithm>
#include <cmath>

#include "reference/scene_facts.h"
#include "reports/judge/invariant.h"
#include "reports/judge/mechanics.h"
#include "reports/judge/overlap.h"
#include "reports/judge/rounding.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/vec.h"

namespace plumb::invariants::start {
namespace {

// The first recorded state of every body is that of the scene, up to the rounding of the few operations that bring it
// into the engine and out again. Any engine that reads the scene passes, so this is never evidence of physics.
std::optional<InvariantCheck> check(const InvariantContext& context) {
  const std::vector<BodyState> start = initial_states(context.scene);
  const auto states = context.trace.states(0);
  double reach = 0;  // m, of the scene
  for (const BodyState& state : start) reach = std::max(reach, length(state.position));
  WorstViolation worst;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const auto where = [&] { return context.scene.bodies[i].name; };
    const auto add = [&](double off, double size) {
      worst.add(off, solver_rounding(context.stepping) * size, 0, context.trace.time(0), where);
    };
    add(length(states[i].position - start[i].position), reach + bounding_radius(context.scene.bodies[i]));
    add(std::abs(states[i].angle - start[i].angle), 1 + std::abs(start[i].angle));
    add(length(states[i].velocity - start[i].velocity),
        length(start[i].velocity) + differenced(context.stepping, reach, context.stepping.dt));
    add(std::abs(states[i].angular_velocity - start[i].angular_velocity),
        std::abs(start[i].angular_velocity) +
            differenced(context.stepping, 1 + std::abs(start[i].angle), context.stepping.dt));
  }
  return worst.result();
}

const Catalog<Invariant>::Entry entry{
    {.name = "start",
     .unit = "SI",
     .definition = "a run starts from the scene's positions, angles, velocities and angular velocities",
     .check = check}};

}  // namespace
}  // namespace plumb::invariants::start
