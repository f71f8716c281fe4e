#include <algorithm>
#include <cmath>
#include <vector>

#include "reports/judge/coefficients.h"
#include "reports/judge/invariant.h"
#include "reports/judge/pushed.h"
#include "reports/judge/roundings.h"
#include "reports/vec.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/mass.h"

// Friction that slides is all used: slip times what is left of the cone, mu n - |t|, is zero. A contact that began or
// ended its slide in the step was stuck for a part of it: the slip counts that it has before and after, the smaller. It
// may be what the method calls creep, and what the forces add in a step while friction answers those of the last one:
// g dt, and w V dt as the place of the contact goes round; and all that the impulses of the step give to the two
// bodies, which may have brought the slide to a halt in between. A method of first order (drift) may hold friction to
// the push of a step before, as in the cone.
namespace plumb::invariants::sticking {
namespace {

double along(const ContactState& contact, std::span<const BodyState> states) {
  const auto velocity = [&](const BodyState& state) {
    const Vec arm = contact.point - state.position;
    return state.velocity + state.angular_velocity * Vec{-arm.y, arm.x};
  };
  return cross(contact.normal, velocity(states[contact.b]) - velocity(states[contact.a]));
}

// 1/kg: what an impulse at a distance from the centre does to the velocity there, at most.
double lightness_at(const Mass& mass, double distance) {
  if (mass.mass == 0) return 0;
  return 1 / mass.mass + (mass.inertia > 0 ? distance * distance / mass.inertia : 0);
}

std::optional<InvariantCheck> check(const InvariantContext& context) {
  const auto& [scene, trace, stepping] = context;
  if (!reports_contacts(trace) || !stepping.whole_impulses) return not_reported();
  const Coefficients coefficients(scene);
  std::vector<Mass> masses;
  for (const Body& body : scene.bodies) masses.push_back(mass_of(body));
  Worst worst;
  for (std::size_t moment = 1; moment < trace.size(); ++moment) {
    const double dt = trace.time(moment) - trace.time(moment - 1);
    const auto then = trace.states(moment - 1);
    const auto now = trace.states(moment);
    std::vector<double> given(scene.bodies.size());  // m/s, at the contacts
    for (const ContactState& contact : trace.contacts(moment)) {
      for (const std::size_t body : {contact.a, contact.b}) {
        given[body] += std::hypot(contact.normal_impulse, contact.tangent_impulse) *
                       lightness_at(masses[body], length(contact.point - now[body].position));
      }
    }
    const auto contacts = trace.contacts(moment);
    double largest = 0;
    for (const ContactState& contact : contacts) largest = std::max(largest, std::abs(contact.normal_impulse));
    const std::vector<double> late = known_late(trace.contacts(moment - 1), contacts, stepping);
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      const ContactState& contact = contacts[c];
      const double mu = coefficients.sliding(contact.a, contact.b);
      const double unused = mu * contact.normal_impulse - std::abs(contact.tangent_impulse);
      const double before = along(contact, then);
      const double after = along(contact, now);
      if (unused <= 0 || before * after <= 0) continue;
      const double carried = dt *
                             (std::abs(now[contact.a].angular_velocity) + std::abs(now[contact.b].angular_velocity)) *
                             (length(now[contact.a].velocity) + length(now[contact.b].velocity));
      const double speeds = length(now[contact.a].velocity) + length(now[contact.b].velocity);
      const double allowed = stepping.creep + dt * length(scene.gravity) + carried + given[contact.a] +
                             given[contact.b] + roundings_of_solver(stepping) * speeds;
      const double left = std::max(0.0, unused - mu * late[c] - roundings_of_solver(stepping) * mu * largest);
      worst.see(left * std::min(std::abs(before), std::abs(after)), left * allowed, trace.time(moment),
                [&] { return pair_name(context.scene, contact.a, contact.b); });
    }
  }
  return worst.result();
}

const Catalog<Invariant>::Entry entry{
    {.name = "sticking",
     .unit = "N m",
     .definition = "what slides uses all of its friction: slip before and after the step, the smaller, times the "
                   "friction left unused",
     .check = check}};

}  // namespace
}  // namespace plumb::invariants::sticking
