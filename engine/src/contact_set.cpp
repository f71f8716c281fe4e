#include "contact_set.h"

#include <algorithm>
#include <tuple>

#include "collide.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

auto order(const Contact& c) { return std::tie(c.body_a, c.body_b, c.part_a, c.part_b); }

/// The farthest that a body's surface can go in the margin's time.
Real travel(const BodySet& bodies, std::size_t i, const Margin& margin) {
  const Velocity& velocity = bodies.velocity[i];
  return margin.time * (length(velocity.v) + std::abs(velocity.w) * bodies.reach[i]);
}

/// Two bodies that move together close no distance, however fast they are.
Real closing(const BodySet& bodies, std::size_t a, std::size_t b, const Margin& margin) {
  if (margin.time == 0) return margin.distance;
  const Velocity& va = bodies.velocity[a];
  const Velocity& vb = bodies.velocity[b];
  const Real turning = std::abs(va.w) * bodies.reach[a] + std::abs(vb.w) * bodies.reach[b];
  return margin.distance + margin.time * (length(vb.v - va.v) + turning);
}

Contact make(const BodySet& bodies, const Proxy& a, const Proxy& b, const Manifold& manifold) {
  Contact contact;
  contact.body_a = a.body;
  contact.body_b = b.body;
  contact.part_a = a.part;
  contact.part_b = b.part;
  contact.normal = manifold.normal;
  contact.count = manifold.count;
  for (std::size_t p = 0; p < static_cast<std::size_t>(manifold.count); ++p) {
    const ManifoldPoint& found = manifold.points[p];
    ContactPoint& point = contact.points[p];
    point.arm_a = found.point - bodies.pose[a.body].p;
    point.arm_b = found.point - bodies.pose[b.body].p;
    point.separation = found.separation;
    point.feature = found.feature;
  }
  return contact;
}

void mix_materials(Contact& contact, const Material& a, const Material& b, const Settings& settings) {
  contact.static_friction = mix(settings.friction_mixing, a.static_friction, b.static_friction);
  contact.dynamic_friction = mix(settings.friction_mixing, a.dynamic_friction, b.dynamic_friction);
  contact.restitution = mix(settings.restitution_mixing, a.restitution, b.restitution);
}

void carry_over(Contact& contact, const Contact& last) {
  contact.age = last.age + 1;
  for (std::size_t p = 0; p < static_cast<std::size_t>(contact.count); ++p) {
    for (std::size_t q = 0; q < static_cast<std::size_t>(last.count); ++q) {
      ContactPoint& point = contact.points[p];
      const ContactPoint& before = last.points[q];
      if (point.feature != before.feature) continue;
      point.normal_impulse = before.normal_impulse;
      point.tangent_impulse = before.tangent_impulse;
      point.fresh = false;
    }
  }
}

}  // namespace

void ContactSet::find(const BodySet& bodies, BroadPhase& broad_phase, const Settings& settings, const Margin& margin) {
  collect_proxies(bodies, margin);
  broad_phase.find_pairs(proxies_, pairs_);
  sort_pairs();
  collide_pairs(bodies, settings, margin);
}

void ContactSet::collect_proxies(const BodySet& bodies, const Margin& margin) {
  proxies_.clear();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyDetail& body = bodies.detail[i];
    if (!body.inserted) continue;
    const Real by = margin.distance / 2 + travel(bodies, i, margin);
    for (std::size_t p = 0; p < body.parts.size(); ++p) {
      proxies_.push_back({grown(body.parts[p].shape.bounds(bodies.pose[i]), by), static_cast<std::uint32_t>(i),
                          static_cast<std::uint16_t>(p), body.def.type == BodyType::dynamic, body.def.layers});
    }
  }
}

// Pairs come in order of (body_a, part_a, body_b, part_b): right already where no body has several parts.
void ContactSet::sort_pairs() {
  const auto by_bodies_first = [this](const Pair& left, const Pair& right) {
    const auto key = [this](const Pair& pair) {
      return std::tuple(proxies_[pair.first].body, proxies_[pair.second].body, pair.first, pair.second);
    };
    return key(left) < key(right);
  };
  if (!std::is_sorted(pairs_.begin(), pairs_.end(), by_bodies_first)) {
    std::sort(pairs_.begin(), pairs_.end(), by_bodies_first);
  }
}

void ContactSet::collide_pairs(const BodySet& bodies, const Settings& settings, const Margin& margin) {
  std::swap(rows_, last_rows_);
  rows_.clear();
  auto last = last_rows_.cbegin();
  for (const Pair& pair : pairs_) {
    const Proxy& a = proxies_[pair.first];
    const Proxy& b = proxies_[pair.second];
    const Part& part_a = bodies.detail[a.body].parts[a.part];
    const Part& part_b = bodies.detail[b.body].parts[b.part];
    const Manifold manifold = collide(part_a.shape, bodies.pose[a.body], part_b.shape, bodies.pose[b.body],
                                      closing(bodies, a.body, b.body, margin));
    if (manifold.count == 0) continue;
    Contact& contact = rows_.emplace_back(make(bodies, a, b, manifold));
    mix_materials(contact, part_a.material, part_b.material, settings);
    while (last != last_rows_.cend() && order(*last) < order(contact)) ++last;
    if (last != last_rows_.cend() && order(*last) == order(contact)) carry_over(contact, *last);
  }
}

void ContactSet::forget(std::size_t body) {
  std::erase_if(rows_, [body](const Contact& c) { return c.body_a == body || c.body_b == body; });
}

}  // namespace impulse::inline IMPULSE_PRECISION
