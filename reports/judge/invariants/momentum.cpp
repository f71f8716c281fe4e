#include <algorithm>
#include <cmath>

#include "reports/judge/acting.h"
#include "reports/judge/invariant.h"
#include "reports/judge/roundings.h"
#include "reports/vec.h"
#include "scenarios/catalog.h"

// Where nothing immovable is there to meet or to hang on and nothing drags, contacts and joints give as much as they
// take, and the momentum of all changes by the forces of the scene alone:
//   p(t) = p(0) + int F dt,   L(t) = L(0) + int (sum r x F + T) dt,
// the integrals by the trapezium over the states shown, which misses dt^2/12 of what a force's slope changes by.
// A first-order method takes a force at one end of its sub-step: its sums differ from the trapezium by d h (F(t) -
// F(0)) and d h (M(t) - M(0)), M = sum r x F + T, with its drift d; that is taken out beforehand, unless the motion is
// better without. What is pressed in at an impact is moved out sideways, and takes the momentum with it: the impulse
// times the gap, and times the way of a step where the method notices late.
namespace plumb::invariants::momentum {
namespace {

bool stands_alone(const Scene& scene) {
  const auto moves_freely = [](const Body& body) {
    return body.type == BodyType::dynamic && body.linear_damping == 0 && body.angular_damping == 0;
  };
  return std::all_of(scene.bodies.begin(), scene.bodies.end(), moves_freely);
}

bool may_rotate(const Scene& scene) {
  return std::none_of(scene.bodies.begin(), scene.bodies.end(), [](const Body& body) { return body.fixed_rotation; });
}

struct Total {
  Vec force;
  double torque = 0;  // about the world's origin
};

Total total_of(std::span<const Push> pushes, std::span<const BodyState> states) {
  Total total;
  for (std::size_t i = 0; i < pushes.size(); ++i) {
    total.force = total.force + pushes[i].force;
    total.torque += cross(states[i].position, pushes[i].force) + pushes[i].torque;
  }
  return total;
}

struct Missed {
  std::optional<InvariantCheck> linear, angular;
};

Missed missed_with(const InvariantContext& context, double drift) {
  const auto& [scene, trace, stepping] = context;
  const Acting acting(scene);
  const auto masses = acting.masses();
  const double nu = roundings(trace, stepping);
  const auto start = trace.states(0);
  const Total pushed = total_of(acting.on(start), start);
  const Momentum first = acting.conserved().momentum(start);
  Worst linear;
  Worst angular;
  Vec given;
  double turned = 0;
  double moved_out = 0;
  double size = 0;          // largest sum m v
  double turning_size = 0;  // and of m r v + I w
  double force_change = 0;  // largest in a step
  double torque_change = 0;
  std::vector<Push> before = acting.on(start);
  for (std::size_t moment = 1; moment < trace.size(); ++moment) {
    const auto then = trace.states(moment - 1);
    const auto now = trace.states(moment);
    const double dt = trace.time(moment) - trace.time(moment - 1);
    const std::vector<Push> after = acting.on(now);
    const Total was = total_of(before, then);
    const Total is = total_of(after, now);
    given = given + dt / 2 * (was.force + is.force);
    turned += dt / 2 * (was.torque + is.torque);
    force_change = std::max(force_change, length(is.force - was.force));
    torque_change = std::max(torque_change, std::abs(is.torque - was.torque));
    double momenta = 0;
    double moments = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
      const double mass = masses[i].mass;
      momenta += mass * length(now[i].velocity) + length(after[i].force) * dt;
      moments += mass * length(now[i].position) * length(now[i].velocity) +
                 masses[i].inertia * std::abs(now[i].angular_velocity);
      const Vec otherwise = now[i].velocity - then[i].velocity - dt / (2 * mass) * (before[i].force + after[i].force);
      const double speed = std::max(length(now[i].velocity), length(then[i].velocity));
      moved_out += mass * length(otherwise) * (stepping.gap + stepping.impact_lag * stepping.h * speed);
    }
    size = std::max(size, momenta);
    turning_size = std::max(turning_size, moments);
    const Momentum has = acting.conserved().momentum(now);
    const double late = drift * stepping.h;
    const Vec missing = has.linear - first.linear - given + late * (is.force - pushed.force);
    linear.see(length(missing), dt / 6 * force_change + nu * size, trace.time(moment), [] { return ""; });
    angular.see(std::abs(has.angular - first.angular - turned + late * (is.torque - pushed.torque)),
                dt / 6 * torque_change + moved_out + nu * turning_size, trace.time(moment), [] { return ""; });
    before = after;
  }
  Missed missed{.linear = linear.result()};
  if (may_rotate(scene)) missed.angular = angular.result();
  return missed;
}

std::optional<InvariantCheck> check(const InvariantContext& context, std::optional<InvariantCheck> Missed::*which) {
  if (!stands_alone(context.scene)) return std::nullopt;
  const auto as_stated = missed_with(context, context.stepping.drift).*which;
  const auto better = missed_with(context, 0).*which;
  if (!as_stated) return std::nullopt;
  return as_stated->ratio <= better->ratio ? as_stated : better;
}

const Catalog<Invariant>::Entry linear{
    {.name = "momentum",
     .unit = "kg m/s",
     .definition = "the momentum of all bodies changes by the forces of the scene alone, where nothing is immovable",
     .check = [](const InvariantContext& context) { return check(context, &Missed::linear); }}};
const Catalog<Invariant>::Entry angular{
    {.name = "angular_momentum",
     .unit = "kg m^2/s",
     .definition = "the angular momentum about the world's origin likewise",
     .check = [](const InvariantContext& context) { return check(context, &Missed::angular); }}};

}  // namespace
}  // namespace plumb::invariants::momentum
