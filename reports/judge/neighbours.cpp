#include "reports/judge/neighbours.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "reference/scene_facts.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

double turning_radius(const Body& body) {
  const bool endless = std::any_of(body.shapes.begin(), body.shapes.end(), [](const Shape& shape) {
    return std::holds_alternative<HalfSpace>(shape.geometry);
  });
  return endless ? std::numeric_limits<double>::infinity() : bounding_radius(body);
}

constexpr std::size_t most_known = 1'000'000;  // gaps, 56 MB

// m, of a point of the body at most `radius` from its centre, which a body that does not turn has no need of.
double path(double moved, double turned, double radius) { return moved + (turned == 0 ? 0 : turned * radius); }

}  // namespace

Neighbours::Neighbours(const Scene& scene, const Trace& trace, const Stepping& stepping)
    : trace_(trace),
      forces_(scene),
      contact_gap_(stepping.contact_gap()),
      lead_(stepping.impact_lead * stepping.h),
      overlap_(scene),
      known_(trace.size()),
      room_(most_known) {
  for (const Body& body : scene.bodies) radii_.push_back(turning_radius(body));
}

std::span<const BodyGap> Neighbours::in_step(std::size_t moment) const {
  std::optional<std::vector<BodyGap>>& known = known_[moment];
  if (known) return *known;
  last_ = find(moment);
  if (last_.size() > room_) return last_;
  room_ -= last_.size();
  return known.emplace(std::move(last_));
}

std::vector<BodyGap> Neighbours::find(std::size_t moment) const {
  const double dt = trace_.time(moment) - trace_.time(moment - 1);
  const auto then = trace_.states(moment - 1);
  const auto now = trace_.states(moment);
  const std::vector<Wrench> wrenches = forces_.at(then);
  std::vector<double> reach;
  for (std::size_t i = 0; i < radii_.size(); ++i) {
    const double ahead = dt + lead_;
    const double moved = ahead / dt * length(now[i].position - then[i].position);
    const double turned = ahead / dt * std::abs(now[i].angle - then[i].angle);
    const double mass = forces_.masses()[i].mass;
    const double fallen = mass > 0 ? dt * dt * length(wrenches[i].force) / mass : 0;
    reach.push_back(
        contact_gap_ / 2 + fallen +
        std::max({path(moved, turned, radii_[i]),
                  path(ahead * length(then[i].velocity), ahead * std::abs(then[i].angular_velocity), radii_[i]),
                  path(ahead * length(now[i].velocity), ahead * std::abs(now[i].angular_velocity), radii_[i])}));
  }
  std::vector<BodyGap> met = overlap_.near(then, reach);
  if (!after_blows(met, then, now, dt, reach)) return met;
  std::vector<BodyGap> farther = overlap_.near(then, reach);
  // Those that meet anyway do so where they come without a blow.
  for (BodyGap& pair : farther) {
    const auto same = [&pair](const BodyGap& one) {
      return one.a == pair.a && one.b == pair.b && one.shape_a == pair.shape_a && one.shape_b == pair.shape_b;
    };
    const auto known = std::find_if(met.begin(), met.end(), same);
    if (known != met.end()) pair = *known;
  }
  return farther;
}

bool Neighbours::after_blows(std::span<const BodyGap> met, std::span<const BodyState> then,
                             std::span<const BodyState> now, double dt, std::vector<double>& reach) const {
  std::vector<double> blow(reach.size());
  for (const BodyGap& pair : met) {
    const double speed = std::max(length(then[pair.a].velocity - then[pair.b].velocity),
                                  length(now[pair.a].velocity - now[pair.b].velocity));
    for (const std::size_t i : {pair.a, pair.b}) blow[i] = std::max(blow[i], 2 * speed);
  }
  bool farther = false;
  for (std::size_t i = 0; i < reach.size(); ++i) {
    const Mass& mass = forces_.masses()[i];
    if (!(mass.mass > 0) || blow[i] == 0) continue;
    const bool turned = then[i].angular_velocity != now[i].angular_velocity && mass.inertia > 0;
    const double spin = turned ? mass.mass * radii_[i] / mass.inertia * blow[i] : 0;
    reach[i] += path((dt + lead_) * blow[i], (dt + lead_) * spin, radii_[i]);
    farther = true;
  }
  return farther;
}

}  // namespace plumb
