// What pushes a body beside its centre turns it.
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "reports/judge/contact_region.h"
#include "reports/judge/contacts.h"
#include "reports/judge/invariant.h"
#include "reports/judge/mechanics.h"
#include "reports/judge/neighbours.h"
#include "reports/judge/rounding.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/vec.h"

// No word of the engine is taken. Where one part of one other body is all that may touch a body in a step (see
// Neighbours), what its momentum changes by without the forces, J = m dv - F dt, went through the region in which the
// two may touch, and the angular momentum must have changed by I dw - T dt = p x J for some p in it. The region has
// every point of the body that is within reach of the other both before and after the step (see region_near); a round
// part adds its radius towards the other, r d.
//
// The step's J may be the sum of impulses J_k at points p_k. With c the region's centre and R its radius, the sum of
// p_k x J_k differs from c x J by at most R sum |J_k|. Each J_k lies within atan mu of the normal and that within delta
// of its mean, so that sum |J_k| <= S = |J|/cos(atan mu + delta). The tolerance covers
// - that, R S;
// - the arm turns with the body, and d with the normal: |p| w dt S, and r delta S;
// - the impulse may act anywhere between the surfaces of both: the stated gap, or the overlap, times S; and where a
//   method brakes early, the gap at the step's start, at which it takes its points;
// - forces that change within the step, as in momentum_of_bodies, and round-off.
// The normal is that of a face which the other touches away from its corners, delta = w dt of that body; or of a round
// body on a corner or on another, V dt/r more. Two sharp corners may have any normal: no test. Nor is a body that
// joints hold or damping slows, or that is put to sleep.
namespace plumb::invariants::turning {
namespace {

// rad, of a body within a step.
double turned(const BodyState& then, const BodyState& now, double dt) {
  return std::max(
      {std::abs(now.angle - then.angle), dt * std::abs(then.angular_velocity), dt * std::abs(now.angular_velocity)});
}

// `outline` of a body in the frame of another.
Outline seen_from(const BodyState& frame, const BodyState& body, const Outline& outline) {
  return placed(outline, rotated(body.position - frame.position, -frame.angle), body.angle - frame.angle);
}

class Turning {
 public:
  explicit Turning(const InvariantContext& context)
      : context_(context), forces_(context.scene), friction_(context.scene), judged_(context.scene.bodies.size()) {
    for (std::size_t i = 0; i < judged_.size(); ++i) {
      const Body& body = context.scene.bodies[i];
      judged_[i] = forces_.masses()[i].inertia > 0 && body.linear_damping == 0 && body.angular_damping == 0;
    }
    for (const Joint& joint : context.scene.joints) {
      std::visit([&](const auto& of) { judged_[of.a] = judged_[of.b] = false; }, joint);
    }
  }

  bool applies() const { return std::find(judged_.begin(), judged_.end(), true) != judged_.end(); }

  InvariantCheck check() {
    std::vector<Wrench> before = forces_.at(context_.trace.states(0));
    for (std::size_t moment = 1; moment < context_.trace.size(); ++moment) {
      const auto& trace = context_.trace;
      std::vector<Wrench> after = forces_.at(trace.states(moment));
      off_ = forces_.change_in(trace.states(moment - 1), trace.states(moment),
                               trace.time(moment) - trace.time(moment - 1));
      const std::span<const BodyGap> pairs = context_.neighbours.in_step(moment);
      std::vector<std::size_t> met(judged_.size());
      for (const BodyGap& pair : pairs) {
        ++met[pair.a];
        ++met[pair.b];
      }
      for (const BodyGap& pair : pairs) {
        if (judged_[pair.a] && met[pair.a] == 1)
          add(moment, {pair.a, pair.shape_a}, {pair.b, pair.shape_b}, pair, before, after);
        if (judged_[pair.b] && met[pair.b] == 1)
          add(moment, {pair.b, pair.shape_b}, {pair.a, pair.shape_a}, pair, before, after);
      }
      before = std::move(after);
    }
    return worst_.result();
  }

 private:
  struct Part {
    std::size_t body, shape;
  };

  Outline outline_of_part(const Part& part) const {
    const Geometry& geometry = context_.scene.bodies[part.body].shapes[part.shape].geometry;
    return outline_of(geometry, forces_.masses()[part.body].center);
  }

  void add(std::size_t moment, const Part& part, const Part& by, const BodyGap& pair, std::span<const Wrench> before,
           std::span<const Wrench> after) {
    const auto& [scene, trace, stepping, neighbours] = context_;
    const std::size_t i = part.body;
    const double dt = trace.time(moment) - trace.time(moment - 1);
    const BodyState& then = trace.states(moment - 1)[i];
    const BodyState& now = trace.states(moment)[i];
    const BodyState& other_then = trace.states(moment - 1)[by.body];
    const BodyState& other_now = trace.states(moment)[by.body];
    if (stepping.rest_speed > 0 && now.velocity == Vec{} && now.angular_velocity == 0) return;
    const Outline own = outline_of_part(part);
    const Outline other = outline_of_part(by);
    if (own.halfspace) return;

    const double reach = pair.reach + own.radius + other.radius;
    Outline left = own;
    Outline others_left = other;
    for (const auto& [mine, its] : {std::pair{then, other_then}, std::pair{now, other_now}}) {
      left.points = region_near(left, seen_from(mine, its, other), reach);
      if (!other.halfspace) others_left.points = region_near(others_left, seen_from(its, mine, own), reach);
    }
    if (left.points.empty()) return;
    const double own_turn = turned(then, now, dt);
    const double other_turn = turned(other_then, other_now, dt);
    const bool on_own_face = is_flat_in(own, left.points);
    const bool on_others_face = is_flat_in(other, others_left.points);
    double normal_turn = on_others_face ? other_turn : own_turn;
    if (!on_own_face && !on_others_face) {
      const double radius = own.radius + other.radius;
      if (radius == 0) return;
      const double passed =
          dt * std::max(length(other_then.velocity - then.velocity), length(other_now.velocity - now.velocity));
      normal_turn = own_turn + other_turn + passed / radius;
    }
    const double cone = std::atan(friction_.largest_static(pair.a, pair.b)) + normal_turn;
    if (cone > widest_cone) return;

    const Mass& mass = forces_.masses()[i];
    const Vec force = 0.5 * (before[i].force + after[i].force);
    const double torque = (before[i].torque + after[i].torque) / 2;
    const Vec impulse = mass.mass * (now.velocity - then.velocity) - dt * force;
    const double size = length(impulse) / std::cos(cone);

    Vec low = left.points.front();
    Vec high = low;
    for (const Vec point : left.points) {
      low = {std::min(low.x, point.x), std::min(low.y, point.y)};
      high = {std::max(high.x, point.x), std::max(high.y, point.y)};
    }
    const Vec middle = 0.5 * (low + high);
    double radius = 0;
    for (const Vec point : left.points) radius = std::max(radius, length(point - middle));
    Vec arm = rotated(middle, (then.angle + now.angle) / 2);
    if (own.radius > 0) {
      const auto towards =
          direction_to(placed(own, now.position, now.angle), placed(other, other_now.position, other_now.angle));
      if (!towards) return;
      arm = arm + own.radius * *towards;
    }
    const auto gap = [&](const BodyState& mine, const BodyState& its) {
      return gap_between(placed(own, mine.position, mine.angle), placed(other, its.position, its.angle));
    };
    const double gap_then = gap(then, other_then);
    double apart = std::max({stepping.contact_gap(), -gap_then, -gap(now, other_now)});
    if (stepping.impact_lead > 0) apart = std::max(apart, gap_then);
    const double farthest = length(middle) + radius;
    const double expected = cross(arm, impulse);
    const double got = mass.inertia * (now.angular_velocity - then.angular_velocity) - dt * torque;
    const double longest = farthest + own.radius;
    const double change = longest * off_[i].force + off_[i].torque;
    const double rounded = longest * (mass.mass * (length(then.velocity) + length(now.velocity)) + dt * length(force)) +
                           mass.inertia * (std::abs(then.angular_velocity) + std::abs(now.angular_velocity)) +
                           dt * std::abs(torque);
    const double tolerance = size * (radius + farthest * own_turn + own.radius * std::min(2.0, normal_turn) + apart) +
                             dt * change + 2 * solver_rounding(stepping) * rounded +
                             2 * 0x1p-53 * trace.time(moment) * (longest * length(force) + std::abs(torque));
    worst_.add(std::abs(got - expected), tolerance, std::abs(expected), trace.time(moment),
               [&] { return context_.scene.bodies[i].name; });
  }

  static constexpr double widest_cone = 1.5;  // rad; beyond it the sum of the impulses is hardly bounded

  const InvariantContext& context_;
  AppliedForces forces_;
  FrictionBounds friction_;
  std::vector<bool> judged_;
  std::vector<WrenchError> off_;  // in the step
  WorstViolation worst_;
};

const Catalog<Invariant>::Entry entry{
    {.name = "turning",
     .unit = "kg m^2/s",
     .definition =
         "what one other body alone may touch changes its angular momentum by the impulse it gets, times an arm "
         "to where the two may touch, and by the scene's torques",
     .check = [](const InvariantContext& context) -> std::optional<InvariantCheck> {
       Turning turning(context);
       if (!turning.applies()) return std::nullopt;
       return turning.check();
     }}};

}  // namespace
}  // namespace plumb::invariants::turning
