// Momentum changes by forces and impulses alone: that of the whole scene, and that of every body.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "reference/scene_facts.h"
#include "reports/judge/contacts.h"
#include "reports/judge/invariant.h"
#include "reports/judge/joint_geometry.h"
#include "reports/judge/mechanics.h"
#include "reports/judge/overlap.h"
#include "reports/judge/rounding.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/vec.h"

namespace plumb::invariants::momentum {
namespace {

bool is_closed(const Scene& scene) {
  const auto moves_freely = [](const Body& body) {
    return body.type == BodyType::dynamic && body.linear_damping == 0 && body.angular_damping == 0;
  };
  return std::all_of(scene.bodies.begin(), scene.bodies.end(), moves_freely);
}

bool may_rotate(const Scene& scene) {
  return std::none_of(scene.bodies.begin(), scene.bodies.end(), [](const Body& body) { return body.fixed_rotation; });
}

// The force and torque on the whole scene.
struct TotalWrench {
  Vec force;
  double torque = 0;  // about the world's origin
};

TotalWrench total_of(std::span<const Wrench> wrenches, std::span<const BodyState> states) {
  TotalWrench total;
  for (std::size_t i = 0; i < wrenches.size(); ++i) {
    total.force = total.force + wrenches[i].force;
    total.torque += cross(states[i].position, wrenches[i].force) + wrenches[i].torque;
  }
  return total;
}

// What a scene can show: the momentum of all its mass with all of its energy, at the distance of its farthest body.
struct Scales {
  double linear = 0, angular = 0;
};

Scales scales_of(const Scene& scene, std::span<const Mass> masses) {
  double mass = 0;
  double distance = 0;
  for (const Mass& one : masses) mass += one.mass;
  for (const Body& body : scene.bodies) distance = std::max(distance, length(body.position) + bounding_radius(body));
  const double linear = std::sqrt(2 * mass * energy_range(scene, nullptr));
  return {linear, linear * distance};
}

struct Missed {
  std::optional<InvariantCheck> linear, angular;
};

// Contacts and joints between bodies give as much momentum as they take. Without anything immovable to touch or to be
// attached to, and without damping, the total momentum therefore changes by the forces of the scene alone:
//   p(t) = p(0) + int F dt,   L(t) = L(0) + int (sum r x F + T) dt,
// the integrals by the trapezoidal rule over the reported states. Of an oscillation cos wt it is off by dt^2/12 times
// the change of the force's slope, at most twice the largest slope, and by (3/y^2)(1 - y cot y), y = w dt/2, times as
// much: 12/pi^2 for the fastest that states at every dt show, w dt = pi. So 2 dt/pi^2 times the largest slope times dt:
// the force's change in a step, or, where it turns within the step, its change until a step after the start and since a
// step before the end at the velocities there. A method may take a force where the velocities at the step's start lead
// by its middle: that misses dt^2/8 of the change of the force's slope, dt/4 times the same change. Where a body
// passes what pulls at it between two moments, dt/2 times what the force is then more is missed. A first-order
// method takes a force at one end of its sub-step: its sums differ from the trapezoids by d h (F(t) - F(0)) and d h
// (M(t) - M(0)), M = sum r x F + T, with its drift d. The check subtracts that, unless the run is better without. A
// first-order method moves the bodies of a joint along the tangents and then puts their places right, which moves their
// momentum along. An overlap from an impact is pushed out sideways and takes momentum along: the impulse times the gap,
// and times the distance moved in a step if the method notices impacts late. The sums themselves are rounded: those of
// n terms by n u of their sizes, u = 2^-53, for the bodies at both ends and for the steps (Higham, Accuracy and
// Stability of Numerical Algorithms, 4.2). The anchor of a joint is rounded as its body's place is, u |x|: a body that
// turns at w about one that is meant to be its centre moves at u |x| w.
Missed missed_with(const InvariantContext& context, double drift) {
  constexpr double slope_share = 2 / (std::numbers::pi * std::numbers::pi) + 1.0 / 4;
  const auto& [scene, trace, stepping, neighbours] = context;
  const AppliedForces forces(scene);
  const auto masses = forces.masses();
  const double nu = trace_rounding(trace, stepping);
  const auto start = trace.states(0);
  const TotalWrench at_start = total_of(forces.at(start), start);
  const Momentum first = forces.conserved().momentum(start);
  const Scales scales = scales_of(scene, masses);
  WorstViolation linear;
  WorstViolation angular;
  Vec impulse;
  double angular_impulse = 0;
  double pushed_out = 0;
  double size = 0;          // largest sum m v
  double angular_size = 0;  // largest sum m r v + I w
  double force_change = 0;  // largest in a step
  double torque_change = 0;
  double passed = 0;  // N s, and N m s: of forces that come and go between two moments
  double passed_torque = 0;
  double force_size = 0;  // largest sum |F|
  double torque_size = 0;
  const JointGeometry joints(scene);
  std::vector<double> joined(scene.bodies.size());  // 1 if it has a joint
  for (std::size_t joint = 0; joint < joints.size(); ++joint) {
    const auto [a, b] = joints.bodies(joint);
    joined[a] = joined[b] = 1;
  }
  std::vector<Wrench> before = forces.at(start);
  for (std::size_t moment = 1; moment < trace.size(); ++moment) {
    const auto then = trace.states(moment - 1);
    const auto now = trace.states(moment);
    const double dt = trace.time(moment) - trace.time(moment - 1);
    for (std::size_t joint = 0; stepping.order == 1 && joint < joints.size(); ++joint) {
      const auto [a, b] = joints.bodies(joint);
      const double tangents = joints.linearisation(joint, then, dt) + joints.linearisation(joint, now, dt);
      for (const std::size_t body : {a, b}) pushed_out += masses[body].mass * length(now[body].velocity) * tangents;
    }
    const std::vector<Wrench> after = forces.at(now);
    const TotalWrench was = total_of(before, then);
    const TotalWrench is = total_of(after, now);
    impulse = impulse + dt / 2 * (was.force + is.force);
    angular_impulse += dt / 2 * (was.torque + is.torque);
    const std::vector<BodyState> ahead = moved_on(then, dt);
    const std::vector<BodyState> behind = moved_on(now, -dt);
    const TotalWrench next = total_of(forces.at(ahead), ahead);
    const TotalWrench last = total_of(forces.at(behind), behind);
    force_change = std::max(
        {force_change, length(is.force - was.force), length(next.force - was.force), length(is.force - last.force)});
    torque_change = std::max({torque_change, std::abs(is.torque - was.torque), std::abs(next.torque - was.torque),
                              std::abs(is.torque - last.torque)});
    for (const auto& passages : {forces.passages(then, dt), forces.passages(now, -dt)}) {
      for (const auto& passing : passages) {
        const TotalWrench there = total_of(forces.at(passing), passing);
        passed += dt / 2 * length(there.force - 0.5 * (was.force + is.force));
        passed_torque += dt / 2 * std::abs(there.torque - (was.torque + is.torque) / 2);
      }
    }
    double momenta = 0;
    double moments = 0;
    double pulls = 0;
    double turns = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
      const double mass = masses[i].mass;
      const double arm = joined[i] * length(now[i].position);
      momenta +=
          mass * (length(now[i].velocity) + arm * std::abs(now[i].angular_velocity)) + length(after[i].force) * dt;
      moments += mass * length(now[i].position) * length(now[i].velocity) +
                 masses[i].inertia * std::abs(now[i].angular_velocity);
      pulls += length(after[i].force);
      turns += length(now[i].position) * length(after[i].force) + std::abs(after[i].torque);
      const Vec unexplained = now[i].velocity - then[i].velocity - dt / (2 * mass) * (before[i].force + after[i].force);
      const double speed = std::max(length(now[i].velocity), length(then[i].velocity));
      pushed_out += mass * length(unexplained) * (stepping.contact_gap() + stepping.impact_lag * stepping.h * speed);
    }
    size = std::max(size, momenta);
    angular_size = std::max(angular_size, moments);
    force_size = std::max(force_size, pulls);
    torque_size = std::max(torque_size, turns);
    const double summed = 0x1p-53 * static_cast<double>(2 * now.size() + moment);
    const double time = trace.time(moment);
    const Momentum has = forces.conserved().momentum(now);
    const double lead = drift * stepping.h;
    const Vec missing = has.linear - first.linear - impulse + lead * (is.force - at_start.force);
    linear.add(length(missing),
               slope_share * dt * force_change + passed + nu * size + summed * (size + time * force_size),
               scales.linear, time, [] { return ""; });
    angular.add(std::abs(has.angular - first.angular - angular_impulse + lead * (is.torque - at_start.torque)),
                slope_share * dt * torque_change + passed_torque + pushed_out + nu * angular_size +
                    summed * (angular_size + time * torque_size),
                scales.angular, time, [] { return ""; });
    before = after;
  }
  Missed missed{.linear = linear.result()};
  if (may_rotate(scene)) missed.angular = angular.result();
  return missed;
}

std::optional<InvariantCheck> check_total(const InvariantContext& context,
                                          std::optional<InvariantCheck> Missed::*which) {
  if (!is_closed(context.scene)) return std::nullopt;
  const auto as_stated = missed_with(context, context.stepping.drift).*which;
  const auto better = missed_with(context, 0).*which;
  if (!as_stated) return std::nullopt;
  return as_stated->ratio <= better->ratio ? as_stated : better;
}

const Catalog<Invariant>::Entry linear{
    {.name = "momentum",
     .unit = "kg m/s",
     .definition =
         "the momentum of all bodies changes only by the forces of the scene, in scenes with nothing immovable",
     .check = [](const InvariantContext& context) { return check_total(context, &Missed::linear); }}};
const Catalog<Invariant>::Entry angular{
    {.name = "angular_momentum",
     .unit = "kg m^2/s",
     .definition =
         "the angular momentum about the world's origin changes only by the torques of the scene, in scenes with "
         "nothing immovable",
     .check = [](const InvariantContext& context) { return check_total(context, &Missed::angular); }}};

// Bodies whose impulses are all known.
std::vector<bool> known_bodies(const Scene& scene) {
  std::vector<bool> known;
  for (const Body& body : scene.bodies) {
    known.push_back(body.type == BodyType::dynamic && body.linear_damping == 0);
  }
  for (const Joint& joint : scene.joints) {
    std::visit([&](const auto& of) { known[of.a] = known[of.b] = false; }, joint);
  }
  return known;
}

// The states with the mean velocities between two moments.
std::vector<BodyState> mean_motion(std::span<const BodyState> then, std::span<const BodyState> now, double dt) {
  std::vector<BodyState> mean(then.begin(), then.end());
  for (std::size_t i = 0; i < mean.size(); ++i) {
    mean[i].velocity = (1 / dt) * (now[i].position - then[i].position);
    mean[i].angular_velocity = (now[i].angle - then[i].angle) / dt;
  }
  return mean;
}

// m dv = sum of the contact impulses + the integral of the forces over the step, for each body without damping or
// joints (whose impulses are not reported). The tolerance covers:
// - Forces are known at both ends of the step (see AppliedForces::change_in).
// - A contact has one reported normal for a step in which its bodies rotate, w dt, and a round body rolls over a corner
//   or past another, V dt/r. Whether a method reports the normal of the start, of the end or of a sub-step in between,
//   it is off by at most that angle.
// - A body that is put to sleep loses the velocity it had, and reports the impulses of its last step awake, in which
//   the velocity may have changed by as much.
// - Velocities and impulses are rounded in every iteration, at every contact, including those of the other body, and
//   rounding errors of the largest so far may come out in any later step; a body that was pushed out of another within
//   a step had at least the velocity of its way. No velocity at a contact is smaller than what the rounding of a place
//   makes of its gap, u |x| / h. The reported time, n dt, is rounded too, and with it dt, their difference.
// Where what is reported is not the sum over a step, only that of a body without a contact is known, zero; and only if
// the method solves once a step, so that no contact can have come and gone.
std::optional<InvariantCheck> check_bodies(const InvariantContext& context) {
  const auto& [scene, trace, stepping, neighbours] = context;
  const std::vector<bool> known = known_bodies(scene);
  if (std::find(known.begin(), known.end(), true) == known.end()) return std::nullopt;
  const bool one_solve = stepping.h == stepping.dt;
  if (auto cannot = without_contacts(context, !one_solve)) return cannot;
  const AppliedForces forces(scene);
  const auto masses = forces.masses();
  std::vector<double> largest(scene.bodies.size());
  WorstViolation worst;
  std::vector<Wrench> before = forces.at(trace.states(0));
  for (std::size_t moment = 1; moment < trace.size(); ++moment) {
    const double dt = trace.time(moment) - trace.time(moment - 1);
    const auto then = trace.states(moment - 1);
    const auto now = trace.states(moment);
    const std::vector<Wrench> after = forces.at(now);
    const std::vector<WrenchError> off = forces.change_in(then, now, dt);
    const std::vector<BodyState> mean = mean_motion(then, now, dt);
    std::vector<Vec> received(scene.bodies.size());
    std::vector<double> impulses(scene.bodies.size());  // sum of their sizes
    std::vector<double> size(scene.bodies.size());
    std::vector<double> uncertainty(scene.bodies.size());
    std::vector<double> contacts(scene.bodies.size());
    const auto speed = [&](std::size_t body) {
      return length(then[body].velocity) + length(now[body].velocity) +
             (dt > 0 ? length(now[body].position - then[body].position) / dt : 0);
    };
    for (const ContactState& contact : trace.contacts(moment)) {
      const Vec impulse = impulse_of(contact);
      received[contact.a] = received[contact.a] - impulse;
      received[contact.b] = received[contact.b] + impulse;
      const double turned =
          std::max({normal_rotation(scene, contact, then, dt), normal_rotation(scene, contact, mean, dt),
                    normal_rotation(scene, contact, now, dt)});
      for (const std::size_t body : {contact.a, contact.b}) {
        size[body] += length(impulse) + masses[body].mass * (speed(contact.a) + speed(contact.b));
        impulses[body] += length(impulse);
        ++contacts[body];
        uncertainty[body] += std::min(2.0, turned) * length(impulse);
      }
    }
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      if (!known[i] || (!stepping.whole_impulses && contacts[i] > 0)) continue;
      const double mass = masses[i].mass;
      const Vec force = 0.5 * (before[i].force + after[i].force);
      const Vec missing = mass * (now[i].velocity - then[i].velocity) - received[i] - dt * force;
      largest[i] = std::max(largest[i],
                            mass * (length(then[i].velocity) + length(now[i].velocity)) + size[i] + dt * length(force));
      if (contacts[i] > 0 && stepping.h > 0) {
        largest[i] = std::max(largest[i], mass * stepping.epsilon * length(now[i].position) / stepping.h);
      }
      const double stopped = now[i].velocity == Vec{} ? 2 * mass * stepping.rest_speed : 0;
      const double tolerance = stopped + dt * off[i].force + uncertainty[i] +
                               solver_rounding(stepping) * (1 + contacts[i]) * largest[i] +
                               2 * 0x1p-53 * trace.time(moment) * length(force);
      // Without forces and contacts, the body's inertia is what is tested.
      const double pushed = std::max(impulses[i], dt * length(force));
      worst.add(length(missing), tolerance, pushed > 0 ? pushed : mass * length(then[i].velocity), trace.time(moment),
                [&] { return context.scene.bodies[i].name; });
    }
    before = after;
  }
  return worst.result();
}

const Catalog<Invariant>::Entry of_bodies{
    {.name = "momentum_of_bodies",
     .unit = "kg m/s",
     .definition = "the momentum of a body changes only by the reported contact impulses and the forces of the scene",
     .check = check_bodies}};

}  // namespace
}  // namespace plumb::invariants::momentum
