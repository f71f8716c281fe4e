// Energy stays within what the scene can give.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <variant>

#include "reports/judge/contacts.h"
#include "reports/judge/invariant.h"
#include "reports/judge/mechanics.h"
#include "reports/judge/rounding.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/vec.h"

// The energy of bodies that nothing drives never exceeds that of the start by more than the bound below. Unlike that of
// `energy`, which follows the impacts of the run, it comes from the scene: its masses m, its constant forces F, and its
// duration t. Only the potential that the bodies have lost since the start is read from the run, which bounds their
// kinetic energy K from above.
// - A method of drift d conserves E + d h sum F.v to its order, so E oscillates by d h sum F.v, at the start and now:
//   each at most sqrt(sum F^2/m) sqrt(2 K).
// - An impact at speed V that is noticed `lag` late is pushed out by (|d| + lag) h V against F. An impulse J ends an
//   approach of at least J/2m, so all impulses together cost (|d| + lag) h (F/m) sum J. On one body over the ground sum
//   J is what stops its fall, F t, plus the change of its momentum, 2 sqrt(2 M K); in a pile each body may pass on the
//   impulses of all those above it, which is at most the number of bodies times as much.
// - A contact lifts its load when it takes up the gap: the same number of times the sum of F times the gap.
// - Simultaneous impacts that iterations solve conserve energy only once they have converged: K times the share that
//   the stated iterations leave unsolved.
// - Round-off, of each sub-step and of each impact that is solved at its own time: two bodies and a wall meet up to pi
//   sqrt(M/m) times (Galperin 2003); and the velocity that the rounding of a gap, u |x|, gives in a sub-step, for
//   bodies that do not move.
// Joints, springs and attractions have no such bound of constants, and `energy` alone judges them.
namespace plumb::invariants::energy_bound {
namespace {

bool is_bounded(const Scene& scene) {
  const auto is_constant = [](const Force& force) { return std::holds_alternative<Constant>(force); };
  return scene.joints.empty() && std::all_of(scene.forces.begin(), scene.forces.end(), is_constant) &&
         std::none_of(scene.bodies.begin(), scene.bodies.end(), is_driven);
}

// Sums over the dynamic bodies.
struct Loads {
  double bodies = 0, mass = 0, force = 0;  // -, kg, N
  double lightest = std::numeric_limits<double>::infinity();
  double heaviest = 0;
  double acceleration = 0;  // m/s^2, the largest
  double squares = 0;       // N^2/kg
};

Loads loads_of(const AppliedForces& forces, std::span<const BodyState> start) {
  Loads loads;
  const std::vector<Wrench> wrenches = forces.at(start);
  for (std::size_t i = 0; i < start.size(); ++i) {
    const Mass& mass = forces.masses()[i];
    if (mass.mass == 0) continue;
    const double force = length(wrenches[i].force);
    ++loads.bodies;
    loads.mass += mass.mass;
    loads.force += force;
    loads.lightest = std::min(loads.lightest, mass.mass);
    loads.heaviest = std::max(loads.heaviest, mass.mass);
    loads.acceleration = std::max(loads.acceleration, force / mass.mass);
    loads.squares += force * force / mass.mass;
    if (mass.inertia > 0) loads.squares += wrenches[i].torque * wrenches[i].torque / mass.inertia;
  }
  return loads;
}

std::optional<InvariantCheck> check(const InvariantContext& context) {
  const auto& [scene, trace, stepping, neighbours] = context;
  if (!is_bounded(scene)) return std::nullopt;
  const AppliedForces forces(scene);
  const std::vector<BodyState> start = initial_states(scene);
  const Loads loads = loads_of(forces, start);
  if (loads.bodies == 0) return std::nullopt;
  const auto potential = [&](std::span<const BodyState> states) {
    return forces.conserved().energy(states).potential + forces.potential(states);
  };
  const double at_start = potential(start);
  const double moving = forces.conserved().energy(start).kinetic();
  const double range = energy_range(scene, nullptr);
  const double impacts = stepping.impact_lag == 0 ? std::numbers::pi * std::sqrt(loads.heaviest / loads.lightest) : 0;
  const double nu = trace_rounding(trace, stepping) + impacts * stepping.epsilon;
  const double late = (std::abs(stepping.drift) + stepping.impact_lag) * stepping.h;
  double released = 0;
  double farthest = 0;
  WorstViolation worst;
  for (std::size_t moment = 0; moment < trace.size(); ++moment) {
    const auto states = trace.states(moment);
    const double now = potential(states);
    released = std::max(released, at_start - now);
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (forces.masses()[i].mass > 0) farthest = std::max(farthest, length(states[i].position));
    }
    const double kinetic = moving + released;
    const double momentum = std::sqrt(2 * loads.mass * kinetic);
    const double oscillation = 2 * std::abs(stepping.drift) * stepping.h * std::sqrt(loads.squares * 2 * kinetic);
    const double pushed_out =
        late * loads.acceleration * loads.bodies * (loads.force * trace.time(moment) + 2 * momentum);
    const double lifted = stepping.contact_gap() * loads.bodies * loads.force;
    const double unsolved = unsolved_share(stepping) * kinetic;
    const double fastest = std::sqrt(2 * kinetic / loads.lightest);
    const double rounded = nu * (2 * kinetic + loads.force * (farthest + trace.times().back() / 2 * fastest));
    const double gained = forces.conserved().energy(states).kinetic() + now - moving - at_start;
    const double closing = stepping.h > 0 ? stepping.epsilon * farthest / stepping.h : 0;  // m/s, of a rounded gap
    const double least = loads.mass * closing * closing / 2;
    worst.add(gained, oscillation + pushed_out + lifted + unsolved + rounded + least, range, trace.time(moment),
              [] { return ""; });
  }
  return worst.result();
}

const Catalog<Invariant>::Entry entry{
    {.name = "energy_bound",
     .unit = "J",
     .definition = "the energy of bodies that nothing drives never exceeds that of the start by more than the scene "
                   "and the stated method allow",
     .check = check}};

}  // namespace
}  // namespace plumb::invariants::energy_bound
