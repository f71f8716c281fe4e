// The laws of contact: pushing only, complementarity of gap and impulse, Coulomb's cone, and sticking below it.
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "reference/scene_facts.h"
#include "reports/judge/contacts.h"
#include "reports/judge/groups.h"
#include "reports/judge/invariant.h"
#include "reports/judge/joint_geometry.h"
#include "reports/judge/overlap.h"
#include "reports/judge/rounding.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/vec.h"

namespace plumb::invariants::contact_laws {
namespace {

std::vector<Mass> masses_of(const Scene& scene) {
  std::vector<Mass> masses;
  for (const Body& body : scene.bodies) masses.push_back(mass_of(body));
  return masses;
}

// N s, by which every impulse reported of a step is off by rounding: a share of the largest that acts in it, and of the
// largest momentum that touches, as impulses are found from velocities, and these are rounded.
double impulse_rounding(const InvariantContext& context, std::size_t moment, std::span<const Mass> masses) {
  const auto states = context.trace.states(moment);
  double largest = 0;
  for (const ContactState& contact : context.trace.contacts(moment)) {
    largest = std::max({largest, std::abs(contact.normal_impulse), std::abs(contact.tangent_impulse)});
    for (const std::size_t body : {contact.a, contact.b}) {
      largest = std::max(largest, masses[body].mass * length(states[body].velocity));
    }
  }
  return solver_rounding(context.stepping) * largest;
}

std::optional<InvariantCheck> check_push(const InvariantContext& context) {
  if (auto cannot = without_contacts(context, false)) return cannot;
  const std::vector<Mass> masses = masses_of(context.scene);
  WorstViolation worst;
  for (std::size_t moment = 0; moment < context.trace.size(); ++moment) {
    const double rounded = impulse_rounding(context, moment, masses);
    for (const ContactState& contact : context.trace.contacts(moment)) {
      worst.add(-contact.normal_impulse, rounded, std::abs(contact.normal_impulse), context.trace.time(moment),
                [&] { return pair_name(context.scene, contact.a, contact.b); });
    }
  }
  return worst.result();
}

// |t| <= mu n holds for every impulse and so for their sums over a step. A first-order method, or one that iterates
// over the contacts, may bound friction by an earlier normal impulse (see stale_impulse_error). If its iterations end
// with no push at all, up to round-off, the push that its friction came from is not reported: that contact is no test.
std::optional<InvariantCheck> check_cone(const InvariantContext& context) {
  if (auto cannot = without_contacts(context, true)) return cannot;
  const FrictionBounds friction(context.scene);
  const std::vector<Mass> masses = masses_of(context.scene);
  WorstViolation worst;
  for (std::size_t moment = 0; moment < context.trace.size(); ++moment) {
    const double rounded = impulse_rounding(context, moment, masses);
    const auto before = moment > 0 ? context.trace.contacts(moment - 1) : std::span<const ContactState>{};
    const auto contacts = context.trace.contacts(moment);
    const std::vector<double> stale = stale_impulse_error(before, contacts, context.stepping);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const ContactState& contact = contacts[i];
      if (context.stepping.iterations > 0 && contact.normal_impulse <= rounded) continue;
      const double mu = friction.largest_static(contact.a, contact.b);
      const double most = mu * std::max(0.0, contact.normal_impulse);
      worst.add(std::abs(contact.tangent_impulse) - most, mu * stale[i] + rounded,
                mu > 0 ? most : std::max(0.0, contact.normal_impulse), context.trace.time(moment),
                [&] { return pair_name(context.scene, contact.a, contact.b); });
    }
  }
  return worst.result();
}

Vec arm_of(const ContactState& contact, const BodyState& state) { return contact.point - state.position; }

// m/s, the approach at a contact up to which it is loaded rather than struck: what gravity adds between two solves.
double load_speed(const InvariantContext& context) { return context.stepping.h * length(context.scene.gravity); }

/// The most that impulses in a step can change a body's velocity, in whatever order they act.
struct VelocityBound {
  double speed = 0;  // m/s, of the centre of mass
  double spin = 0;   // rad/s

  double at(double distance) const { return speed + spin * distance; }
};

VelocityBound given_by(const ContactState& contact, const Mass& mass, const BodyState& state) {
  VelocityBound bound;
  const Vec impulse = impulse_of(contact);
  if (mass.mass > 0) bound.speed = length(impulse) / mass.mass;
  if (mass.inertia > 0) bound.spin = std::abs(cross(arm_of(contact, state), impulse)) / mass.inertia;
  return bound;
}

// By body: what all impulses of a step may have changed between its ends without showing there, because one impulse
// may start a motion that another stops. That takes an impact, of a contact that closed before the step, or that opens
// after it though it pushed: where no contact of a group of touching bodies is struck, its impulses bear loads, and
// each acts against what the forces add. Joints pass impulses on, which nobody reports, and their motors give more. But
// constraints never add to the energy that an impulse J gives to bodies at rest (Bertrand), J^2 B/2 with B the inverse
// inertia at the contact, so no body of the group gets more speed by it than J sqrt(B/m).
std::vector<VelocityBound> hidden_changes(const InvariantContext& context, std::size_t moment,
                                          std::span<const Mass> masses, const JointGeometry& joints) {
  const auto contacts = context.trace.contacts(moment);
  const auto then = context.trace.states(moment - 1);
  const auto now = context.trace.states(moment);
  Groups groups(now.size());
  for (const ContactState& contact : contacts) {
    if (masses[contact.a].mass > 0 && masses[contact.b].mass > 0) groups.join(contact.a, contact.b);
  }
  std::vector<bool> jointed(now.size());
  for (std::size_t joint = 0; joint < joints.size(); ++joint) {
    const auto [a, b] = joints.bodies(joint);
    if (masses[a].mass > 0 && masses[b].mass > 0) groups.join(a, b);
    jointed[a] = jointed[b] = true;
  }
  std::vector<bool> has_impact(now.size());
  std::vector<bool> has_joint(now.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (jointed[i] && masses[i].mass > 0) has_joint[groups.of(i)] = true;
  }
  std::vector<VelocityBound> bounds(now.size());
  std::vector<double> driven(now.size());  // of a group, the root of twice the energy that motors can give it
  const double dt = context.trace.time(moment) - context.trace.time(moment - 1);
  for (std::size_t joint = 0; joint < joints.size(); ++joint) {
    const auto [a, b] = joints.bodies(joint);
    driven[groups.of(masses[a].mass > 0 ? a : b)] += std::sqrt(joints.drive(joint, dt));
  }
  std::vector<double> passed_on = driven;  // the same by impulses, too: the sum of J sqrt(B)
  for (const ContactState& contact : contacts) {
    double inverse = 0;  // 1/kg, B in any direction
    for (const std::size_t body : {contact.a, contact.b}) {
      if (masses[body].mass > 0) inverse += 1 / masses[body].mass;
      const Vec arm = arm_of(contact, now[body]);
      if (masses[body].inertia > 0) inverse += dot(arm, arm) / masses[body].inertia;
    }
    const std::size_t group = groups.of(masses[contact.a].mass > 0 ? contact.a : contact.b);
    passed_on[group] += length(impulse_of(contact)) * std::sqrt(inverse);
    const double closed = -dot(contact.normal, velocity_before(context.scene, contact, then, now));
    const double opens = dot(contact.normal, relative_velocity(contact, now));
    const bool impact = std::max(closed + driven[group] * std::sqrt(inverse), opens) > load_speed(context);
    for (const std::size_t body : {contact.a, contact.b}) {
      if (impact && masses[body].mass > 0) has_impact[groups.of(body)] = true;
      const VelocityBound by = given_by(contact, masses[body], now[body]);
      bounds[body].speed += by.speed;
      bounds[body].spin += by.spin;
    }
  }
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    if (!has_impact[groups.of(i)]) bounds[i] = {};
    const double root = passed_on[groups.of(i)];
    if (!has_impact[groups.of(i)] || !has_joint[groups.of(i)]) continue;
    if (masses[i].mass > 0) bounds[i].speed = root / std::sqrt(masses[i].mass);
    if (masses[i].inertia > 0) bounds[i].spin = root / std::sqrt(masses[i].inertia);
  }
  return bounds;
}

double slip_speed(const ContactState& contact, std::span<const BodyState> states) {
  return length(relative_velocity(contact, states));
}

// Gap times normal impulse is zero, the gap measured by the scene's shapes. A trace gives the gap at the end of a step,
// but the impulse acted at some moment within it. After that the pair may have moved by dt V, V the relative velocity
// at the contact after the step or, if the gap is that of the start, before it; by what gravity adds, and by an impact
// too slow to be told from a load; and by dt times the velocity that the impulses of others can give both bodies in an
// impact (see hidden_changes). Its own impulse shows in V. Within the gap that the method states it may push, and the
// correction of another contact may move the pair as far again. What may be rounding, as in push, is no impulse.
std::optional<InvariantCheck> check_complementarity(const InvariantContext& context) {
  const auto& [scene, trace, stepping, neighbours] = context;
  if (auto cannot = without_contacts(context, false)) return cannot;
  const Overlap overlap(scene);
  const double nu = trace_rounding(trace, stepping);
  const std::vector<Mass> masses = masses_of(scene);
  const JointGeometry joints(scene);
  WorstViolation worst;
  for (std::size_t moment = 1; moment < trace.size(); ++moment) {
    const double dt = trace.time(moment) - trace.time(moment - 1);
    const auto states = trace.states(moment);
    Overlap::Gaps gaps = overlap.gaps(states);
    const std::vector<VelocityBound> hidden = hidden_changes(context, moment, masses, joints);
    const double none = impulse_rounding(context, moment, masses);
    for (const ContactState& contact : trace.contacts(moment)) {
      if (contact.normal_impulse <= none) continue;
      const double gap = gaps.between(contact.a, contact.b);
      double path = dt * (slip_speed(contact, trace.states(moment - 1)) + slip_speed(contact, states)) +
                    dt * (dt * length(scene.gravity) + load_speed(context));
      double size = 0;
      for (const std::size_t body : {contact.a, contact.b}) {
        const VelocityBound own = given_by(contact, masses[body], states[body]);
        const double arm = length(arm_of(contact, states[body]));
        path += dt * std::max(0.0, hidden[body].at(arm) - own.at(arm));
        const double radius = bounding_radius(scene.bodies[body]);
        if (radius > 0) size = size > 0 ? std::min(size, radius) : radius;
      }
      const double rounded = nu * (length(contact.point) + trace.times().back() * slip_speed(contact, states));
      worst.add(contact.normal_impulse * gap, contact.normal_impulse * (2 * stepping.contact_gap() + path + rounded),
                contact.normal_impulse * size, trace.time(moment),
                [&] { return pair_name(context.scene, contact.a, contact.b); });
    }
  }
  return worst.result();
}

// m/s, of b against a along the tangent.
double tangential_velocity(const ContactState& contact, std::span<const BodyState> states) {
  return cross(contact.normal, relative_velocity(contact, states));
}

// A sliding contact uses all of its friction: slip times the unused part of the cone, mu n - |t|, is zero. A contact
// that started or stopped sliding within the step stuck for part of it, so the slip is the smaller of those before and
// after. It may reach what the method states as creep; what the forces add in a step while friction balances those of
// the last one, g dt, and w V dt as the contact point moves around; what the correction of another contact's overlap
// gives the pair, the slop in a step; what an impact gives that is too slow to be told from a load; and, if the
// touching bodies are struck, all that the step's impulses give the two, which may have stopped the slide in between. A
// first-order method may bound friction by an earlier normal impulse, as in the cone.
std::optional<InvariantCheck> check_sticking(const InvariantContext& context) {
  const auto& [scene, trace, stepping, neighbours] = context;
  if (auto cannot = without_contacts(context, true)) return cannot;
  const FrictionBounds friction(scene);
  const std::vector<Mass> masses = masses_of(scene);
  const JointGeometry joints(scene);
  WorstViolation worst;
  for (std::size_t moment = 1; moment < trace.size(); ++moment) {
    const double dt = trace.time(moment) - trace.time(moment - 1);
    const auto then = trace.states(moment - 1);
    const auto now = trace.states(moment);
    const std::vector<VelocityBound> hidden = hidden_changes(context, moment, masses, joints);
    const auto contacts = trace.contacts(moment);
    const double rounded = impulse_rounding(context, moment, masses);
    const std::vector<double> stale = stale_impulse_error(trace.contacts(moment - 1), contacts, stepping);
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      const ContactState& contact = contacts[c];
      const double mu = friction.smallest_dynamic(contact.a, contact.b);
      const double unused = mu * contact.normal_impulse - std::abs(contact.tangent_impulse);
      if (unused <= 0) continue;
      const double before = tangential_velocity(contact, then);
      const double after = tangential_velocity(contact, now);
      const double slip = before * after > 0 ? std::min(std::abs(before), std::abs(after)) : 0;
      const double moved_point =
          dt * (std::abs(now[contact.a].angular_velocity) + std::abs(now[contact.b].angular_velocity)) *
          (length(now[contact.a].velocity) + length(now[contact.b].velocity));
      const double speeds = length(now[contact.a].velocity) + length(now[contact.b].velocity);
      double slip_tolerance = stepping.creep + dt * length(scene.gravity) + stepping.slop / dt + load_speed(context) +
                              moved_point + solver_rounding(stepping) * speeds;
      double size = 0;
      for (const std::size_t body : {contact.a, contact.b}) {
        slip_tolerance += hidden[body].at(length(arm_of(contact, now[body])));
        if (masses[body].mass > 0) size = std::max(size, bounding_radius(scene.bodies[body]));
      }
      const double certain = std::max(0.0, unused - mu * stale[c] - (1 + mu) * rounded);
      // A body that slides down its own size has this speed.
      const double scale = std::sqrt(2 * length(scene.gravity) * size);
      worst.add(certain * slip, certain * slip_tolerance, certain * scale, trace.time(moment),
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
