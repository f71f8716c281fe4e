// The laws of contact: pushing only, complementarity of gap and impulse, Coulomb's cone, and sticking below it.
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "reports/judge/contacts.h"
#include "reports/judge/invariant.h"
#include "reports/judge/overlap.h"
#include "reports/judge/rounding.h"
#include "reports/vec.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/mass.h"

namespace plumb::invariants::contact_laws {
namespace {

std::vector<Mass> masses_of(const Scene& scene) {
  std::vector<Mass> masses;
  for (const Body& body : scene.bodies) masses.push_back(mass_of(body));
  return masses;
}

// Every reported impulse is off by the rounding of its terms: a share of the largest that acts in that step.
std::optional<InvariantCheck> check_push(const InvariantContext& context) {
  if (!context.trace.has_contacts()) return not_reported();
  WorstViolation worst;
  for (std::size_t moment = 0; moment < context.trace.size(); ++moment) {
    double largest = 0;
    for (const ContactState& contact : context.trace.contacts(moment)) {
      largest = std::max(largest, std::abs(contact.normal_impulse));
    }
    for (const ContactState& contact : context.trace.contacts(moment)) {
      worst.add(-contact.normal_impulse, solver_rounding(context.stepping) * largest, context.trace.time(moment),
                [&] { return pair_name(context.scene, contact.a, contact.b); });
    }
  }
  return worst.result();
}

// |t| <= mu n holds for every impulse and so for their sums over a step. A first-order method, or one that iterates
// over the contacts, may bound friction by an earlier normal impulse (see stale_impulse_error).
std::optional<InvariantCheck> check_cone(const InvariantContext& context) {
  if (!context.trace.has_contacts()) return not_reported();
  if (!context.stepping.whole_impulses) return not_reported();
  const FrictionBounds friction(context.scene);
  WorstViolation worst;
  for (std::size_t moment = 0; moment < context.trace.size(); ++moment) {
    double largest = 0;
    for (const ContactState& contact : context.trace.contacts(moment)) {
      largest = std::max({largest, std::abs(contact.normal_impulse), std::abs(contact.tangent_impulse)});
    }
    const auto before = moment > 0 ? context.trace.contacts(moment - 1) : std::span<const ContactState>{};
    const auto contacts = context.trace.contacts(moment);
    const std::vector<double> stale = stale_impulse_error(before, contacts, context.stepping);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const ContactState& contact = contacts[i];
      const double mu = friction.largest_static(contact.a, contact.b);
      const double most = mu * std::max(0.0, contact.normal_impulse);
      worst.add(std::abs(contact.tangent_impulse) - most, mu * stale[i] + solver_rounding(context.stepping) * largest,
                context.trace.time(moment), [&] { return pair_name(context.scene, contact.a, contact.b); });
    }
  }
  return worst.result();
}

Vec arm_of(const ContactState& contact, const Mass& mass, const BodyState& state) {
  return contact.point - (state.position + rotated(mass.center, state.angle));
}

/// The most that the impulses of a step can change a body's velocity, in whatever order they act.
struct VelocityBound {
  double speed = 0;  // m/s, of the centre of mass
  double spin = 0;   // rad/s
};

/// By body.
std::vector<VelocityBound> velocity_bounds(std::span<const ContactState> contacts, std::span<const BodyState> states,
                                           std::span<const Mass> masses) {
  std::vector<VelocityBound> bounds(states.size());
  for (const ContactState& contact : contacts) {
    const Vec impulse = impulse_of(contact);
    for (const std::size_t body : {contact.a, contact.b}) {
      const Mass& mass = masses[body];
      if (mass.mass > 0) bounds[body].speed += length(impulse) / mass.mass;
      if (mass.inertia > 0) {
        bounds[body].spin += std::abs(cross(arm_of(contact, mass, states[body]), impulse)) / mass.inertia;
      }
    }
  }
  return bounds;
}

double slip_speed(const ContactState& contact, std::span<const BodyState> states) {
  return length(relative_velocity(contact, states));
}

// Gap times normal impulse is zero, the gap measured by the scene's shapes. A trace gives the gap at the end of a step,
// but the impulse acted at some moment within it. In between, the pair may have moved by dt (V before + V after), V the
// relative velocity at the contact, and by dt times the velocity that the step's impulses can give both bodies there;
// those of third bodies count too, because one impulse may start a motion that another stops within the step. Within
// the gap that the method states it may push, and the correction of another contact may move the pair as far again.
std::optional<InvariantCheck> check_complementarity(const InvariantContext& context) {
  const auto& [scene, trace, stepping] = context;
  if (!trace.has_contacts()) return not_reported();
  const Overlap overlap(scene);
  const double nu = trace_rounding(trace, stepping);
  const std::vector<Mass> masses = masses_of(scene);
  WorstViolation worst;
  for (std::size_t moment = 1; moment < trace.size(); ++moment) {
    const double dt = trace.time(moment) - trace.time(moment - 1);
    const auto states = trace.states(moment);
    const std::vector<VelocityBound> bounds = velocity_bounds(trace.contacts(moment), states, masses);
    for (const ContactState& contact : trace.contacts(moment)) {
      if (contact.normal_impulse <= 0) continue;
      const double gap = overlap.gap(contact.a, contact.b, states);
      double path = dt * (slip_speed(contact, trace.states(moment - 1)) + slip_speed(contact, states));
      for (const std::size_t body : {contact.a, contact.b}) {
        const double arm = length(arm_of(contact, masses[body], states[body]));
        path += dt * (bounds[body].speed + bounds[body].spin * arm);
      }
      const double rounded = nu * (length(contact.point) + trace.times().back() * slip_speed(contact, states));
      worst.add(contact.normal_impulse * gap, contact.normal_impulse * (2 * stepping.contact_gap() + path + rounded),
                trace.time(moment), [&] { return pair_name(context.scene, contact.a, contact.b); });
    }
  }
  return worst.result();
}

// m/s, of b against a along the tangent.
double tangential_velocity(const ContactState& contact, std::span<const BodyState> states) {
  return cross(contact.normal, relative_velocity(contact, states));
}

// 1/kg: the most that an impulse at a distance from the centre changes the velocity there.
double inverse_mass_at(const Mass& mass, double distance) {
  if (mass.mass == 0) return 0;
  return 1 / mass.mass + (mass.inertia > 0 ? distance * distance / mass.inertia : 0);
}

// A sliding contact uses all of its friction: slip times the unused part of the cone, mu n - |t|, is zero. A contact
// that started or stopped sliding within the step stuck for part of it, so the slip is the smaller of those before and
// after. It may reach what the method states as creep; what the forces add in a step while friction balances those of
// the last one, g dt, and w V dt as the contact point moves around; and all that the step's impulses give the two
// bodies, which may have stopped the slide in between. A first-order method may bound friction by an earlier normal
// impulse, as in the cone.
std::optional<InvariantCheck> check_sticking(const InvariantContext& context) {
  const auto& [scene, trace, stepping] = context;
  if (!trace.has_contacts() || !stepping.whole_impulses) return not_reported();
  const FrictionBounds friction(scene);
  const std::vector<Mass> masses = masses_of(scene);
  WorstViolation worst;
  for (std::size_t moment = 1; moment < trace.size(); ++moment) {
    const double dt = trace.time(moment) - trace.time(moment - 1);
    const auto then = trace.states(moment - 1);
    const auto now = trace.states(moment);
    std::vector<double> received(scene.bodies.size());  // m/s, at the contacts
    for (const ContactState& contact : trace.contacts(moment)) {
      for (const std::size_t body : {contact.a, contact.b}) {
        received[body] += std::hypot(contact.normal_impulse, contact.tangent_impulse) *
                          inverse_mass_at(masses[body], length(contact.point - now[body].position));
      }
    }
    const auto contacts = trace.contacts(moment);
    double largest = 0;
    for (const ContactState& contact : contacts) largest = std::max(largest, std::abs(contact.normal_impulse));
    const std::vector<double> stale = stale_impulse_error(trace.contacts(moment - 1), contacts, stepping);
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      const ContactState& contact = contacts[c];
      const double mu = friction.smallest_dynamic(contact.a, contact.b);
      const double unused = mu * contact.normal_impulse - std::abs(contact.tangent_impulse);
      const double before = tangential_velocity(contact, then);
      const double after = tangential_velocity(contact, now);
      if (unused <= 0 || before * after <= 0) continue;
      const double moved_point =
          dt * (std::abs(now[contact.a].angular_velocity) + std::abs(now[contact.b].angular_velocity)) *
          (length(now[contact.a].velocity) + length(now[contact.b].velocity));
      const double speeds = length(now[contact.a].velocity) + length(now[contact.b].velocity);
      const double slip_tolerance = stepping.creep + dt * length(scene.gravity) + moved_point + received[contact.a] +
                                    received[contact.b] + solver_rounding(stepping) * speeds;
      const double certain = std::max(0.0, unused - mu * stale[c] - solver_rounding(stepping) * mu * largest);
      worst.add(certain * std::min(std::abs(before), std::abs(after)), certain * slip_tolerance, trace.time(moment),
                [&] { return pair_name(context.scene, contact.a, contact.b); });
    }
  }
  return worst.result();
}

const Catalog<Invariant>::Entry push{{.name = "push",
                                      .unit = "N s",
                                      .definition = "contacts only push: no normal impulse is negative",
                                      .check = check_push}};
const Catalog<Invariant>::Entry cone{
    {.name = "cone",
     .unit = "N s",
     .definition = "friction stays in its cone: no tangential impulse exceeds the normal one times the coefficient",
     .check = check_cone}};
const Catalog<Invariant>::Entry complementarity{
    {.name = "complementarity",
     .unit = "N s m",
     .definition = "bodies that do not touch do not push: gap, from the scene's shapes, times normal impulse",
     .check = check_complementarity}};
const Catalog<Invariant>::Entry sticking{
    {.name = "sticking",
     .unit = "N m",
     .definition = "a sliding contact uses all of its friction: the smaller slip of before and after the step, times "
                   "the unused friction",
     .check = check_sticking}};

}  // namespace
}  // namespace plumb::invariants::contact_laws
