#include <algorithm>
#include <cmath>
#include <span>
#include <variant>
#include <vector>

#include "reports/acting.h"
#include "reports/invariant.h"
#include "reports/roundings.h"
#include "reports/vec.h"
#include "scenarios/catalog.h"

// m dv = sum of the contacts' impulses + the integral of the forces over the step, for each body without joints or
// damping (whose impulses nobody shows).
// Forces are known at both ends of the step; whichever a method takes, it is off from their mean by half the difference
// times dt, and within the step by as much again.
// A contact shows one normal for a step in which its bodies turn, w dt, and round ones pass each other, V dt/d, d
// apart: by that angle a method of several sub-steps or impacts a step, which adds up pushes, is off. Speeds and
// impulses are rounded in every sweep; so is the time that is shown, n dt, from which dt is taken.
namespace plumb {
namespace {

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

bool is_round(const Body& body) {
  return std::any_of(body.shapes.begin(), body.shapes.end(), [](const Shape& shape) {
    return std::holds_alternative<Circle>(shape.geometry) || std::holds_alternative<Capsule>(shape.geometry);
  });
}

// rad, by which a contact's normal may turn in a step.
double turning(const Scene& scene, const ContactState& contact, std::span<const BodyState> states, double dt) {
  const BodyState& a = states[contact.a];
  const BodyState& b = states[contact.b];
  if (!is_round(scene.bodies[contact.a]) || !is_round(scene.bodies[contact.b])) {
    return dt * (std::abs(a.angular_velocity) + std::abs(b.angular_velocity));
  }
  return dt * length(b.velocity - a.velocity) / length(b.position - a.position);
}

std::optional<InvariantCheck> check(const Ground& ground) {
  const auto& [scene, trace, stepping] = ground;
  const std::vector<bool> known = known_bodies(scene);
  if (std::find(known.begin(), known.end(), true) == known.end()) return std::nullopt;
  if (!reveals_contacts(trace) || !stepping.whole_impulses) return not_revealed();
  const Acting acting(scene);
  const auto masses = acting.masses();
  Worst worst;
  std::vector<Push> before = acting.on(trace.states(0));
  for (std::size_t moment = 1; moment < trace.size(); ++moment) {
    const double dt = trace.time(moment) - trace.time(moment - 1);
    const auto then = trace.states(moment - 1);
    const auto now = trace.states(moment);
    const std::vector<Push> after = acting.on(now);
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
      const double turned = std::max(turning(scene, contact, then, dt), turning(scene, contact, now, dt));
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
      const double rounded = mass * (length(then[i].velocity) + length(now[i].velocity)) + size[i] + dt * length(force);
      const double allowed = dt * length(after[i].force - before[i].force) + unsure[i] +
                             roundings_of_solver(stepping) * (1 + contacts[i]) * rounded +
                             2 * 0x1p-53 * trace.time(moment) * length(force);
      worst.see(length(missing), allowed, trace.time(moment), [&] { return scene.bodies[i].name; });
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
}  // namespace plumb
