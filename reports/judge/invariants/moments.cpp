// The impulses that a body gets at its contacts turn it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "reports/judge/contacts.h"
#include "reports/judge/invariant.h"
#include "reports/judge/mechanics.h"
#include "reports/judge/overlap.h"
#include "reports/judge/rounding.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/vec.h"

// I dw = sum of p x J over the reported contacts, p from the centre of mass, + the integral of the torque over the
// step, for each body without angular damping or joints (whose impulses are not reported). The tolerance covers, by
// contact:
// - the impulse may act anywhere between the surfaces of both: the stated gap or the reported separation, times |J|;
// - within the step the body turns by w dt under the point, and the normal by delta (see normal_rotation):
//   |p| (w dt + delta) |J|;
// - a method may keep the points that it found when the two came to touch, on both bodies: they are as far apart as the
//   bodies have slid since, at the relative velocity there, or, if they stopped within a step in which they set out, as
//   far as they got, and round ones have rolled, w r dt. That path, times |J|.
// A method may report the points of the step's start, of its end, or, if it goes on from an impact within the step, of
// any moment in between. So p is taken from the centre at the start, or at the end, or, with half of the longest path,
// from the middle: whichever explains it best. The forces change within the step, and everything is rounded, velocities
// at a contact as the rounding of a place makes its gap, u |x| / h, as in momentum_of_bodies. Bodies that are put to
// sleep are no test.
namespace plumb::invariants::moments {
namespace {

// Bodies whose moments are all known.
std::vector<bool> known_bodies(const Scene& scene, std::span<const Mass> masses) {
  std::vector<bool> known;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    known.push_back(masses[i].inertia > 0 && scene.bodies[i].angular_damping == 0 && !scene.bodies[i].fixed_rotation);
  }
  for (const Joint& joint : scene.joints) {
    std::visit([&](const auto& of) { known[of.a] = known[of.b] = false; }, joint);
  }
  return known;
}

class Moments {
 public:
  explicit Moments(const InvariantContext& context)
      : context_(context), forces_(context.scene), known_(known_bodies(context.scene, forces_.masses())) {}

  bool applies() const { return std::find(known_.begin(), known_.end(), true) != known_.end(); }

  InvariantCheck check() {
    std::vector<Wrench> before = forces_.at(context_.trace.states(0));
    largest_.resize(known_.size());
    for (std::size_t moment = 1; moment < context_.trace.size(); ++moment) {
      const std::vector<Wrench> after = forces_.at(context_.trace.states(moment));
      check_step(moment, before, after);
      before = after;
    }
    return worst_.result();
  }

 private:
  // What contacts do to a body about one centre.
  struct Turned {
    double moment = 0;     // kg m^2/s
    double uncertain = 0;  // kg m^2/s
  };

  void check_step(std::size_t moment, std::span<const Wrench> before, std::span<const Wrench> after) {
    const auto& [scene, trace, stepping, neighbours] = context_;
    const double dt = trace.time(moment) - trace.time(moment - 1);
    const auto then = trace.states(moment - 1);
    const auto now = trace.states(moment);
    const std::vector<WrenchError> off = forces_.change_in(then, now, dt);
    follow_paths(moment);
    std::vector<std::vector<const ContactState*>> of(known_.size());
    for (const ContactState& contact : trace.contacts(moment)) {
      for (const std::size_t body : {contact.a, contact.b}) of[body].push_back(&contact);
    }
    for (std::size_t i = 0; i < known_.size(); ++i) {
      if (!known_[i] || of[i].empty()) continue;
      if (stepping.rest_speed > 0 && now[i].velocity == Vec{} && now[i].angular_velocity == 0) continue;
      const Mass& mass = forces_.masses()[i];
      const double torque = (before[i].torque + after[i].torque) / 2;
      const double got = mass.inertia * (now[i].angular_velocity - then[i].angular_velocity) - dt * torque;
      const double speed = length(then[i].velocity) + length(now[i].velocity);
      double sum = 0;      // N s
      double longest = 0;  // m
      for (const ContactState* contact : of[i]) {
        sum += length(impulse_of(*contact));
        longest = std::max(longest, length(contact->point - now[i].position));
      }
      largest_[i] = std::max(largest_[i],
                             mass.inertia * (std::abs(then[i].angular_velocity) + std::abs(now[i].angular_velocity)) +
                                 longest * (mass.mass * speed + sum) + dt * std::abs(torque));
      if (stepping.h > 0) {
        const double unseen = stepping.epsilon * length(now[i].position) / stepping.h;
        largest_[i] = std::max(largest_[i], longest * mass.mass * unseen);
      }
      const double known = dt * off[i].torque +
                           solver_rounding(stepping) * static_cast<double>(1 + of[i].size()) * largest_[i] +
                           2 * 0x1p-53 * trace.time(moment) * std::abs(torque);
      const double path = std::max(dt * std::max(length(then[i].velocity), length(now[i].velocity)),
                                   length(now[i].position - then[i].position));
      double missing = 0;
      double tolerance = 0;
      double scale = 0;
      double ratio = std::numeric_limits<double>::infinity();
      for (const auto& [centre, apart] : {std::pair{then[i].position, 0.0}, std::pair{now[i].position, 0.0},
                                          std::pair{0.5 * (then[i].position + now[i].position), path / 2}}) {
        const Turned turned = turned_by(of[i], i, moment, centre);
        const double value = std::abs(got - turned.moment);
        const double allowed = known + turned.uncertain + apart * sum;
        if (tolerance > 0 && error_ratio(value, allowed) >= ratio) continue;
        ratio = error_ratio(value, allowed);
        missing = value;
        tolerance = allowed;
        scale = std::abs(turned.moment);
      }
      worst_.add(missing, tolerance, scale, trace.time(moment), [&] { return context_.scene.bodies[i].name; });
    }
  }

  // m/s, of a round body's surface about its own centre, or its caps'.
  double rim_speed(std::size_t body, std::size_t moment) const {
    double radius = 0;
    for (const Shape& shape : context_.scene.bodies[body].shapes) {
      radius = std::max(radius, outline_of(shape.geometry, {}).radius);
    }
    return radius * std::max(std::abs(context_.trace.states(moment - 1)[body].angular_velocity),
                             std::abs(context_.trace.states(moment)[body].angular_velocity));
  }

  // Where the point of the body that is at the contact now was at the start of the step.
  Vec where_it_was(const ContactState& contact, std::size_t body, std::size_t moment) const {
    const BodyState& then = context_.trace.states(moment - 1)[body];
    const BodyState& now = context_.trace.states(moment)[body];
    return then.position + rotated(contact.point - now.position, then.angle - now.angle);
  }

  // The paths that touching bodies have slid and rolled on each other.
  void follow_paths(std::size_t moment) {
    const auto& trace = context_.trace;
    const double dt = trace.time(moment) - trace.time(moment - 1);
    std::map<BodyPair, double> passed;
    for (const ContactState& contact : trace.contacts(moment)) {
      const BodyPair pair = std::minmax(contact.a, contact.b);
      const double speed = std::max(length(relative_velocity(contact, trace.states(moment - 1))),
                                    length(relative_velocity(contact, trace.states(moment))));
      const auto before = passed_.find(pair);
      double& path = passed[pair];
      const double slid = std::max(
          dt * speed, length(where_it_was(contact, contact.b, moment) - where_it_was(contact, contact.a, moment)));
      const double rolled = dt * (rim_speed(contact.a, moment) + rim_speed(contact.b, moment));
      path = std::max(path, slid + rolled + (before != passed_.end() ? before->second : 0));
    }
    passed_ = std::move(passed);
  }

  Turned turned_by(std::span<const ContactState* const> contacts, std::size_t body, std::size_t moment,
                   Vec centre) const {
    const auto& [scene, trace, stepping, neighbours] = context_;
    const double dt = trace.time(moment) - trace.time(moment - 1);
    const auto then = trace.states(moment - 1);
    const auto now = trace.states(moment);
    Turned turned;
    for (const ContactState* contact : contacts) {
      const Vec impulse = contact->b == body ? impulse_of(*contact) : -1 * impulse_of(*contact);
      const Vec arm = contact->point - centre;
      const double normal =
          std::max(normal_rotation(scene, *contact, then, dt), normal_rotation(scene, *contact, now, dt));
      const double own = dt * std::max(std::abs(then[body].angular_velocity), std::abs(now[body].angular_velocity));
      const double passed = passed_.at(std::minmax(contact->a, contact->b));
      const double gap = std::max(stepping.contact_gap(), std::abs(contact->separation));
      turned.moment += cross(arm, impulse);
      turned.uncertain += length(impulse) * (gap + passed + length(arm) * std::min(2.0, own + normal));
    }
    return turned;
  }

  const InvariantContext& context_;
  AppliedForces forces_;
  std::vector<bool> known_;
  std::vector<double> largest_;        // kg m^2/s, so far
  std::map<BodyPair, double> passed_;  // m, since the two came to touch
  WorstViolation worst_;
};

const Catalog<Invariant>::Entry entry{
    {.name = "angular_momentum_of_bodies",
     .unit = "kg m^2/s",
     .definition =
         "the angular momentum of a body about its centre changes only by the moments of the reported contact "
         "impulses and the torques of the scene",
     .check = [](const InvariantContext& context) -> std::optional<InvariantCheck> {
       Moments moments(context);
       if (!moments.applies()) return std::nullopt;
       if (auto cannot = without_contacts(context, true)) return cannot;
       return moments.check();
     }}};

}  // namespace
}  // namespace plumb::invariants::moments
