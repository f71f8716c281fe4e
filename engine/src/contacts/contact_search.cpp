#include "contacts/contact_search.h"

#include <algorithm>

#include "core/stages.h"
#include "impulse/material.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// m, of both bodies' motion together since the points were found; and the points count as touching (m) up to here.
constexpr Real recycled_motion = static_cast<Real>(0.01);
constexpr Real recycled_gap = static_cast<Real>(0.005);

bool may_keep(const Contact& contact) {
  const bool first = contact.points[0].separation > recycled_gap;
  const bool second = (contact.count > 1) & (contact.points[1].separation > recycled_gap);
  return !(contact.discs() | first | second);
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
  struck_piles_.clear();
  // Once: what a third body is handed on within the same step is little.
  const bool knocked = input.margin.time > 0 && foresee_knocks(input);
  end_stage("foresee knocks");
  if (knocked) reach_farther(input);
  std::sort(struck_piles_.begin(), struck_piles_.end());
  struck_piles_.erase(std::unique(struck_piles_.begin(), struck_piles_.end()), struck_piles_.end());
  found_the_same_ = touching_are_last();
}

/// Leaves out pairs that are none, and puts the others in order of contacts.
void ContactSearch::put_in_order(const SearchInput& input, std::vector<Pair>& pairs) {
  const std::span<const Proxy> proxies = shapes_.proxies();
  const JointSet& joints = input.joints;
  const bool tied = !joints.connected_pairs().empty();
  if (tied || shapes_.some_slanted()) {
    std::size_t left = 0;
    for (const Pair& pair : pairs) {
      const bool apart = shapes_.apart(pair.first, pair.second) ||
                         (tied && joints.connects(proxies[pair.first].body, proxies[pair.second].body));
      pairs[left] = pair;
      left += apart ? 0 : 1;
    }
    pairs.resize(left);
  }
  if (!shapes_.several_parts()) return;
  // They come in order of (body_a, part_a, body_b, part_b): wrong only around what is not of its body's first part.
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

/// Pairs and contacts are in one order: one walk along both. While the proxies are the same and no contact was taken
/// out or put in, the pairs that touched tell of the contacts, in less memory. Where pairs and contacts are still those
/// of the last search, which is which is known; and nothing changes if that search found the contacts of the one
/// before.
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

/// Goes on in `last_` from a place to where the contact must be, and past it if it is there.
std::uint32_t ContactSearch::find_last(const ContactOrder& wanted, std::uint32_t& place) const {
  while (place < last_.size() && ContactOrder(last_[place]) < wanted) ++place;
  const bool known = place < last_.size() && ContactOrder(last_[place]) == wanted;
  return known ? place++ : none;
}

/// Those that they had, or new ones.
void ContactSearch::find_points(const SearchInput& input, std::span<const std::uint32_t> of_pairs) {
  counts_.resize(pairs_.size());
  found_.resize(pairs_.size());
  keep_points(input, of_pairs);
  end_stage("recycle");
  narrow_phase_.collide(input.bodies, shapes_, input.margin, pairs_, to_collide_, found_.data());
  for (const std::uint32_t pair : to_collide_) counts_[pair] = static_cast<std::int8_t>(found_[pair].count);
  end_stage("collide pairs");
}

/// Of some pairs, those whose bodies hardly moved since their points were found (see ContactSet::find).
void ContactSearch::keep_points(const SearchInput& input, std::span<const std::uint32_t> of_pairs) {
  // Both lists are written at every turn, and go on where the pair belongs: which that is, no processor foresees.
  to_collide_.resize(of_pairs.size());
  to_keep_.resize(of_pairs.size());
  may_keep_.resize(of_pairs.size());
  std::size_t collided = 0;
  std::size_t asked = 0;
  for (const std::uint32_t pair : of_pairs) {
    const std::uint32_t last = last_of_[pair];
    const bool still = moved_[pairs_[pair].first] + moved_[pairs_[pair].second] < recycled_motion;
    // Points that the last search found, what has moved since cannot keep: that spares a visit.
    const std::size_t ask =
        input.recycle && last != none && (still || fresh_[last] == 0) && may_keep(last_[last]) ? 1 : 0;
    to_collide_[collided] = pair;
    to_keep_[asked] = pair;
    may_keep_[asked] = last;
    collided += 1 - ask;
    asked += ask;
  }
  may_keep_.resize(asked);
  kept_.resize(asked);
  kernels().keep_points(last_.data(), may_keep_.data(), static_cast<std::uint32_t>(asked), input.bodies.pose.data(),
                        input.bodies.bounding_radius.data(), recycled_motion, kept_.data());
  for (std::size_t i = 0; i < asked; ++i) {
    const std::uint32_t pair = to_keep_[i];
    counts_[pair] = kept;
    to_collide_[collided] = pair;
    collided += kept_[i] != 0 ? 0 : 1;
  }
  to_collide_.resize(collided);
}

/// How far each proxy's body has come since the last search, and which points that search found: where there are so
/// many that it pays; else as if nothing had moved.
void ContactSearch::note_motion(const SearchInput& input, bool undisturbed) {
  constexpr std::size_t worth_it = 64;
  const BodySet& bodies = input.bodies;
  const std::span<const Proxy> proxies = shapes_.proxies();
  fresh_.assign(last_.size(), 0);
  moved_.assign(proxies.size(), 0);
  if (last_.size() < worth_it) return poses_.clear();
  const bool known = poses_.size() == bodies.size();
  if (!known) poses_ = bodies.pose;
  for (std::size_t i = 0; i < fresh_.size(); ++i) fresh_[i] = undisturbed && known && !keeps(touching_[i]) ? 1 : 0;
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

/// Two bodies that meet at a speed u change each other's by (1 + e) u mB / (mA + mB) at most. What is struck within the
/// step may then meet others than those it was on its way to: a disc thrown back into its followers, the next in a
/// stack that lands. Whether that takes any farther than the margin already allows for.
bool ContactSearch::foresee_knocks(const SearchInput& input) {
  const BodySet& bodies = input.bodies;
  const Margin& margin = input.margin;
  const Real felt = margin.distance / 2;
  // As fast as all that would be too slow: 1/64 is for rounding.
  const auto too_slow = [&](Real speed) { return margin.time * speed <= felt * (Real{63} / 64); };
  if (too_slow(2 * shapes_.fastest())) return false;
  knocks_.assign(bodies.size(), 0);
  bool farther = false;
  const auto knock = [&](std::size_t i, Real change) {
    if (margin.time * change <= felt) return;
    knocks_[i] = std::max(knocks_[i], change);
    farther = true;
    if (bodies.pile[i] != 0) struck_piles_.push_back(bodies.pile[i]);
  };
  const auto count = static_cast<std::uint32_t>(touching_.size());
  const PairBatch all{shapes_.records().data(), pairs_.data(), touching_.data(), count, felt, margin.time};
  fast_.resize(count);
  const std::uint32_t* end = kernels().find_fast(all, found_.data(), counts_.data(), fast_.data());
  for (const std::uint32_t pair : std::span(fast_.data(), end)) {
    const PairPoints& found = found_[pair];
    const ShapeRecord& record_a = shapes_.records()[pairs_[pair].first];
    const ShapeRecord& record_b = shapes_.records()[pairs_[pair].second];
    const Vec2 between = record_b.velocity - record_a.velocity;
    const Real turning = record_a.rim + record_b.rim;
    Vec2 normal{found.normal[0], found.normal[1]};
    Real gap = found.count == 2 ? std::min(found.separation[0], found.separation[1]) : found.separation[0];
    if (keeps(pair)) {
      const Contact& contact = last_[last_of_[pair]];
      normal = contact.normal;
      gap = contact.points[0].separation;
      if (contact.count == 2) gap = std::min(gap, contact.points[1].separation);
    }
    const Real speed = turning - dot(normal, between);
    if (margin.time * speed <= std::max(gap, felt)) continue;
    const std::size_t a = first(pair).body;
    const std::size_t b = second(pair).body;
    const Real mass_a = bodies.inverse_mass[a].m;
    const Real mass_b = bodies.inverse_mass[b].m;
    const Real restitution = mix(input.settings.restitution_mixing, shapes_.restitution(pairs_[pair].first),
                                 shapes_.restitution(pairs_[pair].second));
    const Real change = (1 + restitution) * speed / (mass_a + mass_b);
    knock(a, change * mass_a);
    knock(b, change * mass_b);
  }
  return farther;
}

/// Searches once more, but only around what is knocked: bounds have grown there, so that pairs are added, and points
/// count from farther away.
void ContactSearch::reach_farther(const SearchInput& input) {
  shapes_.grow(input.bodies, input.margin, knocks_);
  const std::span<const Proxy> proxies = shapes_.proxies();
  knocked_.resize(proxies.size());
  for (std::size_t i = 0; i < proxies.size(); ++i) knocked_[i] = knocks_[proxies[i].body] > 0 ? 1 : 0;
  end_stage("farther: grow");
  input.broad_phase.find_pairs_of(proxies, knocked_, farther_pairs_);
  end_stage("farther: find pairs");
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
      // Its contact comes after that of the nearest pair before it that has one.
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
  list_touching(in_order_);
  end_stage("farther: list touching");
}

/// A greater gap gives no more points to pairs that stay as they were, to a full set, or to a disc that has its one.
bool ContactSearch::may_gain_points(std::uint32_t pair) const {
  const auto kind = [this](std::uint32_t i) { return shapes_.kind(i); };
  const Pair& of = pairs_[pair];
  if (kind(of.first) == ShapeKind::other || kind(of.second) == ShapeKind::other) return !keeps(pair);
  const bool disc = kind(of.first) == ShapeKind::disc || kind(of.second) == ShapeKind::disc;
  return !keeps(pair) && counts_[pair] < (disc ? 1 : 2);
}

}  // namespace impulse::inline IMPULSE_PRECISION
