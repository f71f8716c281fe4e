// Energy never rises without work.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include "reports/judge/contacts.h"
#include "reports/judge/invariant.h"
#include "reports/judge/joint_geometry.h"
#include "reports/judge/mechanics.h"
#include "reports/judge/rounding.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/joints.h"
#include "scenarios/scene/vec.h"

// The check does not apply to E itself. With h the sub-step, d the drift that a method states (+1/2 if the forces act
// before the move, -1/2 if after it, 0 if half before and half after) and F the forces, its motion conserves
//   H = E + d h sum (F.v + T w) + O(h^2)
// (Hairer, Lubich, Wanner, Geometric Numerical Integration, IX.3: the modified Hamiltonian). E itself oscillates by the
// middle term, which belongs to the method and is no error. H, less the work W done from outside, must never rise by
// more than the following.
// - h^2/12 (|dF/dt . v| + |F|^2/m), the next term, which oscillates: twice its largest value, and its range. Joints
//   exert forces too: what holds a body on circles about its anchors, m sum w^2 r over the joints that hold it and
//   those that these hang from, turns with w. No w counts that the energy of the scene could not give the body;
// - F.V h (|d| + lag) at an impact of speed V, noticed `lag` late: the overlap is pushed out against F. In a step whose
//   velocities change by D, by c more than F explains: h (|d| + lag) min(|F.D|, |F.c|), which is zero in free motion
//   (c = 0) and at rest (D = 0). A method that corrects positions by themselves pushes out in the step that notices it,
//   and its velocities change in the next one: it has the share of the step to come as well;
// - the load on the contacts times their gap: a contact lifts its load when it takes up the gap. Where contacts hold
//   their points for a step, what turns by a in one is let down by r (1 - cos a), where a part of that radius is round,
//   and lifted again;
// - the power from outside between two moments, where a body passes what pulls at it;
// - round-off; that of places, u X, too, where joints put them right by velocities, u X/h.
// Joints that the method states to be springs hold energy, too: what H loses to them it may have back.
// A method may be better than it states: if E itself does not rise, as in the exact motion, nothing is broken either.
// A method that gains more, such as explicit Euler on a spring (it multiplies E by 1 + (w h)^2 a step), is wrong by its
// own order.
namespace plumb::invariants::energy {
namespace {

// One step of a body.
struct BodyStep {
  Vec force, velocity;  // mean force over the step; change of velocity
  double torque = 0, spin = 0;
};

double impact_work(const BodyStep& by, const Mass& mass, double dt) {
  const Vec unexplained = by.velocity - dt / mass.mass * by.force;
  double work = std::min(std::abs(dot(by.force, by.velocity)), std::abs(dot(by.force, unexplained)));
  if (mass.inertia > 0) {
    const double unexplained_spin = by.spin - dt * by.torque / mass.inertia;
    work += std::min(std::abs(by.torque * by.spin), std::abs(by.torque * unexplained_spin));
  }
  return work;
}

// Work of the driven bodies through the reported contacts: of one that may not turn, by its spin alone. The position of
// a contact is uncertain by the distance its body moves in a step, and its velocity by w times that.
struct DriveWork {
  double work = 0, uncertainty = 0;  // J
};

DriveWork drive_work(const InvariantContext& context, std::size_t moment) {
  DriveWork done;
  const double dt = context.trace.time(moment) - context.trace.time(moment - 1);
  const auto states = context.trace.states(moment);
  for (const ContactState& contact : context.trace.contacts(moment)) {
    const Vec impulse = impulse_of(contact);
    for (const auto& [body, on_other] : {std::pair{contact.a, 1.0}, std::pair{contact.b, -1.0}}) {
      if (!is_driven(context.scene.bodies[body])) continue;
      const Vec velocity = velocity_at(states[body], contact.point);
      const double moved = dt * std::max(length(velocity), length(states[body].velocity));
      const bool spins_only = context.scene.bodies[body].type == BodyType::dynamic;
      done.work += on_other * dot(impulse, spins_only ? velocity - states[body].velocity : velocity);
      done.uncertainty += length(impulse) * std::abs(states[body].angular_velocity) *
                          (moved + context.stepping.contact_gap() + std::abs(contact.separation));
    }
  }
  return done;
}

// m, the largest radius of a body's round parts: a corner that it turns on stays the same point of it.
double roundness(const Body& body) {
  double largest = 0;
  for (const Shape& shape : body.shapes) {
    if (const auto* circle = std::get_if<Circle>(&shape.geometry)) largest = std::max(largest, circle->radius);
    if (const auto* capsule = std::get_if<Capsule>(&shape.geometry)) largest = std::max(largest, capsule->radius);
  }
  return largest;
}

// The load on all contacts, N: the largest mean over a quarter of a second, so that impacts do not count as loads. For
// an engine that reports no contacts, every body is assumed to lie on top of all others.
double load_of(const InvariantContext& context, const AppliedForces& forces) {
  constexpr double window = 0.25;  // s
  if (!context.trace.has_contacts()) {
    double weight = 0;
    double bodies = 0;
    const auto wrenches = forces.at(context.trace.states(0));
    for (const Wrench& wrench : wrenches) {
      weight += length(wrench.force);
      bodies += length(wrench.force) > 0 ? 1 : 0;
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

// The states with no more speed or spin than an energy, J, gives each body.
std::vector<BodyState> slowed(std::span<const BodyState> states, std::span<const Mass> masses, double energy) {
  std::vector<BodyState> all(states.begin(), states.end());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double speed = length(all[i].velocity);
    const double fastest = masses[i].mass > 0 ? std::sqrt(2 * energy / masses[i].mass) : speed;
    if (speed > fastest) all[i].velocity = fastest / speed * all[i].velocity;
    if (masses[i].inertia == 0) continue;
    const double most = std::sqrt(2 * energy / masses[i].inertia);
    all[i].angular_velocity = std::clamp(all[i].angular_velocity, -most, most);
  }
  return all;
}

// By moment, J: the modified energy, which must not rise, and by how much it may have risen until then.
struct Balance {
  std::vector<double> modified, tolerance;
  double oscillation = 0;
};

// `springs`: whether joints hold energy as the springs that the method states.
Balance balance_of(const InvariantContext& context, double drift, bool springs) {
  const AppliedForces forces(context.scene);
  const auto& [scene, trace, stepping, neighbours] = context;
  const auto masses = forces.masses();
  const double nu = trace_rounding(trace, stepping);
  const JointGeometry joints(scene);
  const double range = energy_range(scene, nullptr);
  std::vector<bool> jointed(scene.bodies.size());
  for (std::size_t joint = 0; joint < joints.size(); ++joint) {
    const auto [a, b] = joints.bodies(joint);
    jointed[a] = jointed[b] = true;
  }
  Balance balance;
  double work = 0;
  double tolerance = 0;
  double force_rate = 0;                                           // largest |dF/dt . v|
  double low = std::numeric_limits<double>::infinity(), high = 0;  // of |F|^2/m
  double size = 0;                                                 // J, the largest energy that is rounded
  double places = 0;                                               // kg m^2/s, the same of what puts places right
  double power = 0, power_change = 0;
  double let_down = 0;  // m
  std::vector<Wrench> before;
  for (std::size_t moment = 0; moment < trace.size(); ++moment) {
    const auto states = trace.states(moment);
    const auto wrenches = forces.at(states);
    double power_sum = 0;  // sum F.v + T w
    double joint_squares = 0;
    double squares = 0;  // sum |F|^2/m
    double rate = 0;
    double sizes = 0;
    double put_right = 0;  // kg m^2/s
    const std::vector<BodyState> possible = slowed(states, masses, range);
    const double held = joints.acceleration(possible, length(scene.gravity));  // m/s^2
    const double turns = joints.spin(possible);                                // rad/s
    const double dt = moment == 0 ? 0 : trace.time(moment) - trace.time(moment - 1);
    for (std::size_t i = 0; i < states.size(); ++i) {
      const Mass& mass = masses[i];
      if (mass.mass == 0) continue;
      const BodyState& now = states[i];
      power_sum += dot(wrenches[i].force, now.velocity) + wrenches[i].torque * now.angular_velocity;
      squares += dot(wrenches[i].force, wrenches[i].force) / mass.mass;
      if (jointed[i]) {
        put_right += mass.mass * length(now.velocity) * length(now.position);
        joint_squares += mass.mass * held * held;
        rate += mass.mass * held * turns * length(now.velocity);
      }
      if (mass.inertia > 0) squares += wrenches[i].torque * wrenches[i].torque / mass.inertia;
      sizes += mass.mass * dot(now.velocity, now.velocity) +
               mass.inertia * now.angular_velocity * now.angular_velocity +
               length(wrenches[i].force) * (length(now.position) + trace.times().back() * length(now.velocity) / 2);
      if (moment == 0) continue;
      const BodyState& then = trace.states(moment - 1)[i];
      if (stepping.held_anchors) {
        const double turn = std::min(std::numbers::pi, dt * std::abs(possible[i].angular_velocity));
        let_down = std::max(let_down, roundness(scene.bodies[i]) * (1 - std::cos(turn)));
      }
      const BodyStep step{0.5 * (before[i].force + wrenches[i].force), now.velocity - then.velocity,
                          (before[i].torque + wrenches[i].torque) / 2, now.angular_velocity - then.angular_velocity};
      tolerance += (std::abs(stepping.drift) + stepping.impact_lag) * stepping.h * impact_work(step, mass, dt);
      rate += (std::abs(dot(wrenches[i].force - before[i].force, 0.5 * (now.velocity + then.velocity))) +
               std::abs((wrenches[i].torque - before[i].torque) * now.angular_velocity)) /
              dt;
    }
    const double now_power = forces.power(states);
    if (moment > 0) {
      const DriveWork by = drive_work(context, moment);
      work += by.work + dt * (power + now_power) / 2;
      for (const auto& passages : {forces.passages(trace.states(moment - 1), dt), forces.passages(states, -dt)}) {
        for (const auto& passing : passages)
          tolerance += dt / 2 * std::abs(forces.power(passing) - (power + now_power) / 2);
      }
      tolerance += by.uncertainty;
      power_change = std::max(power_change, std::abs(now_power - power) * dt);
    }
    power = now_power;
    before = wrenches;
    force_rate = std::max(force_rate, rate);
    low = std::min(low, squares);
    high = std::max(high, squares + joint_squares);
    size = std::max(size, sizes);
    places = std::max(places, put_right);
    double stored = 0;
    for (std::size_t joint = 0; springs && joint < joints.size(); ++joint) {
      stored += joints.stored(joint, states, 2 * std::numbers::pi * stepping.joint_frequency);
    }
    balance.modified.push_back(stored + forces.conserved().energy(states).total() + forces.potential(states) +
                               drift * stepping.h * power_sum - work);
    balance.tolerance.push_back(tolerance);
  }
  // The trapezoidal rule is off by dt^2/12 times the change of the power's slope: at most twice the largest slope.
  balance.oscillation = stepping.h * stepping.h / 12 * (2 * force_rate + high - low) + power_change / 6 +
                        (stepping.contact_gap() + let_down) * load_of(context, forces) + nu * size +
                        (stepping.h > 0 ? stepping.epsilon * places / stepping.h : 0);
  return balance;
}

InvariantCheck rise(const InvariantContext& context, double drift, bool springs) {
  const Balance balance = balance_of(context, drift, springs);
  const double range = energy_range(context.scene, nullptr);
  WorstViolation worst;
  const std::size_t ahead = context.stepping.position_iterations > 0 ? 1 : 0;
  std::size_t lowest = 0;
  for (std::size_t i = 1; i < balance.modified.size(); ++i) {
    const double pushed_out = balance.tolerance[std::min(i + ahead, balance.tolerance.size() - 1)];
    worst.add(balance.modified[i] - balance.modified[lowest],
              pushed_out - balance.tolerance[lowest] + balance.oscillation, range, context.trace.time(i),
              [] { return ""; });
    if (balance.modified[i] - balance.tolerance[i] < balance.modified[lowest] - balance.tolerance[lowest]) lowest = i;
  }
  return worst.result();
}

std::optional<InvariantCheck> check(const InvariantContext& context) {
  const auto& bodies = context.scene.bodies;
  const bool drives = std::any_of(bodies.begin(), bodies.end(), is_driven);
  // What touches nothing drives nothing.
  const auto cannot = drives ? without_contacts(context, true) : std::nullopt;
  if (cannot && cannot->status == CheckStatus::not_reported) return cannot;
  // What keeps up a spin against a spring works too.
  const auto spins = [](const Body& body) { return body.type == BodyType::dynamic && is_driven(body); };
  if (!context.scene.forces.empty() && std::any_of(bodies.begin(), bodies.end(), spins)) return not_reported();
  for (const Joint& joint : context.scene.joints) {
    const auto [a, b] = std::visit([](const auto& of) { return std::pair{of.a, of.b}; }, joint);
    if (is_driven(bodies[a]) || is_driven(bodies[b]) || motor_of(joint) != nullptr) return not_reported();
  }
  InvariantCheck best = rise(context, context.stepping.drift, false);
  const auto or_better = [&](double drift, bool springs) {
    const InvariantCheck other = rise(context, drift, springs);
    if (other.ratio < best.ratio) best = other;
  };
  or_better(0, false);
  if (context.stepping.joint_frequency > 0 && !context.scene.joints.empty()) {
    or_better(context.stepping.drift, true);
    or_better(0, true);
  }
  return best;
}

const Catalog<Invariant>::Entry entry{
    {.name = "energy",
     .unit = "J",
     .definition =
         "energy never rises without work: the energy that the method conserves to its order, less the work done "
         "from outside, above its lowest value so far",
     .check = check}};

}  // namespace
}  // namespace plumb::invariants::energy
