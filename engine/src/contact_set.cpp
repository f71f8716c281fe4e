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

/// The order of contacts as two numbers.
struct Key {
  std::uint64_t bodies;
  std::uint32_t parts;

  explicit Key(const Contact& c) : Key(c.body_a, c.body_b, c.part_a, c.part_b) {}
  Key(const Proxy& a, const Proxy& b) : Key(a.body, b.body, a.part, b.part) {}
  Key(std::uint32_t a, std::uint32_t b, std::uint16_t part_a, std::uint16_t part_b)
      : bodies(std::uint64_t{a} << 32U | b), parts(std::uint32_t{part_a} << 16U | part_b) {}
  bool operator<(const Key& other) const {
    return bodies != other.bodies ? bodies < other.bodies : parts < other.parts;
  }
  bool operator==(const Key&) const = default;
};

bool in_order(const Contact& left, const Contact& right) { return key(left) < key(right); }

bool of_sleepers(const Contact& c, const BodySet& bodies) {
  return bodies.asleep[c.body_a] != 0 || bodies.asleep[c.body_b] != 0;
}

/// m, of both bodies' motion together since the points were found; and the points count as touching (m) up to here.
constexpr Real recycled_motion = static_cast<Real>(0.01);
constexpr Real recycled_gap = static_cast<Real>(0.005);

/// Instead of a count of points found: those of the contact's last step stay, with separations measured again.
constexpr std::int32_t kept = -1;

bool may_keep(const Contact& contact) {
  if (contact.discs) return false;
  for (std::size_t p = 0; p < static_cast<std::size_t>(contact.count); ++p) {
    if (contact.points[p].separation > recycled_gap) return false;
  }
  return true;
}

void keep_points(Contact& contact, const PairPoints& again) {
  for (std::size_t p = 0; p < static_cast<std::size_t>(contact.count); ++p) {
    contact.points[p].separation = again.separation[p];
    contact.points[p].fresh = false;
  }
}

void take_points(Contact& contact, const BodySet& bodies, const PairPoints& found) {
  contact.normal = {found.normal[0], found.normal[1]};
  contact.found_a = bodies.pose[contact.body_a];
  contact.found_b = bodies.pose[contact.body_b];
  contact.found_separation = {};
  contact.count = found.count;
  contact.points = {};
  for (std::size_t p = 0; p < static_cast<std::size_t>(found.count); ++p) {
    ContactPoint& point = contact.points[p];
    const Real* arms = found.arms[p];
    point.arm_a = {arms[0], arms[1]};
    point.arm_b = {arms[2], arms[3]};
    point.separation = found.separation[p];
    point.feature = found.feature[p];
    contact.found_separation[p] = found.separation[p];
  }
}

/// One without points.
Contact begin(const Proxy& a, const Proxy& b, const Shape& shape_a, const Shape& shape_b) {
  Contact contact;
  contact.body_a = a.body;
  contact.body_b = b.body;
  contact.part_a = a.part;
  contact.part_b = b.part;
  contact.radius_a = shape_a.radius();
  contact.radius_b = shape_b.radius();
  const auto disc = [](const Shape& shape) { return shape.type() == ShapeType::circle && shape.vertex(0) == Vec2{}; };
  contact.discs = disc(shape_a) && disc(shape_b);
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

}  // namespace

void ContactSet::find(const BodySet& bodies, BroadPhase& broad_phase, const Settings& settings, const Margin& margin,
                      bool recycle, const JointSet& joints) {
  const Step step{bodies, broad_phase, settings, margin, recycle, joints};
  const bool same_rules = mixed_by_ && mixed_by_->friction == settings.friction_mixing &&
                          mixed_by_->restitution == settings.restitution_mixing;
  if (!same_rules) mix_again(bodies, settings);
  knocks_.assign(bodies.size(), 0);
  search(step);
  // Once: what a third body is handed on within the same step is little.
  if (margin.time > 0 && foresee_knocks(step)) search(step);
  end_stage("foresee knocks");
  write_rows(step);
  end_stage("write rows");
  remove_ghosts(bodies, margin);
  end_stage("remove ghosts");
}

void ContactSet::search(const Step& step) {
  shapes_.update(step.bodies, step.margin, knocks_);
  end_stage("collect proxies");
  step.broad_phase.find_pairs(shapes_.proxies(), pairs_);
  end_stage("find pairs");
  sort_pairs(step.bodies.size());
  leave_out_tied(step.joints);
  end_stage("sort pairs");
  match();
  end_stage("match");
  found_.resize(pairs_.size());
  keep_points_of_resting(step);
  end_stage("recycle");
  narrow_phase_.collide(step.bodies, shapes_, step.margin, pairs_, to_collide_, found_.data());
  end_stage("collide pairs");
}

// Pairs come in order of (body_a, part_a, body_b, part_b): right already where no body has several parts.
void ContactSet::sort_pairs(std::size_t bodies) {
  if (!shapes_.several_parts()) return;
  const std::span<const Proxy> proxies = shapes_.proxies();
  order_.stable_sort(bodies, pairs_, [proxies](const Pair& pair) { return proxies[pair.second].body; });
  order_.stable_sort(bodies, pairs_, [proxies](const Pair& pair) { return proxies[pair.first].body; });
}

void ContactSet::leave_out_tied(const JointSet& joints) {
  if (joints.tied().empty()) return;
  const std::span<const Proxy> proxies = shapes_.proxies();
  std::erase_if(pairs_,
                [&](const Pair& pair) { return joints.ties(proxies[pair.first].body, proxies[pair.second].body); });
}

/// Both lists are in one order: one walk along both.
void ContactSet::match() {
  const std::span<const Proxy> proxies = shapes_.proxies();
  last_of_.resize(pairs_.size());
  std::uint32_t last = 0;
  const auto end = static_cast<std::uint32_t>(rows_.size());
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const Key wanted(proxies[pairs_[i].first], proxies[pairs_[i].second]);
    while (last < end && Key(rows_[last]) < wanted) ++last;
    const bool known = last < end && Key(rows_[last]) == wanted;
    last_of_[i] = known ? last : none;
    last += known ? 1 : 0;
  }
}

void ContactSet::keep_points_of_resting(const Step& step) {
  to_keep_.clear();
  to_collide_.clear();
  again_of_.clear();
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) {
    if (step.recycle && last_of_[i] != none && may_keep(rows_[last_of_[i]])) {
      to_keep_.push_back(i);
      again_of_.push_back(last_of_[i]);
    } else {
      to_collide_.push_back(i);
    }
  }
  if (to_keep_.empty()) return;
  again_.resize(to_keep_.size());
  kernels().measure_again(rows_.data(), again_of_.data(), static_cast<std::uint32_t>(again_of_.size()),
                          step.bodies.pose.data(), step.bodies.reach.data(), again_.data());
  for (std::size_t i = 0; i < to_keep_.size(); ++i) {
    if (again_[i].motion < recycled_motion) {
      PairPoints& found = found_[to_keep_[i]];
      found.count = kept;
      found.separation[0] = again_[i].separation[0];
      found.separation[1] = again_[i].separation[1];
    } else {
      to_collide_.push_back(to_keep_[i]);
    }
  }
}

/// Two bodies that meet at a speed u change each other's by (1 + e) u mB / (mA + mB) at most. What is struck within the
/// step may then meet others than those it was on its way to: a disc thrown back into its followers, the next in a
/// stack that lands. Whether that takes any farther than the margin already allows for.
bool ContactSet::foresee_knocks(const Step& step) {
  const BodySet& bodies = step.bodies;
  const Margin& margin = step.margin;
  const Real felt = margin.distance / 2;
  bool farther = false;
  const auto knock = [&](std::size_t i, Real change) {
    if (margin.time * change <= felt) return;
    knocks_[i] = std::max(knocks_[i], change);
    farther = true;
  };
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const PairPoints& found = found_[i];
    if (found.count == 0) continue;
    const ShapeRecord& record_a = shapes_.records()[pairs_[i].first];
    const ShapeRecord& record_b = shapes_.records()[pairs_[i].second];
    const bool stays = found.count == kept;
    const Vec2 normal = stays ? rows_[last_of_[i]].normal : Vec2{found.normal[0], found.normal[1]};
    Real gap = found.separation[0];
    if ((stays ? rows_[last_of_[i]].count : found.count) == 2) gap = std::min(gap, found.separation[1]);
    const Real apart = dot(normal, record_b.velocity - record_a.velocity);
    const Real turning = record_a.rim + record_b.rim;
    const Real speed = turning - apart;
    if (margin.time * speed <= std::max(gap, felt)) continue;
    const std::size_t a = shapes_.proxies()[pairs_[i].first].body;
    const std::size_t b = shapes_.proxies()[pairs_[i].second].body;
    const Real mass_a = bodies.inverse_mass[a].m;
    const Real mass_b = bodies.inverse_mass[b].m;
    const Real restitution = mix(step.settings.restitution_mixing, shapes_.part(pairs_[i].first).material.restitution,
                                 shapes_.part(pairs_[i].second).material.restitution);
    const Real change = (1 + restitution) * speed / (mass_a + mass_b);
    knock(a, change * mass_a);
    knock(b, change * mass_b);
  }
  return farther;
}

void ContactSet::write_rows(const Step& step) {
  std::swap(rows_, last_rows_);
  rows_.resize(static_cast<std::size_t>(
      std::count_if(found_.begin(), found_.end(), [](const PairPoints& found) { return found.count != 0; })));
  on_ground_.clear();
  std::size_t next = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const PairPoints& found = found_[i];
    if (found.count == 0) continue;
    const Proxy& a = shapes_.proxies()[pairs_[i].first];
    const Proxy& b = shapes_.proxies()[pairs_[i].second];
    if (a.moves != b.moves && !step.bodies.stirs(a.moves ? b.body : a.body)) {
      const Proxy& moving = a.moves ? a : b;
      on_ground_.push_back({moving.body, moving.part, a.moves, next});
    }
    Contact& row = rows_[next++];
    if (last_of_[i] == none) {
      const Part& part_a = shapes_.part(pairs_[i].first);
      const Part& part_b = shapes_.part(pairs_[i].second);
      row = begin(a, b, part_a.shape, part_b.shape);
      mix_materials(row, part_a.material, part_b.material, step.settings);
      take_points(row, step.bodies, found);
      continue;
    }
    const Contact& last = last_rows_[last_of_[i]];
    row = last;
    ++row.age;
    if (found.count == kept) {
      keep_points(row, found);
    } else {
      take_points(row, step.bodies, found);
      carry_impulses(row, last);
    }
  }
}

/// The rules of mixing have changed.
void ContactSet::mix_again(const BodySet& bodies, const Settings& settings) {
  mixed_by_ = {settings.friction_mixing, settings.restitution_mixing};
  for (Contact& contact : rows_) {
    mix_materials(contact, bodies.detail[contact.body_a].parts[contact.part_a].material,
                  bodies.detail[contact.body_b].parts[contact.part_b].material, settings);
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
      take_points(contact, bodies, points_of(*instead, bodies.pose[contact.body_a].p, bodies.pose[contact.body_b].p));
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
  mixed_by_.reset();  // they may be from before a change
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
