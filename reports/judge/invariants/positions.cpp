// Where bodies may be: not deep inside each other, and where they were once they have come to rest.
#include <algorithm>
#include <cmath>
#include <span>
#include <variant>
#include <vector>

#include "reference/scene_facts.h"
#include "reports/judge/contacts.h"
#include "reports/judge/invariant.h"
#include "reports/judge/neighbours.h"
#include "reports/judge/overlap.h"
#include "reports/judge/rounding.h"
#include "reports/judge/states.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/surface.h"
#include "scenarios/scene/vec.h"

namespace plumb::invariants::positions {
namespace {

// m/s, the largest speed of a point of one body relative to one of the other.
double relative_speed(const BodyState& a, const BodyState& b, double radius_a, double radius_b) {
  return length(b.velocity - a.velocity) + radius_a * std::abs(a.angular_velocity) +
         radius_b * std::abs(b.angular_velocity);
}

// Two bodies that are near each other.
struct Near {
  BodyPair pair;
  double depth = 0;  // m, of the deepest overlap of their parts; 0 if there is none
};

// Each pair once, in order.
void join_parts(std::vector<Near>& all) {
  std::sort(all.begin(), all.end(), [](const Near& one, const Near& other) {
    return one.pair != other.pair ? one.pair < other.pair : one.depth > other.depth;
  });
  const auto same = [](const Near& one, const Near& other) { return one.pair == other.pair; };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
}

// Every overlap at a moment: those that meet in the step after it are known anyway.
std::vector<Near> overlaps_at(std::size_t moment, const Overlap& overlap, const InvariantContext& context) {
  std::vector<Near> overlaps;
  if (moment + 1 == context.trace.size()) {
    for (const BodyOverlap& of : overlap.all(context.trace.states(moment)))
      overlaps.push_back({{of.a, of.b}, of.depth});
  } else {
    for (const BodyGap& of : context.neighbours.in_step(moment + 1)) {
      if (of.gap < 0) overlaps.push_back({{of.a, of.b}, -of.gap});
    }
  }
  return overlaps;
}

// m, 0 for a pair that is not among them; they are in order.
double depth_of(const BodyPair& pair, std::span<const Near> among) {
  const auto found = std::lower_bound(among.begin(), among.end(), pair,
                                      [](const Near& one, const BodyPair& other) { return one.pair < other; });
  return found != among.end() && found->pair == pair ? found->depth : 0;
}

// A pair may overlap by the gap that the method states, by its depth at the start of the scene, and by the distance
// that it approaches before an impact is noticed: lag h V, V the largest relative speed of two of its points in the
// steps that the lag covers, and in the one after, in which it is measured, and what gravity adds to V until then. How
// fast a method pushes the pair apart again is not judged, but an overlap that was allowed may only shrink, except for
// the share of the fastest approach of that step, of any pair, that the stated iterations leave unsolved. The law is
// tested where the pair touches, or would overlap if both went on for a step.
std::optional<InvariantCheck> check_overlap(const InvariantContext& context) {
  const auto& [scene, trace, stepping, neighbours] = context;
  if (scene.bodies.size() < 2) return std::nullopt;
  const Overlap overlap(scene);
  const double nu = trace_rounding(trace, stepping);
  double gravity = 0;  // m/s^2, the largest
  for (const Body& body : scene.bodies) {
    if (body.type == BodyType::dynamic)
      gravity = std::max(gravity, std::abs(body.gravity_scale) * length(scene.gravity));
  }
  std::vector<double> radii;
  for (const Body& body : scene.bodies) radii.push_back(bounding_radius(body));
  std::vector<double> fastest(scene.bodies.size());
  std::vector<double> farthest(scene.bodies.size());
  const auto grow_extremes = [&](std::size_t moment) {
    for (std::size_t i = 0; i < radii.size(); ++i) {
      const BodyState& state = context.trace.states(moment)[i];
      fastest[i] = std::max(fastest[i], length(state.velocity) + radii[i] * std::abs(state.angular_velocity));
      farthest[i] = std::max(farthest[i], length(state.position) + radii[i] * (1 + std::abs(state.angle)));
    }
  };
  grow_extremes(0);
  std::vector<Near> at_start = overlaps_at(0, overlap, context);
  join_parts(at_start);
  std::vector<Near> allowed;    // of the overlaps there were at the moment before
  std::vector<double> late_by;  // m, approached before an impact is noticed, of each pair
  WorstViolation worst;
  for (std::size_t moment = 1; moment < trace.size(); ++moment) {
    const double dt = trace.time(moment) - trace.time(moment - 1);
    grow_extremes(moment);
    const double lag = stepping.impact_lag * stepping.h;
    const auto covered = static_cast<std::size_t>(std::ceil(lag / dt)) + 1;
    const std::size_t since = moment - std::min(moment, covered);
    std::vector<Near> pairs = overlaps_at(moment, overlap, context);
    for (const BodyGap& near : neighbours.in_step(moment)) pairs.push_back({{near.a, near.b}});
    join_parts(pairs);
    late_by.clear();
    for (const Near& near : pairs) {
      const auto [a, b] = near.pair;
      double approach = 0;
      for (std::size_t i = since; lag > 0 && i <= moment; ++i) {
        const auto states = trace.states(i);
        approach = std::max(approach, relative_speed(states[a], states[b], radii[a], radii[b]));
      }
      late_by.push_back(lag * (approach + lag * gravity));
    }
    const double latest = late_by.empty() ? 0 : *std::max_element(late_by.begin(), late_by.end());
    std::vector<Near> still_allowed;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto& [pair, depth] = pairs[i];
      const std::size_t a = pair.first;
      const std::size_t b = pair.second;
      const double rounded = farthest[a] + farthest[b] + trace.times().back() / 2 * (fastest[a] + fastest[b]);
      const double left = depth_of(pair, allowed);
      const double tolerance = std::max(stepping.contact_gap() + depth_of(pair, at_start) + late_by[i],
                                        left == 0 ? 0 : left + unsolved_share(stepping) * latest) +
                               nu * rounded;
      const double size = radii[a] > 0 && radii[b] > 0 ? std::min(radii[a], radii[b]) : std::max(radii[a], radii[b]);
      worst.add(depth, tolerance, size, trace.time(moment), [&] { return pair_name(context.scene, a, b); });
      if (depth > 0) still_allowed.push_back({pair, std::min(depth, tolerance)});
    }
    allowed = std::move(still_allowed);
  }
  return worst.result();
}

constexpr double settling_time = 1;  // s, for which all bodies must have been still

// Whether friction holds every body on every half-space that slopes. Where it all but does, a body may take longer than
// the settling time to be seen sliding.
bool holds_on_slopes(const Scene& scene) {
  for (const Body& ground : scene.bodies) {
    for (const Shape& slope : ground.shapes) {
      const auto* half = std::get_if<HalfSpace>(&slope.geometry);
      if (half == nullptr) continue;
      const Vec normal = rotated(half->normal, ground.angle);
      const double load = -dot(normal, scene.gravity);
      const double pull = std::abs(cross(normal, scene.gravity));
      for (const Body& body : scene.bodies) {
        if (load <= 0 || body.type != BodyType::dynamic) continue;
        const auto slides = [&](const Shape& shape) {
          return pull > load * mixed_static_friction(scene.mixing, slope.surface, shape.surface);
        };
        if (std::any_of(body.shapes.begin(), body.shapes.end(), slides)) return false;
      }
    }
  }
  return true;
}

// Whether still bodies of the scene are at rest: they lie on their faces and friction holds them. A disc may roll as
// slowly as it likes, a pendulum may swing and a spring may pull.
bool stays_where_it_rests(const Scene& scene) {
  const auto stays = [](const Body& body) {
    if (body.type == BodyType::kinematic) return false;
    return std::all_of(body.shapes.begin(), body.shapes.end(), [&](const Shape& shape) {
      const bool round =
          std::holds_alternative<Circle>(shape.geometry) || std::holds_alternative<Capsule>(shape.geometry);
      return shape.surface.static_friction > 0 && !(round && body.type == BodyType::dynamic);
    });
  };
  return scene.joints.empty() && scene.forces.empty() && scene.gravity != Vec{} &&
         std::all_of(scene.bodies.begin(), scene.bodies.end(), stays) && holds_on_slopes(scene);
}

// Once every body has been still for a second, no body may move by more than the gap it may still close, along gravity
// the gaps of all bodies that may lie below it, and the creep that the method states. A contact that is a spring may
// still close or open by the depth that it has then, as its load shifts.
std::optional<InvariantCheck> check_rest(const InvariantContext& context) {
  const auto& [scene, trace, stepping, neighbours] = context;
  if (!stays_where_it_rests(scene)) return std::nullopt;
  const double bodies = still_bodies(scene, std::vector<BodyState>(scene.bodies.size()));
  const double nu = trace_rounding(trace, stepping);
  WorstViolation worst;
  std::size_t first = 0;  // since when all are still
  std::optional<std::size_t> rest;
  for (std::size_t moment = 0; moment < trace.size() && !rest; ++moment) {
    if (still_bodies(scene, trace.states(moment)) < bodies) first = moment + 1;
    if (first <= moment && trace.time(moment) - trace.time(first) >= settling_time) rest = moment;
  }
  if (!rest) return worst.result();
  const Vec down = 1 / length(scene.gravity) * scene.gravity;
  const auto at_rest = trace.states(*rest);
  double gap = stepping.contact_gap();
  if (stepping.contact_frequency > 0) {
    for (const BodyOverlap& pair : Overlap(scene).all(at_rest)) gap = std::max(gap, pair.depth);
  }
  for (std::size_t moment = *rest + 1; moment < trace.size(); ++moment) {
    const auto states = trace.states(moment);
    const double time = trace.time(moment) - trace.time(*rest);
    for (std::size_t i = 0; i < states.size(); ++i) {
      const Vec moved = states[i].position - at_rest[i].position;
      const double slack = stepping.creep * time + nu * length(states[i].position);
      const double size = scene.bodies[i].type == BodyType::dynamic ? bounding_radius(scene.bodies[i]) : 0;
      const auto where = [&] { return context.scene.bodies[i].name; };
      worst.add(std::abs(cross(down, moved)), gap + slack, size, trace.time(moment), where);
      worst.add(std::abs(dot(down, moved)), bodies * gap + slack, size, trace.time(moment), where);
    }
  }
  return worst.result();
}

const Catalog<Invariant>::Entry overlap_entry{
    {.name = "overlap",
     .unit = "m",
     .definition = "bodies overlap by no more than the stated gap and the distance covered before an impact is noticed",
     .check = check_overlap}};
const Catalog<Invariant>::Entry rest_entry{
    {.name = "rest",
     .unit = "m",
     .definition = "bodies at rest stay at rest: displacement of a body after all have been still for a second",
     .check = check_rest}};

}  // namespace
}  // namespace plumb::invariants::positions
