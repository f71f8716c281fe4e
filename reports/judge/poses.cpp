#include "reports/judge/poses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "reference/adapter.h"
#include "reference/scene_facts.h"
#include "reports/judge/invariant.h"
#include "reports/judge/overlap.h"
#include "reports/judge/rounding.h"
#include "reports/judge/scale.h"
#include "scenarios/scene/joints.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

constexpr double full_turn = 6.283185307179586;  // rad

double rim_of(const Scene& scene, std::size_t body) {
  const double radius = bounding_radius(scene.bodies[body]);
  return radius > 0 ? radius : smallest_body(scene);
}

// m: engines may count turns or not.
double apart(const BodyState& a, const BodyState& b, double rim) {
  return std::max(length(a.position - b.position), rim * std::abs(std::remainder(a.angle - b.angle, full_turn)));
}

// m, the largest coordinate that an engine computes with: of bodies that do not move, and of edges and grooves that
// stand for half-spaces and sliders without ends.
double largest_coordinate(const Scene& scene) {
  const bool slides = std::any_of(scene.joints.begin(), scene.joints.end(),
                                  [](const Joint& joint) { return facts_of(joint).keeps == JointFacts::Keeps::line; });
  double largest = slides ? scene_extent(scene) : 0;
  for (const Body& body : scene.bodies) {
    largest = std::max(largest, length(body.position) + bounding_radius(body));
    for (const Shape& shape : body.shapes) {
      if (std::holds_alternative<HalfSpace>(shape.geometry)) largest = std::max(largest, scene_extent(scene));
    }
  }
  return largest;
}

// m, by body: how far it moves, or its size.
std::vector<double> pose_scales(const Scene& scene, const Trace& trace) {
  const Scales scales(scene, trace);
  std::vector<double> all;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Vec start = trace.states(0)[i].position;
    const auto of = [&](Quantity quantity, double value) {
      return scales.of({.body = scene.bodies[i].name, .quantity = quantity}, value);
    };
    all.push_back(std::max(of(Quantity::x, start.x), of(Quantity::y, start.y)));
  }
  return all;
}

}  // namespace

// With n = the numbers of sub-steps so far + 2 and u the unit round-off (see rounding.h), X the largest coordinate and
// V the largest speed so far, of the rim too:
//   position  n u X, its own sum, and where shapes are placed and compared
//   velocity  n u V, which after a time t has moved the body by t/2 n u V
//   contacts  a solver rounds velocities in each iteration, by `solver_rounding` (V + g dt) in a step that touches
//             something or has joints; each such error lasts to the end.
std::vector<double> pose_rounding(const RelationRun& run) {
  const auto& [scene, trace, stepping, amplification] = run;
  double coordinate = largest_coordinate(scene);
  double speed = 0;
  double pushed = 0;   // m/s, what solving has added to the velocities' errors
  double carried = 0;  // m, their integral
  std::vector<double> all;
  for (std::size_t moment = 0; moment < trace.size(); ++moment) {
    const double t = trace.time(moment);
    const double dt = moment > 0 ? t - trace.time(moment - 1) : 0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      if (scene.bodies[i].type != BodyType::dynamic) continue;
      const BodyState& state = trace.states(moment)[i];
      const double rim = rim_of(scene, i);
      coordinate = std::max(coordinate, length(state.position) + rim * (1 + std::abs(state.angle)));
      speed = std::max(speed, length(state.velocity) + rim * std::abs(state.angular_velocity));
    }
    carried += dt * pushed;
    const bool touches = !trace.contacts(moment).empty() || !trace.has_contacts();
    const bool solves = scene.bodies.size() > 1 && (touches || !scene.joints.empty());
    if (moment > 0 && solves) pushed += solver_rounding(stepping) * (speed + dt * length(scene.gravity));
    const double steps = std::max(static_cast<double>(moment), stepping.h > 0 ? t / stepping.h : 0);
    const double once = (steps + 2) * stepping.epsilon;
    all.push_back(once * coordinate + t / 2 * once * speed + carried);
  }
  return all;
}

RelationCheck compare_poses(const RelationRun& run, std::size_t moments, const Poses& expected,
                            std::span<const Allowance> allowances) {
  const std::vector<double> scales = pose_scales(run.scene, run.trace);
  RelationCheck result;
  for (const Allowance& allowance : allowances) {
    WorstViolation worst;
    result = {};
    std::size_t compared = 0;
    for (std::size_t moment = 0; moment < moments && compared == moment; ++moment) {
      bool known = true;
      std::vector<double> allowed(run.scene.bodies.size());
      for (std::size_t i = 0; i < allowed.size() && known; ++i) {
        if (run.scene.bodies[i].type != BodyType::dynamic) continue;
        const auto most = allowance.at(moment, i);
        known = most.has_value();
        allowed[i] = most.value_or(0);
      }
      if (!known) break;
      ++compared;
      for (std::size_t i = 0; i < allowed.size(); ++i) {
        if (run.scene.bodies[i].type != BodyType::dynamic) continue;
        const BodyState should = expected(moment, i);
        const double off = apart(run.trace.states(moment)[i], should, rim_of(run.scene, i));
        result.share = std::max(result.share, off / scales[i]);
        worst.add(off, allowed[i], scales[i], run.trace.time(moment), [&] { return run.scene.bodies[i].name; });
      }
    }
    if (compared < 2) {
      result.why_not = fmt::format("what may differ cannot be told from the start on: {}", allowance.reason);
      return result;
    }
    result.check = worst.result();
    const std::string until = compared == moments ? "to the end"
                                                  : fmt::format("until {:.4g} s, the horizon of such differences",
                                                                run.trace.time(compared - 1));
    result.check.detail = fmt::format("compared {}; may differ by {}", until, allowance.reason);
    if (result.check.status == CheckStatus::held) break;
  }
  return result;
}

Allowance decided_otherwise(const RelationRun& run, const Allowance& explained, std::vector<double> rounding,
                            double size) {
  const auto from = std::make_shared<std::optional<double>>();  // s; found when it is first asked for
  return {explained.reason + ", and once the engine decides by it in a tie, the method's own error",
          [=, &run, at = explained.at, rounding = std::move(rounding)](std::size_t moment, std::size_t body) {
            if (!*from) *from = run.amplification.undecided_from(size, rounding);
            const std::optional<double> most = at(moment, body);
            if (!most || run.trace.time(moment) < **from) return most;
            const auto own = run.amplification.of_method(run.stepping, moment, body);
            return own ? std::optional(*most + 2 * *own) : std::nullopt;
          }};
}

std::vector<Allowance> explained_by_rounding(const RelationRun& run, std::vector<double> rounding,
                                             std::optional<Stepping> residue) {
  std::string reason = "round-off as this scene amplifies it";
  if (residue) reason += ", what the stated iterations leave in another order";
  if (!run.scene.joints.empty() && run.stepping.joint_slop > 0) {
    if (!residue) residue = Stepping{.dt = run.stepping.dt};
    residue->joint_slop = run.stepping.joint_slop;
    reason += ", the stated slop of joints";
  }
  const Allowance amplified{reason,
                            [rounding, residue, &run](std::size_t moment, std::size_t body) -> std::optional<double> {
                              const auto most = run.amplification.of(rounding[moment], moment, body);
                              if (!most || !residue) return most;
                              const auto left = run.amplification.of_method(*residue, moment, body);
                              return left ? std::optional(*most + 2 * *left) : std::nullopt;
                            }};
  return {{"round-off", [rounding](std::size_t moment, std::size_t) { return rounding[moment]; }},
          amplified,
          decided_otherwise(run, amplified, rounding, rounding.back())};
}

RelationCheck compare_congruent(const RelationRun& run, const RelationRun& image, const Congruence& map,
                                std::size_t first, std::optional<Stepping> residue) {
  const Congruence back = map.inverse();
  const auto poses = [&](std::size_t moment, std::size_t body) {
    BodyState state = image.trace.states(moment)[first + body];
    state.position = back.of_point(state.position);
    state.angle = back.of_angle(state.angle);
    return state;
  };
  return compare_poses(run, std::min(run.trace.size(), image.trace.size()), poses,
                       explained_by_rounding(run, sum_of(pose_rounding(run), pose_rounding(image)), residue));
}

std::vector<Allowance> explained_by_method(const RelationRun& run, std::vector<double> rounding, const Stepping& one,
                                           const Stepping& other) {
  return {{"round-off", [rounding](std::size_t moment, std::size_t) { return rounding[moment]; }},
          {"the method's own error, as this scene amplifies it",
           [rounding, one, other, &run](std::size_t moment, std::size_t body) -> std::optional<double> {
             const auto rounded = run.amplification.of(rounding[moment], moment, body);
             const auto first = run.amplification.of_method(one, moment, body);
             const auto second = run.amplification.of_method(other, moment, body);
             if (!rounded || !first || !second) return std::nullopt;
             return *rounded + *first + *second;
           }}};
}

std::optional<Stepping> residue_of(const Stepping& stepping) {
  if (stepping.iterations == 0 && stepping.position_iterations == 0) return std::nullopt;
  Stepping residue{.dt = stepping.dt, .iterations = stepping.iterations};
  if (stepping.position_iterations > 0) {
    residue.skin = stepping.skin;
    residue.slop = stepping.slop;
    residue.joint_slop = stepping.joint_slop;
  }
  return residue;
}

RelationCheck worse(const RelationCheck& a, const RelationCheck& b) {
  if (!a.why_not.empty()) return b;
  if (!b.why_not.empty()) return a;
  RelationCheck worst = a.check.ratio >= b.check.ratio ? a : b;
  worst.share = std::max(a.share, b.share);
  return worst;
}

std::vector<double> sum_of(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> sum(std::min(a.size(), b.size()));
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = a[i] + b[i];
  return sum;
}

}  // namespace plumb
