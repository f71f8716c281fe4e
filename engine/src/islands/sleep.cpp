#include "islands/sleep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "contacts/part_filter.h"
#include "narrow_phase/collide.h"
#include "narrow_phase/margin.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// How far a body may move while it falls asleep, as a share of the distance that the speed threshold would carry it. A
/// load that only jitters stays within; one that creeps, swings back or turns at its apex moves farther, however slow
/// it is at the moment. The contacts of some methods creep by a third of this.
constexpr Real low_motion_tolerance = static_cast<Real>(0.005);

Aabb body_bounds(const BodySet& bodies, std::size_t i) {
  const Pose& pose = bodies.pose[i];
  std::optional<Aabb> box;
  for (const Part& part : bodies.detail[i].parts) {
    if (part.sensor) continue;
    const Aabb bounds = part.shape.bounds(pose);
    box = box ? merged(*box, bounds) : bounds;
  }
  return box.value_or(Aabb{pose.p, pose.p});
}

Real least_separation(const auto& points, int count) {
  Real least = std::numeric_limits<Real>::infinity();
  for (std::size_t p = 0; p < static_cast<std::size_t>(count); ++p) least = std::min(least, points[p].separation);
  return least;
}

}  // namespace

/// Whether a gap may close within a step. The margin's distance covers the speed that forces add.
bool Sleep::within_reach(std::size_t a, std::size_t b, Vec2 normal, Real separation, const Margin& margin) const {
  const Real approach = dot(normal, bodies_.velocity[a].v - bodies_.velocity[b].v);
  const Real rotation = rim_speed(bodies_, a) + rim_speed(bodies_, b);
  return separation <= margin.distance + margin.time * (std::max(approach, Real{0}) + rotation);
}

bool Sleep::may_meet(std::size_t mover, std::size_t sleeper, const Margin& margin) const {
  const BodyDetail& a = bodies_.detail[mover];
  const BodyDetail& b = bodies_.detail[sleeper];
  if (joints_.connects(static_cast<std::uint32_t>(mover), static_cast<std::uint32_t>(sleeper))) return false;
  const Real gap = speculative_gap(bodies_, mover, sleeper, margin);
  const auto collide_at_all = [&](const Part& part, const Part& other) {
    return !part.sensor && !other.sensor && collide(a.layers_of(part), b.layers_of(other));
  };
  for (std::size_t p = 0; p < a.parts.size(); ++p) {
    const Part& part = a.parts[p];
    const Aabb around = grown(part.shape.bounds(bodies_.pose[mover]), gap);
    for (std::size_t q = 0; q < b.parts.size(); ++q) {
      const Part& other = b.parts[q];
      if (!collide_at_all(part, other) || !overlap(around, other.shape.bounds(bodies_.pose[sleeper]))) continue;
      if (!accepts(filter_, bodies_, mover, p, sleeper, q)) continue;
      const Manifold manifold = collide(part.shape, bodies_.pose[mover], other.shape, bodies_.pose[sleeper], gap);
      const Real separation = least_separation(manifold.points, manifold.count);
      if (within_reach(mover, sleeper, manifold.normal, separation, margin)) return true;
    }
  }
  return false;
}

bool Sleep::wake_before_step(const Margin& margin) {
  const bool some_sleep = bodies_.sleepers > 0;
  movers_.clear();
  if (some_sleep) {
    for (std::uint32_t i = 0; i < bodies_.size(); ++i) {
      if (bodies_.moves(i)) movers_.push_back(i);
    }
    list_connections();
    for (const auto& [a, b] : connections_) {
      if (bodies_.asleep[a] != 0 && bodies_.moves(b)) wake(a);
      if (bodies_.asleep[b] != 0 && bodies_.moves(a)) wake(b);
    }
    // wake() appends to the movers.
    for (std::size_t done = 0; done < movers_.size(); ++done) wake_around(movers_[done], margin);
  }
  if (woken_) contacts_.take_back(bodies_);
  woken_ = false;
  return !some_sleep || !movers_.empty();
}

void Sleep::wake_around(std::uint32_t mover, const Margin& margin) {
  neighbors_.clear();
  tree_.visit(grown(body_bounds(bodies_, mover), margin.distance + travel(bodies_, mover, margin)),
              [this](std::uint32_t sleeper) { neighbors_.push_back(sleeper); });
  for (const std::uint32_t sleeper : neighbors_) {
    if (bodies_.asleep[sleeper] != 0 && may_meet(mover, sleeper, margin)) wake(sleeper);
  }
}

void Sleep::list_connections() {
  connections_.clear();
  joints_.append_pairs(connections_);
  std::erase_if(connections_, [this](const BodyPair& pair) {
    return !bodies_.detail[pair.first].inserted || !bodies_.detail[pair.second].inserted;
  });
  forces_.append_pairs(bodies_, connections_);
}

void Sleep::update_after_step(const Settings& settings, const Margin& margin) {
  rest_.resize(bodies_.size());
  restless_.assign(bodies_.size(), 0);
  bool due = false;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (bodies_.inverse_mass[i].m == 0) continue;
    const bool ready = update_timer(i, settings) && rest_[i].time >= settings.sleep_time;
    restless_[i] = ready ? 0 : 1;
    due |= ready;
  }
  if (!due) return;
  const std::size_t sleepers = bodies_.sleepers;
  keep_pulled_awake(margin);
  build_islands(margin);
  for (std::size_t island = 0; island < islands_.size(); ++island) {
    const auto bodies = islands_.bodies(island);
    if (bodies_.inverse_mass[bodies[0]].m == 0) continue;
    if (std::none_of(bodies.begin(), bodies.end(), [this](std::uint32_t i) { return restless_[i] != 0; })) {
      put_island_to_sleep(bodies);
    }
  }
  if (bodies_.sleepers > sleepers) contacts_.lay_to_rest(bodies_);
}

/// Returns whether the body is slow.
bool Sleep::update_timer(std::size_t i, const Settings& settings) {
  const Velocity& velocity = bodies_.velocity[i];
  Rest& rest = rest_[i];
  if (!(length(velocity.v) <= settings.sleep_linear_speed && std::abs(velocity.w) <= settings.sleep_angular_speed)) {
    rest.time = moving;
    return false;
  }
  const Real moved =
      length(bodies_.pose[i].p - rest.at.p) + std::abs(bodies_.angle[i] - rest.angle) * bodies_.bounding_radius[i];
  if (rest.time == moving || moved > low_motion_tolerance * settings.sleep_linear_speed * settings.sleep_time) {
    rest.time = 0;
    rest.at = bodies_.pose[i];
    rest.angle = bodies_.angle[i];
    rest.moved = 0;
  } else {
    rest.time += settings.dt;
    rest.moved = std::max(rest.moved, moved);
  }
  return true;
}

/// Whether the body has moved by no more than its place is rounded by, since it was slow: where a slow spring swings
/// back it moves by far less in that time than it is away from its rest.
bool Sleep::stands_still(std::size_t i) const {
  constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
  return rest_[i].moved <= 4 * epsilon * (length(bodies_.pose[i].p) + bodies_.bounding_radius[i]);
}

void Sleep::keep_pulled_awake(const Margin& margin) {
  held_.assign(bodies_.size(), 0);
  for (const Contact& contact : contacts_.rows()) {
    const Real separation = least_separation(contact.points, contact.count);
    if (!within_reach(contact.body_a, contact.body_b, contact.normal, separation, margin)) continue;
    const std::uint8_t by = contact.static_friction > 0 ? by_friction : touched;
    for (const std::uint32_t body : {contact.body_a, contact.body_b}) held_[body] = std::max(held_[body], by);
  }
  sprung_.clear();
  forces_.append_sprung(bodies_, sprung_);
  for (const std::uint32_t i : sprung_) {
    if (held_[i] == by_friction || !bodies_.moves(i) || stands_still(i)) continue;
    restless_[i] = 1;
    rest_[i].time = moving;
  }
  connections_.clear();
  joints_.append_pairs(connections_);
  for (const auto& [a, b] : connections_) held_[a] = held_[b] = 1;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (held_[i] == 0 && bodies_.moves(i) && forces_.attracts(bodies_, i)) restless_[i] = 1;
  }
}

/// Builds the islands of the awake bodies; each body that is not dynamic stays an island of its own.
void Sleep::build_islands(const Margin& margin) {
  islands_.clear(bodies_.size());
  const auto connect = [this](std::uint32_t a, std::uint32_t b) {
    const bool dynamic_a = bodies_.inverse_mass[a].m > 0;
    const bool dynamic_b = bodies_.inverse_mass[b].m > 0;
    if (dynamic_a && dynamic_b) {
      islands_.connect(a, b);
    } else if (bodies_.moves(a) && bodies_.moves(b)) {
      restless_[dynamic_a ? a : b] = 1;
    }
  };
  for (const Contact& contact : contacts_.rows()) {
    const Real separation = least_separation(contact.points, contact.count);
    if (within_reach(contact.body_a, contact.body_b, contact.normal, separation, margin)) {
      connect(contact.body_a, contact.body_b);
    }
  }
  list_connections();
  for (const auto& [a, b] : connections_) connect(a, b);
  islands_.number();
}

void Sleep::put_island_to_sleep(std::span<const std::uint32_t> island) {
  for (std::size_t k = 0; k < island.size(); ++k) {
    const std::uint32_t i = island[k];
    bodies_.put_to_sleep(i);
    rest_[i].next = island[(k + 1) % island.size()];
    rest_[i].leaf = tree_.insert(body_bounds(bodies_, i), i, false);
  }
}

void Sleep::put_to_sleep(std::size_t i, const Margin& margin) {
  if (bodies_.inverse_mass[i].m == 0) return;
  rest_.resize(bodies_.size());
  restless_.assign(bodies_.size(), 0);
  contacts_.take_back(bodies_);
  build_islands(margin);
  put_island_to_sleep(islands_.bodies(islands_.of(static_cast<std::uint32_t>(i))));
  contacts_.lay_to_rest(bodies_);
}

void Sleep::wake(std::size_t i) {
  if (i >= rest_.size()) return;
  rest_[i].time = moving;
  for (auto j = static_cast<std::uint32_t>(i); bodies_.asleep[j] != 0; j = rest_[j].next) {
    bodies_.wake(j);
    tree_.remove(rest_[j].leaf);
    rest_[j].time = moving;
    movers_.push_back(j);
    woken_ = true;
  }
}

void Sleep::wake_all() {
  for (std::size_t i = 0; i < bodies_.size(); ++i) wake(i);
  contacts_.take_back(bodies_);
  woken_ = false;
}

void Sleep::disturb(std::size_t i) {
  wake(i);
  if (bodies_.dynamic(i) || bodies_.sleepers == 0) return;
  for (const Contact& contact : contacts_.resting()) {
    if (contact.body_a == i) wake(contact.body_b);
    if (contact.body_b == i) wake(contact.body_a);
  }
  list_connections();
  for (const auto& [a, b] : connections_) {
    if (a == i) wake(b);
    if (b == i) wake(a);
  }
  neighbors_.clear();
  tree_.visit(body_bounds(bodies_, i), [this](std::uint32_t sleeper) { neighbors_.push_back(sleeper); });
  for (const std::uint32_t sleeper : neighbors_) wake(sleeper);
}

}  // namespace impulse::inline IMPULSE_PRECISION
