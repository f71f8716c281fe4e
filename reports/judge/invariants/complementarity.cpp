#include <cmath>
#include <vector>

#include "reports/judge/invariant.h"
#include "reports/judge/overlap.h"
#include "reports/judge/roundings.h"
#include "reports/vec.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/mass.h"

// What does not touch does not push: gap times impulse is zero, the gap measured by the scene's shapes. A step shows
// the gap of its end, but the push was at some moment of it: a pair may have come and gone by its way in a step,
// dt (V before + V after), V the speed of one seen from the other at the place of the contact, and by the speed that
// the step's pushes give both there, this one and those of third bodies: one may set in motion what another stops again
// before the step ends. Within the gap that the method states it may push, and another contact's correction may move it
// as far.
namespace plumb::invariants::complementarity {
namespace {

Vec velocity_at(const BodyState& state, Vec point) {
  const Vec arm = point - state.position;
  return state.velocity + state.angular_velocity * Vec{-arm.y, arm.x};
}

double slip(const ContactState& contact, std::span<const BodyState> states) {
  return length(velocity_at(states[contact.b], contact.point) - velocity_at(states[contact.a], contact.point));
}

Vec arm_of(const ContactState& contact, const Mass& mass, const BodyState& state) {
  return contact.point - (state.position + rotated(mass.center, state.angle));
}

/// What all pushes of a step can have given a body at most, whichever came first.
struct Given {
  double speed = 0;  // m/s, of the centre of mass
  double spin = 0;   // rad/s
};

/// Of each body.
std::vector<Given> given_in(std::span<const ContactState> contacts, std::span<const BodyState> states,
                            std::span<const Mass> masses) {
  std::vector<Given> given(states.size());
  for (const ContactState& contact : contacts) {
    const Vec tangent{-contact.normal.y, contact.normal.x};
    const Vec impulse = contact.normal_impulse * contact.normal + contact.tangent_impulse * tangent;
    for (const std::size_t body : {contact.a, contact.b}) {
      const Mass& mass = masses[body];
      if (mass.mass > 0) given[body].speed += length(impulse) / mass.mass;
      if (mass.inertia > 0) {
        given[body].spin += std::abs(cross(arm_of(contact, mass, states[body]), impulse)) / mass.inertia;
      }
    }
  }
  return given;
}

std::optional<InvariantCheck> check(const InvariantContext& context) {
  const auto& [scene, trace, stepping] = context;
  if (!reports_contacts(trace)) return not_reported();
  const Overlap overlap(scene);
  const double nu = roundings(trace, stepping);
  std::vector<Mass> masses;
  for (const Body& body : scene.bodies) masses.push_back(mass_of(body));
  Worst worst;
  for (std::size_t moment = 1; moment < trace.size(); ++moment) {
    const double dt = trace.time(moment) - trace.time(moment - 1);
    const auto states = trace.states(moment);
    const std::vector<Given> given = given_in(trace.contacts(moment), states, masses);
    for (const ContactState& contact : trace.contacts(moment)) {
      if (contact.normal_impulse <= 0) continue;
      const double gap = overlap.gap(contact.a, contact.b, states);
      double way = dt * (slip(contact, trace.states(moment - 1)) + slip(contact, states));
      for (const std::size_t body : {contact.a, contact.b}) {
        const double arm = length(arm_of(contact, masses[body], states[body]));
        way += dt * (given[body].speed + given[body].spin * arm);
      }
      const double rounded = nu * (length(contact.point) + trace.times().back() * slip(contact, states));
      worst.see(contact.normal_impulse * gap, contact.normal_impulse * (2 * stepping.gap + way + rounded),
                trace.time(moment), [&] { return pair_name(context.scene, contact.a, contact.b); });
    }
  }
  return worst.result();
}

const Catalog<Invariant>::Entry entry{
    {.name = "complementarity",
     .unit = "N s m",
     .definition = "what does not touch does not push: gap, by the scene's shapes, times normal impulse",
     .check = check}};

}  // namespace
}  // namespace plumb::invariants::complementarity
