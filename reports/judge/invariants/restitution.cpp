// Nothing bounces higher than its restitution allows.
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "reports/judge/contacts.h"
#include "reports/judge/invariant.h"
#include "reports/judge/mechanics.h"
#include "reports/judge/neighbours.h"
#include "reports/judge/rounding.h"
#include "reports/vec.h"
#include "scenarios/catalog.h"

// Newton's law: an impact at approach speed V ends with at most e V of separation, in whatever way friction acts. It is
// checked where nothing else can change the velocity at the contact: one contact point of two bodies that no joint
// holds and that, by their shapes, touch nothing else within the step. What separates already may go on. The tolerance
// covers what happens in the step before and after the impact, at both speeds (1 + e):
// - forces, and the centripetal acceleration w^2 r of a point at an arm r: dt (|F|/m + |T| r/I + w^2 r);
// - the normal, which turns with the bodies: dt w times their relative velocity;
// and the gap that the method states, pushed out within the step; and an iterated method's last change (see
// stale_impulse_error) of the approach speed; and round-off.
namespace plumb::invariants::restitution {
namespace {

double largest_restitution(const Scene& scene, std::size_t a, std::size_t b) {
  double largest = 0;
  for (const Shape& one : scene.bodies[a].shapes) {
    for (const Shape& other : scene.bodies[b].shapes) {
      largest = std::max(largest, mixed_restitution(scene.mixing, one.surface, other.surface));
    }
  }
  return largest;
}

class Restitution {
 public:
  explicit Restitution(const InvariantContext& context)
      : context_(context),
        forces_(context.scene),
        neighbours_(context.scene, context.trace, context.stepping),
        held_(context.scene.bodies.size()) {
    for (const Joint& joint : context.scene.joints) {
      std::visit([&](const auto& kind) { held_[kind.a] = held_[kind.b] = true; }, joint);
    }
  }

  InvariantCheck check() {
    for (std::size_t moment = 1; moment < context_.trace.size(); ++moment) {
      const auto contacts = context_.trace.contacts(moment);
      if (contacts.empty()) continue;
      std::vector<int> touching(held_.size());
      for (const BodyGap& pair : neighbours_.in_step(moment)) {
        ++touching[pair.a];
        ++touching[pair.b];
      }
      std::vector<int> points(held_.size());
      for (const ContactState& contact : contacts) {
        ++points[contact.a];
        ++points[contact.b];
      }
      const auto alone = [&](std::size_t i) {
        return mass(i) == 0 || (!held_[i] && touching[i] == 1 && points[i] == 1);
      };
      for (const ContactState& contact : contacts) {
        if (contact.normal_impulse > 0 && alone(contact.a) && alone(contact.b)) add(moment, contact);
      }
    }
    return worst_.result();
  }

 private:
  double mass(std::size_t body) const { return forces_.masses()[body].mass; }

  void add(std::size_t moment, const ContactState& contact) {
    const auto& [scene, trace, stepping] = context_;
    const double dt = trace.time(moment) - trace.time(moment - 1);
    const auto then = trace.states(moment - 1);
    const auto now = trace.states(moment);
    const Vec before = relative_velocity(contact, then);
    const Vec after = relative_velocity(contact, now);
    const double approach = std::max(0.0, -dot(before, contact.normal));
    const double e = largest_restitution(scene, contact.a, contact.b);
    const std::vector<Wrench> wrenches = forces_.at(then);
    double change = 0;  // m/s, of the speed at the contact, apart from the impact
    double speeds = 0;
    for (const std::size_t i : {contact.a, contact.b}) {
      const double spin = std::max(std::abs(then[i].angular_velocity), std::abs(now[i].angular_velocity));
      change += dt * spin * std::max(length(before), length(after));
      speeds += length(then[i].velocity) + length(now[i].velocity);
      if (mass(i) == 0) continue;
      const double arm = length(contact.point - now[i].position);
      const double inertia = forces_.masses()[i].inertia;
      change += dt * (length(wrenches[i].force) / mass(i) + spin * spin * arm);
      if (inertia > 0) change += dt * std::abs(wrenches[i].torque) * arm / inertia;
      speeds += spin * arm;
    }
    const double n = stepping.iterations;
    const double iterated = n > 0 ? std::pow(n / (n + 1), n) / (n + 1) * approach : 0;
    const double tolerance =
        (1 + e) * change + stepping.contact_gap() / dt + iterated + solver_rounding(stepping) * speeds;
    const double most = std::max(e * approach, dot(before, contact.normal));
    worst_.add(dot(after, contact.normal) - most, tolerance, (1 - e) * approach, trace.time(moment),
               [&] { return pair_name(context_.scene, contact.a, contact.b); });
  }

  const InvariantContext& context_;
  AppliedForces forces_;
  Neighbours neighbours_;
  std::vector<bool> held_;  // by a joint
  WorstViolation worst_;
};

const Catalog<Invariant>::Entry entry{
    {.name = "restitution",
     .unit = "m/s",
     .definition = "nothing bounces higher than its restitution allows: speed at which two bodies that touch nothing "
                   "else separate, beyond that of their approach times the restitution",
     .check = [](const InvariantContext& context) -> std::optional<InvariantCheck> {
       if (context.scene.bodies.size() < 2) return std::nullopt;
       if (!context.trace.has_contacts()) return not_reported();
       return Restitution(context).check();
     }}};

}  // namespace
}  // namespace plumb::invariants::restitution
