#include "contacts/contact_search.h"

#include <algorithm>
#include <cmath>

#include "contacts/lanes/persistence.h"
#include "contacts/part_filter.h"
#include "core/stages.h"
#include "impulse/material.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// m: contacts persist while both bodies together have moved by less than this since the points were found, if the
/// points are closer than the gap.
constexpr Real most_persistent_motion = static_cast<Real>(0.01);
constexpr Real most_persistent_turn = static_cast<Real>(0.001);  // rad, of normals: a share of what they bear
constexpr Real most_persistent_gap = static_cast<Real>(0.005);

/// m: what is as near to two bodies may bear the one against the other.
constexpr Real most_bearing_gap = static_cast<Real>(0.005);

Real gap_of(const PairPoints& found) {
  return found.count == 2 ? std::min(found.separation[0], found.separation[1]) : found.separation[0];
}
Vec2 normal_of(const PairPoints& found) { return {found.normal[0], found.normal[1]}; }

/// Whether the points may persist. The normal of rounded shapes turns as they roll over a corner, by a tenth for a disc
/// of a decimetre.
bool lasting(const Contact& contact, const BodySet& bodies) {
  const bool first = contact.points[0].separation > most_persistent_gap;
  const bool second = (contact.count > 1) & (contact.points[1].separation > most_persistent_gap);
  if (first | second) return false;
  return contact.radius_a + contact.radius_b == 0 || owner(contact, bodies) != NormalOf::between;
}

}  // namespace

void ContactSearch::search(const SearchInput& input, std::span<Contact> last, bool undisturbed) {
  last_ = last;
  const std::uint64_t last_version = shapes_.version();
  shapes_.update(input.bodies, input.margin);
  note_motion(input, undisturbed);
  end_stage("collect proxies");
  last_pairs_.swap(pairs_);
  neighbours_.find(input.broad_phase, shapes_.proxies(), shapes_.version(), pairs_);
  shapes_.update(input.bodies, input.margin, pairs_);
  end_stage("find pairs");
  put_in_order(input, pairs_);
  end_stage("sort pairs");
  match(undisturbed && shapes_.version() == last_version);
  end_stage("match");
  while (numbers_.size() < pairs_.size()) numbers_.push_back(static_cast<std::uint32_t>(numbers_.size()));
  const std::span<const std::uint32_t> all = std::span(numbers_).first(pairs_.size());
  find_points(input, all);
  list_touching(all);
  end_stage("list touching");
  hit_piles_.clear();
  const bool impacts = input.margin.time > 0 && predict_impacts(input);
  end_stage("predict impacts");
  if (impacts) {
    pass_impacts_on(input);
    search_farther(input);
  }
  std::sort(hit_piles_.begin(), hit_piles_.end());
  hit_piles_.erase(std::unique(hit_piles_.begin(), hit_piles_.end()), hit_piles_.end());
  found_the_same_ = touching_are_last();
}

/// Removes pairs that are apart, joined or refused by the filter, and sorts the others in the order of contacts.
void ContactSearch::put_in_order(const SearchInput& input, std::vector<Pair>& pairs) {
  const std::span<const Proxy> proxies = shapes_.proxies();
  const JointSet& joints = input.joints;
  const bool joined = !joints.empty();
  if (joined || input.filter || shapes_.some_slanted()) {
    std::size_t left = 0;
    for (const Pair& pair : pairs) {
      const Proxy& a = proxies[pair.first];
      const Proxy& b = proxies[pair.second];
      const bool apart = shapes_.apart(pair.first, pair.second) || (joined && joints.connects(a.body, b.body)) ||
                         !accepts(input.filter, input.bodies, a.body, a.part, b.body, b.part);
      pairs[left] = pair;
      left += apart ? 0 : 1;
    }
    pairs.resize(left);
  }
  if (!shapes_.several_parts()) return;
  // They are sorted by (body_a, part_a, body_b, part_b), which differs only if body_a has several parts.
  const auto body_a = [proxies](const Pair& pair) { return proxies[pair.first].body; };
  const auto body_b = [proxies](const Pair& pair) { return proxies[pair.second].body; };
  const auto of_later_part = [proxies](const Pair& pair) { return proxies[pair.first].part != 0; };
  for (auto later = pairs.begin();;) {
    later = std::find_if(later, pairs.end(), of_later_part);
    if (later == pairs.end()) return;
    const std::uint32_t body = body_a(*later);
    auto first = later;
    while (first != pairs.begin() && body_a(*std::prev(first)) == body) --first;
    later = std::find_if(later, pairs.end(), [&](const Pair& pair) { return body_a(pair) != body; });
    pair_order_.stable_sort(input.bodies.size(), {first, later}, body_b);
  }
}

/// Finds the last contact of each pair. Pairs and contacts are in the same order, so one pass over both suffices. While
/// the proxies are the same and no contact was removed or added, the last touching pairs stand for the contacts, which
/// reads less memory; and if the pairs are the same too, and the last search found the contacts of the one before,
/// nothing changes.
void ContactSearch::match(bool undisturbed) {
  last_of_.resize(pairs_.size());
  std::uint32_t last = 0;
  if (!undisturbed) {
    for (std::size_t i = 0; i < pairs_.size(); ++i) last_of_[i] = find_last(order_of(pairs_[i]), last);
    return;
  }
  if (found_the_same_ && pairs_ == last_pairs_) return;
  const auto count = static_cast<std::uint32_t>(touching_.size());
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const Pair pair = pairs_[i];
    while (last < count && before(last_pairs_[touching_[last]], pair)) ++last;
    const bool known = last < count && last_pairs_[touching_[last]] == pair;
    last_of_[i] = known ? last++ : none;
  }
}

/// Advances `place` in `last_` to where the contact would be, and past it if it is there.
std::uint32_t ContactSearch::find_last(const ContactOrder& wanted, std::uint32_t& place) const {
  while (place < last_.size() && ContactOrder(last_[place]) < wanted) ++place;
  const bool known = place < last_.size() && ContactOrder(last_[place]) == wanted;
  return known ? place++ : none;
}

/// The points of persistent contacts, or new ones.
void ContactSearch::find_points(const SearchInput& input, std::span<const std::uint32_t> of_pairs) {
  counts_.resize(pairs_.size());
  found_.resize(pairs_.size());
  persist_points(input, of_pairs);
  end_stage("persist");
  narrow_phase_.collide(input.bodies, shapes_, input.margin, pairs_, to_collide_, found_.data());
  for (const std::uint32_t pair : to_collide_) counts_[pair] = static_cast<std::int8_t>(found_[pair].count);
  end_stage("collide pairs");
}

/// Updates the contacts that persist (see ContactSet::find), and lists all other pairs to be collided.
void ContactSearch::persist_points(const SearchInput& input, std::span<const std::uint32_t> of_pairs) {
  // Both lists are written for every pair, but only the right one advances: a branch would be unpredictable.
  to_collide_.resize(of_pairs.size());
  may_persist_.resize(of_pairs.size());
  candidate_contacts_.resize(of_pairs.size());
  std::size_t collided = 0;
  std::size_t candidates = 0;
  for (const std::uint32_t pair : of_pairs) {
    const std::uint32_t last = last_of_[pair];
    const bool still = moved_[pairs_[pair].first] + moved_[pairs_[pair].second] < most_persistent_motion;
    // Points found by the last search cannot persist if the bodies have moved since: no need to visit the contact.
    const std::size_t may =
        input.persistence && last != none && (still || collided_[last] == 0) && lasting(last_[last], input.bodies) ? 1
                                                                                                                   : 0;
    to_collide_[collided] = pair;
    may_persist_[candidates] = pair;
    candidate_contacts_[candidates] = last;
    collided += 1 - may;
    candidates += may;
  }
  candidate_contacts_.resize(candidates);
  kept_.resize(candidates);
  contact_kernels().persist_points(last_.data(), candidate_contacts_.data(), static_cast<std::uint32_t>(candidates),
                                   input.bodies.pose.data(), input.bodies.bounding_radius.data(),
                                   {most_persistent_motion, most_persistent_turn}, kept_.data());
  for (std::size_t i = 0; i < candidates; ++i) {
    const std::uint32_t pair = may_persist_[i];
    counts_[pair] = persistent;
    to_collide_[collided] = pair;
    collided += kept_[i] != 0 ? 0 : 1;
  }
  to_collide_.resize(collided);
}

/// Records how far each proxy's body has moved since the last search, and which contacts that search collided. With few
/// contacts it does not pay, and all count as unmoved.
void ContactSearch::note_motion(const SearchInput& input, bool undisturbed) {
  constexpr std::size_t worth_it = 64;
  const BodySet& bodies = input.bodies;
  const std::span<const Proxy> proxies = shapes_.proxies();
  collided_.assign(last_.size(), 0);
  moved_.assign(proxies.size(), 0);
  if (last_.size() < worth_it) return poses_.clear();
  const bool known = poses_.size() == bodies.size();
  if (!known) poses_ = bodies.pose;
  for (std::size_t i = 0; i < collided_.size(); ++i)
    collided_[i] = undisturbed && known && !persists(touching_[i]) ? 1 : 0;
  for (std::size_t i = 0; i < proxies.size(); ++i) {
    const std::size_t body = proxies[i].body;
    const Pose& now = bodies.pose[body];
    const Pose& then = poses_[body];
    moved_[i] = length(now.p - then.p) + std::abs((now.q * then.q.inverse()).s) * bodies.bounding_radius[body];
  }
  poses_ = bodies.pose;
}

void ContactSearch::list_touching(std::span<const std::uint32_t> in_order) {
  touching_.resize(in_order.size());
  std::size_t next = 0;
  for (const std::uint32_t pair : in_order) {
    touching_[next] = pair;
    next += counts_[pair] != 0 ? 1 : 0;
  }
  touching_.resize(next);
}

bool ContactSearch::touching_are_last() const {
  if (touching_.size() != last_.size()) return false;
  for (std::uint32_t i = 0; i < touching_.size(); ++i) {
    if (last_of_[touching_[i]] != i) return false;
  }
  return true;
}

/// Two bodies that hit each other at a speed u change the velocity of a by at most (1 + e) u mB / (mA + mB), in any
/// direction; or, if something bears b, by (1 + e) u along the normal. A body that is hit within the step may then hit
/// others than those it was approaching: a disc thrown back into its followers, the next box in a stack that lands.
/// Returns whether that moves any body farther than the margin allows for.
bool ContactSearch::predict_impacts(const SearchInput& input) {
  const BodySet& bodies = input.bodies;
  const Margin& margin = input.margin;
  const Real allowed = margin.distance / 2;
  // 1/64 is for rounding.
  const auto too_slow = [&](Real speed) { return margin.time * speed <= allowed * (Real{63} / 64); };
  if (too_slow(2 * shapes_.fastest())) return false;
  impact_changes_.assign(bodies.size(), 0);
  any_way_.assign(bodies.size(), 0);
  thrusts_.assign(bodies.size(), {});
  hit_by_.assign(bodies.size(), none);
  count_bearing();
  bool farther = false;
  const auto count = static_cast<std::uint32_t>(touching_.size());
  const PairBatch all{shapes_.records().data(), pairs_.data(), touching_.data(), count, allowed, margin.time};
  fast_.resize(count);
  const std::uint32_t* end = narrow_phase_kernels().find_fast(all, found_.data(), counts_.data(), fast_.data());
  for (const std::uint32_t pair : std::span(fast_.data(), end)) {
    const ShapeRecord& record_a = shapes_.records()[pairs_[pair].first];
    const ShapeRecord& record_b = shapes_.records()[pairs_[pair].second];
    const Vec2 between = record_b.velocity - record_a.velocity;
    const Real turning = record_a.rim + record_b.rim;
    const Vec2 normal = persists(pair) ? last_[last_of_[pair]].normal : normal_of(found_[pair]);
    const Real speed = turning - dot(normal, between);
    const Real gap = gap_between(pair);
    if (margin.time * speed <= std::max(gap, allowed)) continue;
    const std::size_t a = first(pair).body;
    const std::size_t b = second(pair).body;
    const Real inv_mass_a = bodies.inverse_mass[a].m;
    const Real inv_mass_b = bodies.inverse_mass[b].m;
    const Real restitution = mix(input.settings.restitution_mixing, shapes_.restitution(pairs_[pair].first),
                                 shapes_.restitution(pairs_[pair].second));
    const Real bounce = (1 + restitution) * speed;
    // What joints hold may have any mass.
    const auto change_by = [&](std::size_t other, Real own) {
      const bool joined = !input.joints.partners(static_cast<std::uint32_t>(other)).empty();
      return joined && own > 0 ? bounce : bounce * own / (inv_mass_a + inv_mass_b);
    };
    const Vec2 thrust = bounce * normal;
    const std::uint32_t each_other = gap <= most_bearing_gap ? 1 : 0;
    const bool from_a = bearing_[a] > each_other && inv_mass_b > 0;
    const bool from_b = bearing_[b] > each_other && inv_mass_a > 0;
    farther |= change_velocity(input, {a, b, change_by(b, inv_mass_a), from_b ? -thrust : Vec2{}});
    farther |= change_velocity(input, {b, a, change_by(a, inv_mass_b), from_a ? thrust : Vec2{}});
  }
  return farther;
}

/// Notes what a hit may change; returns whether that moves the body farther than the margin allows for, and than what
/// was noted.
bool ContactSearch::change_velocity(const SearchInput& input, const Change& hit) {
  const auto matters = [&](Real change) { return input.margin.time * change > input.margin.distance / 2; };
  const Real along = length(hit.thrust);
  const bool more = matters(hit.any_way) && hit.any_way > any_way_[hit.body];
  const bool farther_along = matters(along) && along > length(thrusts_[hit.body]);
  Real& most = impact_changes_[hit.body];
  // Of several that hit it the one that changes most, and none of two alike: in whatever order they come.
  const Real change = std::max(matters(hit.any_way) ? hit.any_way : Real{0}, matters(along) ? along : Real{0});
  if (change > most) hit_by_[hit.body] = static_cast<std::uint32_t>(hit.by);
  if (change == most && hit_by_[hit.body] != hit.by) hit_by_[hit.body] = none;
  if (!more && !farther_along) return false;
  if (more) any_way_[hit.body] = hit.any_way;
  if (farther_along) thrusts_[hit.body] = hit.thrust;
  most = std::max(most, change);
  if (input.bodies.pile[hit.body] != 0) hit_piles_.push_back(input.bodies.pile[hit.body]);
  return true;
}

/// Joints pass changes on at once, to all that they hold together: less than what was hit, but for levers.
void ContactSearch::pass_along_joints(const SearchInput& input) {
  if (input.joints.empty()) return;
  to_pass_.clear();
  for (std::uint32_t body = 0; body < changed_.size(); ++body) {
    if (changed_[body] != 0) to_pass_.push_back(body);
  }
  while (!to_pass_.empty()) {
    const std::uint32_t body = to_pass_.back();
    to_pass_.pop_back();
    for (const std::uint32_t partner : input.joints.partners(body)) {
      if (!input.bodies.pushable(partner)) continue;
      if (!change_velocity(input, {partner, body, impact_changes_[body], {}})) continue;
      changed_[partner] = 1;
      to_pass_.push_back(partner);
    }
  }
}

/// An impact changes the motion of what joints hold together by at most 1 + e times what that is relative to what hits
/// it, in the norm of kinetic energy, |u|^2 = sum of m v^2 + I w^2: of that it is a projection. So levers may make a
/// light partner of a body that is hit as fast as all of their energy would, and the points of its rim by
/// |u| sqrt(1/m + r^2/I). What is joined to a partner counts as part of it: along a chain it gets less.
void ContactSearch::pass_by_levers(const SearchInput& input) {
  if (input.joints.empty()) return;
  const BodySet& bodies = input.bodies;
  levered_.clear();
  for (std::uint32_t hit = 0; hit < changed_.size(); ++hit) {
    const std::span<const std::uint32_t> partners = input.joints.partners(hit);
    if (changed_[hit] == 0 || partners.empty()) continue;
    const Real change = impact_changes_[hit];
    Real norm = 0;
    bool anchored = false;
    const auto count = [&](std::uint32_t body) {
      const InverseMass& mass = bodies.inverse_mass[body];
      const Real speed = 2 * length(bodies.velocity[body].v - bodies.velocity[hit].v) + change;
      const Real spin = 2 * bodies.velocity[body].w;
      if (mass.m > 0) norm += speed * speed / mass.m;
      if (mass.i > 0) norm += spin * spin / mass.i;
      anchored = anchored || !bodies.pushable(body);
    };
    count(hit);
    for (const std::uint32_t partner : partners) count(partner);
    // What is held by fixed bodies is as fast as what hits it makes it, however light it is.
    const std::uint32_t by = hit_by_[hit];
    if (anchored && by != none && bodies.inverse_mass[by].m > 0) norm += change * change / bodies.inverse_mass[by].m;
    for (const std::uint32_t partner : partners) {
      if (!bodies.pushable(partner)) continue;
      const InverseMass& mass = bodies.inverse_mass[partner];
      const Real reach = bodies.bounding_radius[partner];
      levered_.push_back({partner, hit, std::sqrt(norm * (mass.m + reach * reach * mass.i)), {}});
    }
  }
  for (const Change& one : levered_) {
    if (change_velocity(input, one)) changed_[one.body] = 1;
  }
}

/// Counts what is near each body.
void ContactSearch::count_bearing() {
  bearing_.assign(hit_by_.size(), 0);
  for (const std::uint32_t pair : touching_) {
    if (gap_between(pair) > most_bearing_gap) continue;
    ++bearing_[first(pair).body];
    ++bearing_[second(pair).body];
  }
}

Real ContactSearch::gap_between(std::uint32_t pair) const {
  if (!persists(pair)) return gap_of(found_[pair]);
  const Contact& contact = last_[last_of_[pair]];
  const Real gap = contact.points[0].separation;
  return contact.count == 2 ? std::min(gap, contact.points[1].separation) : gap;
}

/// Whether predicted changes of velocity bring two bodies no nearer than the margin allows for.
bool ContactSearch::stay_apart(const Margin& margin, const Pair& pair, const PairPoints& found) const {
  const ShapeRecord& record_a = shapes_.records()[pair.first];
  const ShapeRecord& record_b = shapes_.records()[pair.second];
  const std::size_t a = shapes_.proxies()[pair.first].body;
  const std::size_t b = shapes_.proxies()[pair.second].body;
  const Vec2 between = record_b.velocity - record_a.velocity;
  const Vec2 normal = normal_of(found);
  const Real any_way = length(between) + any_way_[a] + any_way_[b];
  const Real along = std::max(any_way_[a], dot(normal, thrusts_[a])) +
                     std::max(any_way_[b], -dot(normal, thrusts_[b])) - dot(normal, between);
  return gap_of(found) > margin.distance + margin.time * (std::max(any_way, along) + record_a.rim + record_b.rim);
}

/// What is hit hits others within the same step: the balls of a cradle one after the other, and what lies on a body
/// that lands. A body whose velocity changes by c changes that of another by at most (1 + e) c mA / (mA + mB), but for
/// the one that hit it; and one that is borne along the normal stops what follows it. Only to what the change brings
/// near: bounds overlap in some directions and not in others. Ends with the pairs that all these changes bring near
/// each other.
void ContactSearch::pass_impacts_on(const SearchInput& input) {
  const std::span<const Proxy> proxies = shapes_.proxies();
  changed_.resize(input.bodies.size());
  for (std::size_t body = 0; body < changed_.size(); ++body) changed_[body] = impact_changes_[body] > 0 ? 1 : 0;
  pass_by_levers(input);
  pass_along_joints(input);
  hit_.resize(proxies.size());
  for (std::size_t i = 0; i < proxies.size(); ++i) hit_[i] = changed_[proxies[i].body];
  farther_pairs_.clear();
  constexpr int most = 16;  // bodies in a row; each round searches around those that the last one added
  int round = 0;
  for (bool farther = true; farther && round < most; ++round) {
    shapes_.grow(input.bodies, input.margin, impact_changes_);
    end_stage("farther: grow");
    input.broad_phase.find_pairs_of(proxies, hit_, near_hit_);
    end_stage("farther: find pairs");
    farther_pairs_.insert(farther_pairs_.end(), near_hit_.begin(), near_hit_.end());
    remove_apart(input, near_hit_);
    passed_on_.clear();
    for (std::size_t i = 0; i < near_hit_.size(); ++i) {
      const Pair& pair = near_hit_[i];
      const std::size_t a = proxies[pair.first].body;
      const std::size_t b = proxies[pair.second].body;
      const Real inv_mass_a = input.bodies.inverse_mass[a].m;
      const Real inv_mass_b = input.bodies.inverse_mass[b].m;
      if (inv_mass_a == 0 || inv_mass_b == 0) continue;
      const Real bounce =
          1 + mix(input.settings.restitution_mixing, shapes_.restitution(pair.first), shapes_.restitution(pair.second));
      const Real shared = bounce / (inv_mass_a + inv_mass_b);
      const Vec2 normal = normal_of(near_points_[i]);
      const Vec2 to_b = std::max(dot(normal, thrusts_[a]), Real{0}) * normal;
      const Vec2 to_a = std::min(dot(normal, thrusts_[b]), Real{0}) * normal;
      if (hit_by_[a] != b) passed_on_.push_back({b, a, shared * inv_mass_b * any_way_[a], to_b});
      if (hit_by_[b] != a) passed_on_.push_back({a, b, shared * inv_mass_a * any_way_[b], to_a});
    }
    farther = false;
    changed_.assign(input.bodies.size(), 0);
    for (const Change& one : passed_on_) {
      if (!change_velocity(input, one)) continue;
      changed_[one.body] = 1;
      farther = true;
    }
    pass_along_joints(input);
    for (std::size_t i = 0; i < proxies.size(); ++i) hit_[i] = changed_[proxies[i].body];
    end_stage("farther: pass on");
  }
  if (round == 1) return;
  std::sort(farther_pairs_.begin(), farther_pairs_.end());
  farther_pairs_.erase(std::unique(farther_pairs_.begin(), farther_pairs_.end()), farther_pairs_.end());
}

/// Removes pairs whose shapes are farther from each other than predicted changes of velocity matter.
void ContactSearch::remove_apart(const SearchInput& input, std::vector<Pair>& pairs) {
  near_points_.resize(pairs.size());
  while (numbers_.size() < pairs.size()) numbers_.push_back(static_cast<std::uint32_t>(numbers_.size()));
  narrow_phase_.collide(input.bodies, shapes_, input.margin, pairs, std::span(numbers_).first(pairs.size()),
                        near_points_.data());
  std::size_t left = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    pairs[left] = pairs[i];
    near_points_[left] = near_points_[i];
    left += near_points_[i].count > 0 && !stay_apart(input.margin, pairs[i], near_points_[i]) ? 1 : 0;
  }
  pairs.resize(left);
}

/// The second speculative query, only around bodies that are hit: with their bounds grown there are more pairs, and
/// points count from farther away.
void ContactSearch::search_farther(const SearchInput& input) {
  put_in_order(input, farther_pairs_);

  const auto end = static_cast<std::uint32_t>(pairs_.size());
  in_order_.resize(pairs_.size() + farther_pairs_.size());
  undecided_.clear();
  std::uint32_t next = 0;
  std::uint32_t placed = 0;
  std::uint32_t last = 0;
  for (const Pair& pair : farther_pairs_) {
    while (next < end && before(pairs_[next], pair)) in_order_[placed++] = next++;
    if (next < end && pairs_[next] == pair) {
      if (may_gain_points(next)) undecided_.push_back(next);
      in_order_[placed++] = next++;
    } else {
      const auto late = static_cast<std::uint32_t>(pairs_.size());
      in_order_[placed++] = late;
      undecided_.push_back(late);
      pairs_.push_back(pair);
      // Its contact comes after that of the last pair before it that has one.
      std::uint32_t known = next;
      while (known > 0 && last_of_[known - 1] == none) --known;
      if (known > 0) last = std::max(last, last_of_[known - 1] + 1);
      last_of_.push_back(find_last(order_of(pair), last));
    }
  }
  while (next < end) in_order_[placed++] = next++;
  in_order_.resize(placed);
  end_stage("farther: match");
  find_points(input, undecided_);
  for (const std::uint32_t pair : undecided_) {
    if (counts_[pair] > 0 && stay_apart(input.margin, pairs_[pair], found_[pair])) counts_[pair] = 0;
  }
  list_touching(in_order_);
  end_stage("farther: list touching");
}

/// A greater gap adds no points to persistent contacts, to boxes with two points, or to a disc with one.
bool ContactSearch::may_gain_points(std::uint32_t pair) const {
  const auto kind = [this](std::uint32_t i) { return shapes_.kind(i); };
  const Pair& of = pairs_[pair];
  if (kind(of.first) == ShapeKind::other || kind(of.second) == ShapeKind::other) return !persists(pair);
  const bool disc = kind(of.first) == ShapeKind::disc || kind(of.second) == ShapeKind::disc;
  return !persists(pair) && counts_[pair] < (disc ? 1 : 2);
}

}  // namespace impulse::inline IMPULSE_PRECISION
