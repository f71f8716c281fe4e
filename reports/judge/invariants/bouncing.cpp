// What hits bounces as its coefficient of restitution says.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "reports/judge/contacts.h"
#include "reports/judge/groups.h"
#include "reports/judge/invariant.h"
#include "reports/judge/mechanics.h"
#include "reports/judge/rounding.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/vec.h"

// Newton's, Poisson's and Stronge's hypotheses of restitution agree on a contact without friction, and for e = 0: the
// impact ends when the approach does. With friction mu they differ where an impulse along the tangent changes the
// normal velocity. With B the inverse inertia at the contact (B_nn along the normal, B_nt across) and k = mu
// |B_nt|/B_nn, a normal impulse changes the normal velocity by between (1 - k) and (1 + k) times what it would without
// friction, both in compression and in restitution. So by all three
//   e v (1 - k)/(1 + k) <= v' <= e v (1 + k)/(1 - k),
// v the approach and v' the separation; for k >= 1 only e = 0 says anything. Below the stated threshold e may be 0.
//
// (1) Of a group of bodies that touch each other at e = 0, however many and however often they hit within a step, the
// contact that is hit last does not separate: the smallest v' of the group is zero.
// (2) A pair that touches nothing else, and in one point, keeps the two bounds.
// That the reported impulses explain how the momenta of a group change shows that nothing else pushed.
//
// The states of both ends of a step give v and v' at the reported point of the bodies, but the impact was in between:
// after a time t of the step, 0 <= t <= dt, unknown. Forces that close the gap with an acceleration a add a t to the
// approach and take a (dt - t) from the separation, whenever and in however many parts a method applies them. So (2) is
//   e (v + a t) (1 - k)/(1 + k) - a (dt - t) <= v' <= e (v + a t) (1 + k)/(1 - k) - a (dt - t)
// for some t, linear in t, so the limits are at its ends; of several impacts in the step each is slower than the one
// before and leaves v' within the same limits. A group of contacts that support each other gets either sign of a dt.
// A method with exact flight that solves for the time of impact also shows t: while the contact comes nearer by
// v t + a t^2/2 and leaves by w (dt - t) - a (dt - t)^2/2, w = v' + a (dt - t), it moves by d = (v' + a dt/2) dt -
// (v + v' + a dt) t, where d is off by the stated gap and the tolerance below times dt. One impact: 2 e v > a dt.
//
// The tolerance covers
// - how much the forces change in the step, and the acceleration of the point about both centres, w^2 r dt;
// - the normal, which turns by delta (see normal_rotation), times the relative velocity;
// - the place of the contact, which may be off by the gap and by the slip in a step, times both w;
// - what a method adds to close the gap that it states within one of its sub-steps, gap/h;
// - what the iterations leave of the fastest approach of a group, and round-off.
// A body that joints hold gets impulses that no contact reports: no test. Nor is a contact that is not approached by
// more than the tolerance: where friction and rigidity contradict each other, bodies get impulses without a collision
// (Painleve), and no hypothesis of restitution speaks of those.
namespace plumb::invariants::bouncing {
namespace {

class Bouncing {
 public:
  explicit Bouncing(const InvariantContext& context)
      : context_(context), forces_(context.scene), friction_(context.scene), jointed_(context.scene.bodies.size()) {
    for (const Joint& joint : context.scene.joints) {
      std::visit([&](const auto& of) { jointed_[of.a] = jointed_[of.b] = true; }, joint);
    }
  }

  InvariantCheck check() {
    before_ = forces_.at(context_.trace.states(0));
    for (std::size_t moment = 1; moment < context_.trace.size(); ++moment) {
      after_ = forces_.at(context_.trace.states(moment));
      check_step(moment);
      before_ = std::move(after_);
    }
    return worst_.result();
  }

 private:
  bool moves(std::size_t body) const { return forces_.masses()[body].mass > 0; }

  // A contact within a step.
  struct Hit {
    const ContactState* contact;
    double approach = 0, separation = 0;  // m/s, at the start and at the end of the step
    double closed = 0;                    // m/s, by which the forces change the approach in the step, a dt
    double off = 0;                       // m/s, either
    double corrected = 0;                 // m/s, by which the separation may be off besides
    double turned = 0;                    // rad, of the normal
  };

  // Where the point of a body that touches at the end of a step is at its start.
  Vec point_before(const ContactState& contact, std::size_t body, std::size_t moment) const {
    const BodyState& then = context_.trace.states(moment - 1)[body];
    const BodyState& now = context_.trace.states(moment)[body];
    return then.position + rotated(contact.point - now.position, then.angle - now.angle);
  }

  // The velocity of b relative to a at the start of a step, at the points of both that touch at its end. What is on a
  // path jumps there to the velocity that it has in the step.
  Vec velocity_before(const ContactState& contact, std::size_t moment) const {
    const auto of = [&](std::size_t body) {
      BodyState state = context_.trace.states(moment - 1)[body];
      if (context_.scene.bodies[body].path) state.velocity = context_.trace.states(moment)[body].velocity;
      return velocity_at(state, point_before(contact, body, moment));
    };
    return of(contact.b) - of(contact.a);
  }

  Vec acceleration(std::size_t body) const {
    return moves(body) ? 0.5 / forces_.masses()[body].mass * (before_[body].force + after_[body].force) : Vec{};
  }

  // m/s^2, by which it may differ from that at either end of the step.
  double acceleration_change(std::size_t body) const {
    return moves(body) ? 0.5 / forces_.masses()[body].mass * length(after_[body].force - before_[body].force) : 0;
  }

  Hit hit_of(const ContactState& contact, std::size_t moment) const {
    const auto& [scene, trace, stepping, neighbours] = context_;
    const double dt = trace.time(moment) - trace.time(moment - 1);
    const auto then = trace.states(moment - 1);
    const auto now = trace.states(moment);
    const Vec before = velocity_before(contact, moment);
    const Vec after = relative_velocity(contact, now);
    const double turned = std::max(normal_rotation(scene, contact, then, dt), normal_rotation(scene, contact, now, dt));
    const double fastest = std::max(length(before), length(after));
    const double closed = -dt * dot(contact.normal, acceleration(contact.b) - acceleration(contact.a));
    double off = std::min(2.0, turned) * fastest;
    double speeds = 0;
    for (const std::size_t body : {contact.a, contact.b}) {
      const double w = std::max(std::abs(then[body].angular_velocity), std::abs(now[body].angular_velocity));
      const double arm = length(contact.point - now[body].position);
      off += w * (w * arm * dt + stepping.contact_gap() + fastest * dt) + dt * acceleration_change(body);
      speeds += length(then[body].velocity) + length(now[body].velocity) + w * arm;
    }
    off += solver_rounding(stepping) * speeds;
    // The reported time, n dt, is rounded, and with it dt, their difference.
    off += 2 * 0x1p-53 * trace.time(moment) * length(acceleration(contact.b) - acceleration(contact.a));
    const double corrected = stepping.h > 0 ? stepping.contact_gap() / stepping.h : 0;
    return {&contact, -dot(contact.normal, before), dot(contact.normal, after), closed, off, corrected, turned};
  }

  // What a group of touching bodies shows in a step.
  struct Group {
    std::vector<Hit> hits;
    double restitution = 0;  // the largest
    double approach = 0;     // m/s, the fastest
    bool known = true;       // no body got an impulse that no contact reports
    bool struck = false;
  };

  void check_step(std::size_t moment) {
    const auto contacts = context_.trace.contacts(moment);
    Groups groups(jointed_.size());
    for (const ContactState& contact : contacts) {
      if (moves(contact.a) && moves(contact.b)) groups.join(contact.a, contact.b);
    }
    const std::vector<bool> explained = explained_in(moment);
    std::map<std::size_t, Group> found;
    for (const ContactState& contact : contacts) {
      Group& group = found[groups.of(moves(contact.a) ? contact.a : contact.b)];
      const Hit hit = hit_of(contact, moment);
      group.hits.push_back(hit);
      group.restitution =
          std::max(group.restitution, restitution_between(context_.scene, contact.a, contact.b).largest);
      group.approach = std::max(group.approach, hit.approach);
      for (const std::size_t body : {contact.a, contact.b}) {
        group.known = group.known && explained[body] && !jointed_[body];
      }
      group.struck =
          group.struck || (contact.normal_impulse > 0 && hit.approach > std::abs(hit.closed) + hit.off + hit.corrected);
    }
    for (const auto& [first, group] : found) {
      if (!group.known || !group.struck) continue;
      if (group.hits.size() == 1) {
        add_pair(group.hits.front(), moment);
      } else if (group.restitution == 0) {
        add_last_hit(group, moment);
      }
    }
  }

  void add_last_hit(const Group& group, std::size_t moment) {
    const double left = unsolved_share(context_.stepping) * group.approach;
    const auto tolerance = [&](const Hit& hit) { return std::abs(hit.closed) + hit.off + hit.corrected + left; };
    const Hit* last = nullptr;
    double ratio = 0;
    for (const Hit& hit : group.hits) {
      const double of_hit = error_ratio(hit.separation, tolerance(hit));
      if (last != nullptr && !(of_hit < ratio)) continue;
      last = &hit;
      ratio = of_hit;
    }
    worst_.add(last->separation, tolerance(*last), last->approach, context_.trace.time(moment),
               [&] { return pair_name(context_.scene, last->contact->a, last->contact->b); });
  }

  // By body: whether the reported impulses are all that it got besides the forces.
  std::vector<bool> explained_in(std::size_t moment) const {
    const auto& trace = context_.trace;
    const double dt = trace.time(moment) - trace.time(moment - 1);
    std::vector<Vec> received(jointed_.size());
    std::vector<double> sizes(jointed_.size());
    for (const ContactState& contact : trace.contacts(moment)) {
      const Vec impulse = impulse_of(contact);
      received[contact.a] = received[contact.a] - impulse;
      received[contact.b] = received[contact.b] + impulse;
      sizes[contact.a] += length(impulse);
      sizes[contact.b] += length(impulse);
    }
    std::vector<bool> explained(jointed_.size());
    for (std::size_t i = 0; i < explained.size(); ++i) {
      const Vec change = trace.states(moment)[i].velocity - trace.states(moment - 1)[i].velocity;
      const Vec missing = forces_.masses()[i].mass * (change - dt * acceleration(i)) - received[i];
      explained[i] = !moves(i) || length(missing) <= explained_share * sizes[i];
    }
    return explained;
  }

  // The inverse inertia at a contact.
  struct InverseInertia {
    double along = 0, across = 0, coupling = 0;  // 1/kg: B_nn, B_tt, B_nt
  };

  InverseInertia inverse_inertia(const ContactState& contact, std::size_t moment) const {
    InverseInertia sum;
    const Vec tangent{-contact.normal.y, contact.normal.x};
    for (const std::size_t body : {contact.a, contact.b}) {
      const Mass& mass = forces_.masses()[body];
      if (mass.mass == 0) continue;
      const Vec arm = contact.point - context_.trace.states(moment)[body].position;
      const double n = cross(arm, contact.normal);
      const double t = cross(arm, tangent);
      const double per_inertia = mass.inertia > 0 ? 1 / mass.inertia : 0;
      sum.along += 1 / mass.mass + n * n * per_inertia;
      sum.across += 1 / mass.mass + t * t * per_inertia;
      sum.coupling += n * t * per_inertia;
    }
    return sum;
  }

  // The k of the hypotheses.
  double disagreement(const Hit& hit, std::size_t moment) const {
    const InverseInertia b = inverse_inertia(*hit.contact, moment);
    // The normal may be off by the angle that it turns in the step.
    const double along = b.along - 2 * hit.turned * std::abs(b.coupling);
    const double coupling = std::abs(b.coupling) + hit.turned * std::abs(b.along - b.across);
    return along > 0 ? friction_.largest_static(hit.contact->a, hit.contact->b) * coupling / along : 1;
  }

  // The smallest and largest part of the step that may have been before its only impact.
  std::pair<double, double> part_before(const Hit& hit, std::size_t moment) const {
    const auto& [scene, trace, stepping, neighbours] = context_;
    const double speed = hit.approach + hit.separation + hit.closed;
    if (stepping.impact_lag > 0 || stepping.drift != 0 || !(speed > 0)) return {0, 1};
    const double dt = trace.time(moment) - trace.time(moment - 1);
    const ContactState& contact = *hit.contact;
    const double moved =
        dot(contact.normal, point_before(contact, contact.a, moment) - point_before(contact, contact.b, moment));
    const double part = (hit.separation + hit.closed / 2 - moved / dt) / speed;
    const double off = (hit.off + stepping.contact_gap() / dt) / speed;
    return {std::clamp(part - off, 0.0, 1.0), std::clamp(part + off, 0.0, 1.0)};
  }

  void add_pair(const Hit& hit, std::size_t moment) {
    const auto& [scene, trace, stepping, neighbours] = context_;
    const ContactState& contact = *hit.contact;
    const RestitutionBounds e = restitution_between(scene, contact.a, contact.b);
    const double k = e.largest > 0 ? disagreement(hit, moment) : 0;
    if (k >= 1) return;
    const double wider = (1 + k) / (1 - k);
    const bool bounces = hit.approach + std::min(0.0, hit.closed) - hit.off > stepping.restitution_threshold;
    // What the separation is at the end of the step.
    const auto limits = [&](double closed_before) {
      const double approach = hit.approach + closed_before;
      const double closed_after = hit.closed - closed_before;
      const double least = bounces ? e.smallest * (approach - hit.off) / wider : 0;
      return std::pair{least - closed_after, e.largest * (approach + hit.off) * wider - closed_after};
    };
    const bool once = bounces && 2 * e.smallest * (hit.approach - hit.off) / wider > hit.closed;
    const auto [first, last] = once ? part_before(hit, moment) : std::pair{0.0, 1.0};
    const auto at_start = limits(first * hit.closed), at_end = limits(last * hit.closed);
    const double least = std::min(at_start.first, at_end.first);
    const double most = std::max(at_start.second, at_end.second);
    worst_.add(std::abs(hit.separation - (most + least) / 2), (most - least) / 2 + hit.off + hit.corrected,
               hit.approach, trace.time(moment), [&] { return pair_name(context_.scene, contact.a, contact.b); });
  }

  static constexpr double explained_share = 1e-3;  // by which another push would change a bound less than the rest does

  const InvariantContext& context_;
  AppliedForces forces_;
  FrictionBounds friction_;
  std::vector<bool> jointed_;
  std::vector<Wrench> before_, after_;
  WorstViolation worst_;
};

const Catalog<Invariant>::Entry entry{
    {.name = "bouncing",
     .unit = "m/s",
     .definition = "bodies separate after an impact as fast as they approached, times the coefficient of restitution, "
                   "within what the hypotheses of Newton, Poisson and Stronge agree on",
     .check = [](const InvariantContext& context) -> std::optional<InvariantCheck> {
       if (auto cannot = without_contacts(context, true)) return cannot;
       return Bouncing(context).check();
     }}};

}  // namespace
}  // namespace plumb::invariants::bouncing
