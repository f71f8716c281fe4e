#include "contact_set.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <tuple>

#include "closing.h"
#include "collide.h"
#include "ghosts.h"
#include "stages.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

auto key(const Contact& c) { return std::tie(c.body_a, c.body_b, c.part_a, c.part_b); }
auto key(const Proxy& a, const Proxy& b) { return std::tie(a.body, b.body, a.part, b.part); }

bool in_order(const Contact& left, const Contact& right) { return key(left) < key(right); }

bool of_sleepers(const Contact& c, const BodySet& bodies) {
  return bodies.asleep[c.body_a] != 0 || bodies.asleep[c.body_b] != 0;
}

/// m, of both bodies' motion together since the points were found; and the points count as touching (m) up to here.
constexpr Real recycled_motion = static_cast<Real>(0.01);
constexpr Real recycled_gap = static_cast<Real>(0.005);

/// How far any point of the body can have come since it was at `then`.
Real motion_since(const Pose& then, const BodySet& bodies, std::size_t i) {
  const Rotation turn = bodies.pose[i].q * then.q.inverse();
  return length(bodies.pose[i].p - then.p) + std::abs(turn.s) * bodies.reach[i];
}

bool recycled(const Contact& contact, const BodySet& bodies) {
  if (contact.discs) return false;
  for (std::size_t p = 0; p < static_cast<std::size_t>(contact.count); ++p) {
    if (contact.points[p].separation > recycled_gap) return false;
  }
  return motion_since(contact.found_a, bodies, contact.body_a) + motion_since(contact.found_b, bodies, contact.body_b) <
         recycled_motion;
}

/// The same points on the same bodies, which have moved a little.
void measure_again(Contact& contact, const BodySet& bodies) {
  const Pose& a = bodies.pose[contact.body_a];
  const Pose& b = bodies.pose[contact.body_b];
  const Rotation turn_a = a.q * contact.found_a.q.inverse();
  const Rotation turn_b = b.q * contact.found_b.q.inverse();
  const Vec2 apart = (b.p - contact.found_b.p) - (a.p - contact.found_a.p);
  for (std::size_t p = 0; p < static_cast<std::size_t>(contact.count); ++p) {
    ContactPoint& point = contact.points[p];
    const Vec2 arms = (turn_b * point.arm_b - point.arm_b) - (turn_a * point.arm_a - point.arm_a);
    point.separation = contact.found_separation[p] + dot(contact.normal, apart + arms);
    point.fresh = false;
  }
  ++contact.age;
}

void take_points(Contact& contact, const BodySet& bodies, const Manifold& manifold) {
  const Vec2 a = bodies.pose[contact.body_a].p;
  const Vec2 b = bodies.pose[contact.body_b].p;
  contact.normal = manifold.normal;
  contact.found_a = bodies.pose[contact.body_a];
  contact.found_b = bodies.pose[contact.body_b];
  contact.count = manifold.count;
  for (std::size_t p = 0; p < static_cast<std::size_t>(manifold.count); ++p) {
    const ManifoldPoint& found = manifold.points[p];
    ContactPoint& point = contact.points[p];
    point = {};
    point.arm_a = found.point - a;
    point.arm_b = found.point - b;
    point.separation = found.separation;
    point.feature = found.feature;
    contact.found_separation[p] = found.separation;
  }
}

Contact make(const BodySet& bodies, const Proxy& a, const Proxy& b, const Manifold& manifold) {
  Contact contact;
  contact.body_a = a.body;
  contact.body_b = b.body;
  contact.part_a = a.part;
  contact.part_b = b.part;
  const Shape& shape_a = bodies.detail[a.body].parts[a.part].shape;
  const Shape& shape_b = bodies.detail[b.body].parts[b.part].shape;
  contact.radius_a = shape_a.radius();
  contact.radius_b = shape_b.radius();
  const auto disc = [](const Shape& shape) { return shape.type() == ShapeType::circle && shape.vertex(0) == Vec2{}; };
  contact.discs = disc(shape_a) && disc(shape_b);
  take_points(contact, bodies, manifold);
  return contact;
}

void mix_materials(Contact& contact, const Material& a, const Material& b, const Settings& settings) {
  contact.static_friction = mix(settings.friction_mixing, a.static_friction, b.static_friction);
  contact.dynamic_friction = mix(settings.friction_mixing, a.dynamic_friction, b.dynamic_friction);
  contact.restitution = mix(settings.restitution_mixing, a.restitution, b.restitution);
}

void carry_impulses(Contact& contact, const Contact& last) {
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

void carry_over(Contact& contact, const Contact& last) {
  contact.age = last.age + 1;
  contact.offset = last.offset;
  carry_impulses(contact, last);
}

}  // namespace

void ContactSet::find(const BodySet& bodies, BroadPhase& broad_phase, const Settings& settings, const Margin& margin,
                      bool recycle, const JointSet& joints) {
  knocks_.assign(bodies.size(), 0);
  search(bodies, broad_phase, settings, margin, recycle, joints);
  const bool knocked = foresee_knocks(bodies, margin);
  end_stage("foresee knocks");
  // Once: what a third body is handed on within the same step is little.
  if (knocked) {
    std::swap(rows_, last_rows_);
    search(bodies, broad_phase, settings, margin, recycle, joints);
  }
  remove_ghosts(bodies, margin);
  end_stage("remove ghosts");
}

void ContactSet::search(const BodySet& bodies, BroadPhase& broad_phase, const Settings& settings, const Margin& margin,
                        bool recycle, const JointSet& joints) {
  collect_proxies(bodies, margin);
  end_stage("collect proxies");
  broad_phase.find_pairs(proxies_, pairs_);
  end_stage("find pairs");
  sort_pairs(bodies.size());
  end_stage("sort pairs");
  collide_pairs(bodies, settings, margin, recycle, joints);
  end_stage("collide pairs");
}

/// Two bodies that meet at a speed u change each other's by (1 + e) u mB / (mA + mB) at most. What is struck within the
/// step may then meet others than those it was on its way to: a disc thrown back into its followers, the next in a
/// stack that lands. Whether that takes any farther than the margin already allows for.
bool ContactSet::foresee_knocks(const BodySet& bodies, const Margin& margin) {
  const Real felt = margin.distance / 2;
  bool farther = false;
  const auto knock = [&](std::size_t i, Real change) {
    if (margin.time * change <= felt) return;
    knocks_[i] = std::max(knocks_[i], change);
    farther = true;
  };
  for (const Contact& contact : rows_) {
    const std::size_t a = contact.body_a;
    const std::size_t b = contact.body_b;
    Real gap = contact.points[0].separation;
    if (contact.count == 2) gap = std::min(gap, contact.points[1].separation);
    const Real apart = dot(contact.normal, bodies.velocity[b].v - bodies.velocity[a].v);
    const Real turning = rim_speed(bodies, a) + rim_speed(bodies, b);
    const Real speed = turning - apart;
    if (margin.time * speed <= std::max(gap, felt)) continue;
    const Real mass_a = bodies.inverse_mass[a].m;
    const Real mass_b = bodies.inverse_mass[b].m;
    const Real change = (1 + contact.restitution) * speed / (mass_a + mass_b);
    knock(a, change * mass_a);
    knock(b, change * mass_b);
  }
  return farther;
}

void ContactSet::collect_proxies(const BodySet& bodies, const Margin& margin) {
  proxies_.clear();
  several_parts_ = false;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyDetail& body = bodies.detail[i];
    if (!body.inserted || bodies.asleep[i] != 0) continue;
    several_parts_ |= body.parts.size() > 1;
    const Real by = margin.distance / 2 + travel(bodies, i, margin) + margin.time * knocks_[i];
    for (std::size_t p = 0; p < body.parts.size(); ++p) {
      proxies_.push_back({grown(body.parts[p].shape.bounds(bodies.pose[i]), by), static_cast<std::uint32_t>(i),
                          static_cast<std::uint16_t>(p), body.def.type == BodyType::dynamic, body.def.layers});
    }
  }
}

// Pairs come in order of (body_a, part_a, body_b, part_b): right already where no body has several parts.
void ContactSet::sort_pairs(std::size_t bodies) {
  if (!several_parts_) return;
  order_.stable_sort(bodies, pairs_, [this](const Pair& pair) { return proxies_[pair.second].body; });
  order_.stable_sort(bodies, pairs_, [this](const Pair& pair) { return proxies_[pair.first].body; });
}

void ContactSet::collide_pairs(const BodySet& bodies, const Settings& settings, const Margin& margin, bool recycle,
                               const JointSet& joints) {
  std::swap(rows_, last_rows_);
  rows_.clear();
  on_ground_.clear();
  auto last = last_rows_.cbegin();
  for (const Pair& pair : pairs_) {
    const Proxy& a = proxies_[pair.first];
    const Proxy& b = proxies_[pair.second];
    if (joints.ties(a.body, b.body)) continue;
    while (last != last_rows_.cend() && key(*last) < key(a, b)) ++last;
    const bool known = last != last_rows_.cend() && key(*last) == key(a, b);
    const Part& part_a = bodies.detail[a.body].parts[a.part];
    const Part& part_b = bodies.detail[b.body].parts[b.part];
    const auto note_ground = [&] {
      if (a.moves == b.moves || bodies.stirs(a.moves ? b.body : a.body)) return;
      const Proxy& moving = a.moves ? a : b;
      on_ground_.push_back({moving.body, moving.part, a.moves, rows_.size()});
    };
    if (known && recycle && recycled(*last, bodies)) {
      note_ground();
      rows_.push_back(*last);
      measure_again(rows_.back(), bodies);
      mix_materials(rows_.back(), part_a.material, part_b.material, settings);
      continue;
    }
    const Manifold manifold =
        collide(part_a.shape, bodies.pose[a.body], part_b.shape, bodies.pose[b.body],
                closing(bodies, a.body, b.body, margin) + margin.time * (knocks_[a.body] + knocks_[b.body]));
    if (manifold.count == 0) continue;
    note_ground();
    Contact& contact = rows_.emplace_back(make(bodies, a, b, manifold));
    mix_materials(contact, part_a.material, part_b.material, settings);
    if (known) carry_over(contact, *last);
  }
}

// Only a part that meets several fixed shapes can meet a join of them.
void ContactSet::remove_ghosts(const BodySet& bodies, const Margin& margin) {
  const auto part = [](const OnGround& meets) { return std::tie(meets.body, meets.part); };
  const auto before = [&](const OnGround& left, const OnGround& right) { return part(left) < part(right); };
  // In order already on a single floor, and sorting takes memory.
  if (!std::is_sorted(on_ground_.begin(), on_ground_.end(), before)) {
    std::stable_sort(on_ground_.begin(), on_ground_.end(), before);
  }
  for (auto first = on_ground_.cbegin(), next = first; first != on_ground_.cend(); first = next) {
    next = std::find_if(first, on_ground_.cend(), [&](const OnGround& meets) { return part(meets) != part(*first); });
    if (next - first > 1) remove_ghosts({first, next}, bodies, margin);
  }
  std::erase_if(rows_, [](const Contact& contact) { return contact.count == 0; });
}

// A face that has taken the place of a ghost hides others in turn: those two joins ahead.
void ContactSet::remove_ghosts(std::span<const OnGround> of_part, const BodySet& bodies, const Margin& margin) {
  supports_.assign(of_part.begin(), of_part.end());
  for (std::size_t i = 0; i < supports_.size(); ++i) {
    const OnGround below = supports_[i];
    if (rows_[below.row].count == 0) continue;
    const std::optional<Plane> plane = face_under(Meeting(rows_[below.row], bodies, below.dynamic_first), bodies);
    if (!plane) continue;
    for (const OnGround& ahead : of_part) {
      Contact& contact = rows_[ahead.row];
      if (ahead.row == below.row || contact.count == 0) continue;
      const std::optional<Manifold> instead =
          without_ghost(Meeting(contact, bodies, ahead.dynamic_first), *plane, bodies, margin);
      if (!instead) continue;
      const Contact was = contact;
      take_points(contact, bodies, *instead);
      carry_impulses(contact, was);
      supports_.push_back(ahead);
    }
  }
}

void ContactSet::forget(std::size_t body) {
  const auto of_it = [body](const Contact& c) { return c.body_a == body || c.body_b == body; };
  std::erase_if(rows_, of_it);
  std::erase_if(resting_, of_it);
}

void ContactSet::lay_to_rest(const BodySet& bodies) {
  const auto passed_by = [&](std::uint32_t body) { return bodies.dynamic(body) && bodies.asleep[body] == 0; };
  std::copy_if(rows_.begin(), rows_.end(), std::back_inserter(resting_), [&](const Contact& c) {
    return of_sleepers(c, bodies) && !passed_by(c.body_a) && !passed_by(c.body_b);
  });
  std::sort(resting_.begin(), resting_.end(), in_order);
  std::erase_if(rows_, [&](const Contact& c) { return of_sleepers(c, bodies); });
}

void ContactSet::take_back(const BodySet& bodies) {
  const auto woken =
      std::stable_partition(resting_.begin(), resting_.end(), [&](const Contact& c) { return of_sleepers(c, bodies); });
  const auto awake = static_cast<std::ptrdiff_t>(rows_.size());
  rows_.insert(rows_.end(), woken, resting_.end());
  resting_.erase(woken, resting_.end());
  std::inplace_merge(rows_.begin(), rows_.begin() + awake, rows_.end(), in_order);
}

std::vector<const Contact*> ContactSet::all() const {
  std::vector<const Contact*> merged;
  merged.reserve(rows_.size() + resting_.size());
  for (const Contact& contact : rows_) merged.push_back(&contact);
  for (const Contact& contact : resting_) merged.push_back(&contact);
  std::inplace_merge(merged.begin(), merged.begin() + static_cast<std::ptrdiff_t>(rows_.size()), merged.end(),
                     [](const Contact* left, const Contact* right) { return in_order(*left, *right); });
  return merged;
}

}  // namespace impulse::inline IMPULSE_PRECISION
