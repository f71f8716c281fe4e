#include <cmath>
#include <vector>

#include "reports/invariant.h"
#include "reports/overlap.h"
#include "reports/roundings.h"
#include "reports/vec.h"
#include "scenarios/catalog.h"
#include "scenarios/mass.h"

// What does not touch does not push: gap times impulse is zero, the gap measured by the scene's shapes. A step shows
// the gap of its end, but the push was at some moment of it: a pair may have come and gone by its way in a step,
// dt (V before + V after), V the speed of one seen from the other at the place of the contact, and by the speed that
// the push alone gives them, should another take it away again. Within the gap that the method states it may push, and
// another contact's correction may move it as far.
namespace plumb {
namespace {

Vec velocity_at(const BodyState& state, Vec point) {
  const Vec arm = point - state.position;
  return state.velocity + state.angular_velocity * Vec{-arm.y, arm.x};
}

double slip(const ContactState& contact, std::span<const BodyState> states) {
  return length(velocity_at(states[contact.b], contact.point) - velocity_at(states[contact.a], contact.point));
}

std::optional<InvariantCheck> check(const Ground& ground) {
  const auto& [scene, trace, stepping] = ground;
  if (!reveals_contacts(trace)) return not_revealed();
  const Overlap overlap(scene);
  const double nu = roundings(trace, stepping);
  std::vector<double> lightness;  // 1/kg
  for (const Body& body : scene.bodies) {
    const double mass = mass_of(body).mass;
    lightness.push_back(mass > 0 ? 1 / mass : 0);
  }
  Worst worst;
  for (std::size_t moment = 1; moment < trace.size(); ++moment) {
    const double dt = trace.time(moment) - trace.time(moment - 1);
    const auto states = trace.states(moment);
    for (const ContactState& contact : trace.contacts(moment)) {
      if (contact.normal_impulse <= 0) continue;
      const double gap = overlap.gap(contact.a, contact.b, states);
      const double given = contact.normal_impulse * (lightness[contact.a] + lightness[contact.b]);
      const double way = dt * (slip(contact, trace.states(moment - 1)) + slip(contact, states) + given);
      const double rounded = nu * (length(contact.point) + trace.times().back() * slip(contact, states));
      worst.see(contact.normal_impulse * gap, contact.normal_impulse * (2 * stepping.gap + way + rounded),
                trace.time(moment), [&] { return pair_name(ground.scene, contact.a, contact.b); });
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
}  // namespace plumb
