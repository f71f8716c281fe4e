#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "reports/judge/acting.h"
#include "reports/judge/invariant.h"
#include "reports/judge/roundings.h"
#include "reports/vec.h"
#include "scenarios/catalog.h"

// m dv = sum of the contacts' impulses + the integral of the forces over the step, for each body without joints or
// damping (whose impulses nobody shows).
// Forces are known at both ends of the step; whichever a method takes, it is off from their mean by half the difference
// times dt, and within the step by as much again.
// A contact shows one normal for a step in which its bodies turn, w dt, and a round one rolls over a corner or past
// another, V dt/r: by that angle a method of several sub-steps or impacts a step, which adds up pushes, is off.
// A body that sleeping stopped has lost the speed it had, and shows the impulses of its last step awake, in which that
// may have changed by as much.
// Speeds and impulses are rounded in every sweep, at every contact, those of the other body too, and what that leaves
// of the largest so far may go in any step after; so is the time that is shown, n dt, from which dt is taken.
namespace plumb::invariants::momentum_of_bodies {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

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

// m, from the centre to the curve that a body meets others with; nothing where it has none.
std::optional<double> curve_of(const Body& body) {
  std::optional<double> radius;
  for (const Shape& shape : body.shapes) {
    const auto* circle = std::get_if<Circle>(&shape.geometry);
    const auto* capsule = std::get_if<Capsule>(&shape.geometry);
    if (circle == nullptr && capsule == nullptr) continue;
    radius = std::min(radius.value_or(infinity), circle != nullptr ? circle->radius : capsule->radius);
  }
  return radius;
}

bool is_flat(const Body& body) {
  return std::all_of(body.shapes.begin(), body.shapes.end(),
                     [](const Shape& shape) { return std::holds_alternative<HalfSpace>(shape.geometry); });
}

// rad, by which a contact's normal may turn in a step.
double turning(const Scene& scene, const ContactState& contact, std::span<const BodyState> states, double dt) {
  const BodyState& a = states[contact.a];
  const BodyState& b = states[contact.b];
  const double turned = dt * (std::abs(a.angular_velocity) + std::abs(b.angular_velocity));
  if (is_flat(scene.bodies[contact.a]) || is_flat(scene.bodies[contact.b])) return turned;
  const auto of_a = curve_of(scene.bodies[contact.a]);
  const auto of_b = curve_of(scene.bodies[contact.b]);
  if (!of_a && !of_b) return turned;
  return turned + dt * length(b.velocity - a.velocity) / (of_a.value_or(0) + of_b.value_or(0));
}

// What moves evenly from one moment to the next.
std::vector<BodyState> evenly(std::span<const BodyState> then, std::span<const BodyState> now, double dt) {
  std::vector<BodyState> mean(then.begin(), then.end());
  for (std::size_t i = 0; i < mean.size(); ++i) {
    mean[i].velocity = (1 / dt) * (now[i].position - then[i].position);
    mean[i].angular_velocity = (now[i].angle - then[i].angle) / dt;
  }
  return mean;
}

std::optional<InvariantCheck> check(const InvariantContext& context) {
  const auto& [scene, trace, stepping] = context;
  const std::vector<bool> known = known_bodies(scene);
  if (std::find(known.begin(), known.end(), true) == known.end()) return std::nullopt;
  if (!reports_contacts(trace) || !stepping.whole_impulses) return not_reported();
  const Acting acting(scene);
  const auto masses = acting.masses();
  // One solve a step, on the normals that it shows.
  const bool together = stepping.h == stepping.dt && stepping.impact_lag > 0;
  std::vector<double> largest(scene.bodies.size());
  Worst worst;
  std::vector<Push> before = acting.on(trace.states(0));
  for (std::size_t moment = 1; moment < trace.size(); ++moment) {
    const double dt = trace.time(moment) - trace.time(moment - 1);
    const auto then = trace.states(moment - 1);
    const auto now = trace.states(moment);
    const std::vector<Push> after = acting.on(now);
    const std::vector<BodyState> mean = evenly(then, now, dt);
    std::vector<Vec> given(scene.bodies.size());
    std::vector<double> size(scene.bodies.size());
    std::vector<double> unsure(scene.bodies.size());
    std::vector<double> contacts(scene.bodies.size());
    const auto speed = [&](std::size_t body) { return length(then[body].velocity) + length(now[body].velocity); };
    for (const ContactState& contact : trace.contacts(moment)) {
      const Vec side{-contact.normal.y, contact.normal.x};
      const Vec impulse = contact.normal_impulse * contact.normal + contact.tangent_impulse * side;
      given[contact.a] = given[contact.a] - impulse;
      given[contact.b] = given[contact.b] + impulse;
      const double turned = together ? 0
                                     : std::max({turning(scene, contact, then, dt), turning(scene, contact, mean, dt),
                                                 turning(scene, contact, now, dt)});
      for (const std::size_t body : {contact.a, contact.b}) {
        size[body] += length(impulse) + masses[body].mass * (speed(contact.a) + speed(contact.b));
        ++contacts[body];
        unsure[body] += std::min(2.0, turned) * length(impulse);
      }
    }
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      if (!known[i]) continue;
      const double mass = masses[i].mass;
      const Vec force = 0.5 * (before[i].force + after[i].force);
      const Vec missing = mass * (now[i].velocity - then[i].velocity) - given[i] - dt * force;
      largest[i] = std::max(largest[i],
                            mass * (length(then[i].velocity) + length(now[i].velocity)) + size[i] + dt * length(force));
      const double stopped = now[i].velocity == Vec{} ? 2 * mass * stepping.rest_speed : 0;
      const double allowed = stopped + dt * length(after[i].force - before[i].force) + unsure[i] +
                             roundings_of_solver(stepping) * (1 + contacts[i]) * largest[i] +
                             2 * 0x1p-53 * trace.time(moment) * length(force);
      worst.see(length(missing), allowed, trace.time(moment), [&] { return context.scene.bodies[i].name; });
    }
    before = after;
  }
  return worst.result();
}

const Catalog<Invariant>::Entry entry{
    {.name = "momentum_of_bodies",
     .unit = "kg m/s",
     .definition = "the momentum of a body changes by the contact impulses shown and the forces of the scene, and by "
                   "nothing else",
     .check = check}};

}  // namespace
}  // namespace plumb::invariants::momentum_of_bodies
