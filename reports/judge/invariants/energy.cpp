#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/judge/acting.h"
#include "reports/judge/invariant.h"
#include "reports/judge/roundings.h"
#include "reports/vec.h"
#include "scenarios/catalog.h"

// What is held against physics is not E itself. With h the sub-step, d the drift that a method states (+1/2 where the
// forces act before the move, -1/2 after it, 0 where half before and half after) and F the forces, its motion conserves
//   H = E + d h sum (F.v + T w) + O(h^2)
// (Hairer, Lubich, Wanner, Geometric Numerical Integration, IX.3: the modified Hamiltonian): E itself goes up and down
// by the middle term, which is the method's and no error. Less the work W done from outside, H must never rise, but by
// - h^2/12 (|dF/dt . v| + |F|^2/m), the next term, as it comes and goes: its largest value twice, and its range;
// - F.V h (|d| + lag) at an impact of speed V, noticed `lag` late: what was pressed in is pushed out against F. In a
//   step whose velocities change by D, by c otherwise than F says: h (|d| + lag) min(|F.D|, |F.c|), which is nothing in
//   free motion (c = 0) and nothing at rest (D = 0);
// - the load on the contacts times the gap they may stand off by: as each takes it up, what it carries is lifted;
// - round-off.
// A method may be better than it says: where E itself does not rise, as in the exact motion, nothing is broken either.
// A method that gains more, as explicit Euler does on a spring (it multiplies E by 1 + (w h)^2 a step), is wrong by its
// own order.
namespace plumb::invariants::energy {
namespace {

// What one step did to a body.
struct Change {
  Vec force, velocity;  // mean force over the step; change of velocity
  double torque = 0, spin = 0;
};

double impact_work(const Change& by, const Mass& mass, double dt) {
  const Vec otherwise = by.velocity - dt / mass.mass * by.force;
  double work = std::min(std::abs(dot(by.force, by.velocity)), std::abs(dot(by.force, otherwise)));
  if (mass.inertia > 0) {
    const double spun = by.spin - dt * by.torque / mass.inertia;
    work += std::min(std::abs(by.torque * by.spin), std::abs(by.torque * spun));
  }
  return work;
}

Vec velocity_at(const BodyState& state, Vec point) {
  const Vec arm = point - state.position;
  return state.velocity + state.angular_velocity * Vec{-arm.y, arm.x};
}

bool moves_by_itself(const Body& body) {
  return body.type == BodyType::kinematic && (body.velocity != Vec{} || body.angular_velocity != 0);
}

// Work of the bodies that move whatever comes, through the contacts shown. A contact's place is known to the way its
// body goes in a step, and its velocity to w times that.
struct Driven {
  double work = 0, unsure = 0;  // J
};

Driven driven(const InvariantContext& context, std::size_t moment) {
  Driven driven;
  const double dt = context.trace.time(moment) - context.trace.time(moment - 1);
  const auto states = context.trace.states(moment);
  for (const ContactState& contact : context.trace.contacts(moment)) {
    const Vec side{-contact.normal.y, contact.normal.x};
    const Vec impulse = contact.normal_impulse * contact.normal + contact.tangent_impulse * side;
    for (const auto& [body, on_other] : {std::pair{contact.a, 1.0}, std::pair{contact.b, -1.0}}) {
      if (!moves_by_itself(context.scene.bodies[body])) continue;
      const Vec velocity = velocity_at(states[body], contact.point);
      driven.work += on_other * dot(impulse, velocity);
      driven.unsure += length(impulse) * std::abs(states[body].angular_velocity) *
                       (length(velocity) * dt + context.stepping.gap + std::abs(contact.separation));
    }
  }
  return driven;
}

// The load on all contacts, N: the largest mean over a quarter of a second, so that an impact is not taken for one. A
// engine that shows none: every body on top of all others.
double load_of(const InvariantContext& context, const Acting& acting) {
  constexpr double window = 0.25;  // s
  if (!reports_contacts(context.trace)) {
    double weight = 0;
    double bodies = 0;
    const auto pushes = acting.on(context.trace.states(0));
    for (const Push& push : pushes) {
      weight += length(push.force);
      bodies += length(push.force) > 0 ? 1 : 0;
    }
    return weight * bodies;
  }
  std::vector<double> sums{0};
  for (std::size_t i = 1; i < context.trace.size(); ++i) {
    double sum = sums.back();
    for (const ContactState& contact : context.trace.contacts(i)) sum += std::max(0.0, contact.normal_impulse);
    sums.push_back(sum);
  }
  double largest = 0;
  for (std::size_t end = 1, begin = 0; end < sums.size(); ++end) {
    while (context.trace.time(end) - context.trace.time(begin) > window) ++begin;
    const double time = context.trace.time(end) - context.trace.time(begin);
    if (time > 0) largest = std::max(largest, (sums[end] - sums[begin]) / time);
  }
  return largest;
}

// Columns over the run, J: what must not rise, and what it may rise by up to each moment.
struct Account {
  std::vector<double> modified, tolerance;
  double coming_and_going = 0;
};

Account account_of(const InvariantContext& context, double drift) {
  const Acting acting(context.scene);
  const auto& [scene, trace, stepping] = context;
  const auto masses = acting.masses();
  const double nu = roundings(trace, stepping);
  Account account;
  double work = 0;
  double tolerance = 0;
  double bending = 0;                                              // largest |dF/dt . v|
  double low = std::numeric_limits<double>::infinity(), high = 0;  // of |F|^2/m
  double size = 0;                                                 // J, largest of what is rounded
  double power = 0, power_change = 0;
  std::vector<Push> before;
  for (std::size_t moment = 0; moment < trace.size(); ++moment) {
    const auto states = trace.states(moment);
    const auto pushes = acting.on(states);
    double swing = 0;    // sum F.v
    double squares = 0;  // sum |F|^2/m
    double bend = 0;
    double sizes = 0;
    const double dt = moment == 0 ? 0 : trace.time(moment) - trace.time(moment - 1);
    for (std::size_t i = 0; i < states.size(); ++i) {
      const Mass& mass = masses[i];
      if (mass.mass == 0) continue;
      const BodyState& now = states[i];
      swing += dot(pushes[i].force, now.velocity) + pushes[i].torque * now.angular_velocity;
      squares += dot(pushes[i].force, pushes[i].force) / mass.mass;
      if (mass.inertia > 0) squares += pushes[i].torque * pushes[i].torque / mass.inertia;
      sizes += mass.mass * dot(now.velocity, now.velocity) +
               mass.inertia * now.angular_velocity * now.angular_velocity +
               length(pushes[i].force) * (length(now.position) + trace.times().back() * length(now.velocity) / 2);
      if (moment == 0) continue;
      const BodyState& then = trace.states(moment - 1)[i];
      const Change change{0.5 * (before[i].force + pushes[i].force), now.velocity - then.velocity,
                          (before[i].torque + pushes[i].torque) / 2, now.angular_velocity - then.angular_velocity};
      tolerance += (std::abs(stepping.drift) + stepping.impact_lag) * stepping.h * impact_work(change, mass, dt);
      bend += (std::abs(dot(pushes[i].force - before[i].force, 0.5 * (now.velocity + then.velocity))) +
               std::abs((pushes[i].torque - before[i].torque) * now.angular_velocity)) /
              dt;
    }
    const double now_power = acting.power(states);
    if (moment > 0) {
      const Driven by = driven(context, moment);
      work += by.work + dt * (power + now_power) / 2;
      tolerance += by.unsure;
      power_change = std::max(power_change, std::abs(now_power - power) * dt);
    }
    power = now_power;
    before = pushes;
    bending = std::max(bending, bend);
    low = std::min(low, squares);
    high = std::max(high, squares);
    size = std::max(size, sizes);
    account.modified.push_back(acting.conserved().energy(states).total() + acting.potential(states) +
                               drift * stepping.h * swing - work);
    account.tolerance.push_back(tolerance);
  }
  // The trapezium over dt misses dt^2/12 of what the power's slope changes by: at most its largest, there and back.
  account.coming_and_going = stepping.h * stepping.h / 12 * (2 * bending + high - low) + power_change / 6 +
                             stepping.gap * load_of(context, acting) + nu * size;
  return account;
}

InvariantCheck rise(const InvariantContext& context, double drift) {
  const Account account = account_of(context, drift);
  Worst worst;
  std::size_t lowest = 0;
  for (std::size_t i = 1; i < account.modified.size(); ++i) {
    worst.see(account.modified[i] - account.modified[lowest],
              account.tolerance[i] - account.tolerance[lowest] + account.coming_and_going, context.trace.time(i),
              [] { return ""; });
    if (account.modified[i] - account.tolerance[i] < account.modified[lowest] - account.tolerance[lowest]) lowest = i;
  }
  return worst.result();
}

std::optional<InvariantCheck> check(const InvariantContext& context) {
  const auto& bodies = context.scene.bodies;
  const bool drives = std::any_of(bodies.begin(), bodies.end(), moves_by_itself);
  if (drives && (!reports_contacts(context.trace) || !context.stepping.whole_impulses)) return not_reported();
  for (const Joint& joint : context.scene.joints) {
    const auto [a, b] = std::visit([](const auto& of) { return std::pair{of.a, of.b}; }, joint);
    if (moves_by_itself(bodies[a]) || moves_by_itself(bodies[b])) return not_reported();
  }
  const InvariantCheck as_stated = rise(context, context.stepping.drift);
  const InvariantCheck better = rise(context, 0);
  return as_stated.ratio <= better.ratio ? as_stated : better;
}

const Catalog<Invariant>::Entry entry{
    {.name = "energy",
     .unit = "J",
     .definition = "never rises without work: energy as the method's order has it, less the work done from outside, "
                   "above its lowest so far",
     .check = check}};

}  // namespace
}  // namespace plumb::invariants::energy
