#include "contacts/contact_set.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <stdexcept>
#include <tuple>

#include "contacts/ghosts.h"
#include "core/stages.h"
#include "shapes/distance.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

bool is_asleep(const Contact& c, const BodySet& bodies) {
  return bodies.asleep[c.body_a] != 0 || bodies.asleep[c.body_b] != 0;
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

/// A new contact, without points.
Contact make_contact(const Proxy& a, const Proxy& b, const Shape& shape_a, const Shape& shape_b) {
  Contact contact;
  contact.body_a = a.body;
  contact.body_b = b.body;
  contact.part_a = a.part;
  contact.part_b = b.part;
  contact.radius_a = shape_a.radius();
  contact.radius_b = shape_b.radius();
  const auto disc = [](const Shape& shape) { return shape.type() == ShapeType::circle && shape.vertex(0) == Vec2{}; };
  contact.disc_a = disc(shape_a);
  contact.disc_b = disc(shape_b);
  return contact;
}

void mix_materials(Contact& contact, const Material& a, const Material& b, const Settings& settings) {
  contact.static_friction = mix(settings.friction_mixing, a.static_friction, b.static_friction);
  contact.dynamic_friction = mix(settings.friction_mixing, a.dynamic_friction, b.dynamic_friction);
  contact.restitution = mix(settings.restitution_mixing, a.restitution, b.restitution);
}

void match_impulses(Contact& contact, std::span<const ContactPoint> last) {
  for (std::size_t p = 0; p < static_cast<std::size_t>(contact.count); ++p) {
    ContactPoint& point = contact.points[p];
    for (const ContactPoint& before : last) {
      if (point.feature != before.feature) continue;
      point.normal_impulse = before.normal_impulse;
      point.tangent_impulse = before.tangent_impulse;
    }
  }
}

/// Updates a known contact to the points that the search found now.
void update(Contact& contact, const BodySet& bodies, const PairPoints& found) {
  ++contact.age;
  const std::array<ContactPoint, 2> last = contact.points;
  const int last_count = contact.count;
  take_points(contact, bodies, found);
  match_impulses(contact, std::span(last).first(static_cast<std::size_t>(last_count)));
}

PreSolveContact shown(const Contact& contact, const BodySet& bodies) {
  PreSolveContact to;
  to.a = bodies.id(contact.body_a);
  to.b = bodies.id(contact.body_b);
  to.part_a = contact.part_a;
  to.part_b = contact.part_b;
  to.normal = contact.normal;
  to.separation = contact.points[0].separation;
  Vec2 arms;
  for (std::size_t p = 0; p < static_cast<std::size_t>(contact.count); ++p) {
    to.separation = std::min(to.separation, contact.points[p].separation);
    arms += contact.points[p].arm_a + contact.points[p].arm_b;
  }
  const Vec2 centers = bodies.pose[contact.body_a].p + bodies.pose[contact.body_b].p;
  to.point = Real{0.5} * (centers + arms / static_cast<Real>(contact.count));
  to.static_friction = contact.static_friction;
  to.dynamic_friction = contact.dynamic_friction;
  to.restitution = contact.restitution;
  return to;
}

bool in_range(const PreSolveContact& contact) {
  return is_finite(contact.static_friction) && contact.dynamic_friction >= 0 &&
         contact.dynamic_friction <= contact.static_friction && contact.restitution >= 0 && contact.restitution <= 1;
}

}  // namespace

void ContactSet::find(const SearchInput& input) {
  const bool same_rules = mixed_by_ && mixed_by_->friction == input.settings.friction_mixing &&
                          mixed_by_->restitution == input.settings.restitution_mixing;
  if (!same_rules) mix_again(input.bodies, input.settings);
  search_.search(input, rows_, !disturbed_);
  write_rows(input);
  end_stage("write rows");
  remove_ghosts(input.bodies, input.margin);
  end_stage("remove ghosts");
}

void ContactSet::write_rows(const SearchInput& input) {
  if (!disturbed_ && search_.found_the_same()) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const std::uint32_t pair = search_.touching()[i];
      if (search_.persists(pair)) continue;
      const int before = rows_[i].count;
      update(rows_[i], input.bodies, search_.points(pair));
      if (rows_[i].count != before) ++changes_;
    }
    return;
  }
  ++changes_;
  std::swap(rows_, last_rows_);
  rows_.resize(search_.touching().size());
  on_ground_.clear();
  disturbed_ = false;
  std::size_t next = 0;
  for (const std::uint32_t pair : search_.touching()) {
    const Proxy& a = search_.first(pair);
    const Proxy& b = search_.second(pair);
    if (a.moves != b.moves) {
      const Proxy& moving = a.moves ? a : b;
      on_ground_.push_back({moving.body, moving.part, a.moves, (a.moves ? b : a).body, next});
    }
    Contact& row = rows_[next++];
    if (search_.last_of(pair) != ContactSearch::none) {
      row = last_rows_[search_.last_of(pair)];
      if (!search_.persists(pair)) update(row, input.bodies, search_.points(pair));
      continue;
    }
    const Part& part_a = search_.first_part(pair);
    const Part& part_b = search_.second_part(pair);
    row = make_contact(a, b, part_a.shape, part_b.shape);
    mix_materials(row, part_a.material, part_b.material, input.settings);
    take_points(row, input.bodies, search_.points(pair));
  }
}

void ContactSet::pre_solve(const BodySet& bodies, const PreSolve& callback) {
  disabled_.clear();
  if (!callback) return;
  mixed_by_.reset();  // the next search begins with the bodies' own materials
  bool valid = true;
  for (Contact& contact : rows_) {
    PreSolveContact seen = shown(contact, bodies);
    callback(seen);
    valid &= in_range(seen);
    contact.static_friction = seen.static_friction;
    contact.dynamic_friction = seen.dynamic_friction;
    contact.restitution = seen.restitution;
    if (seen.enabled) continue;
    contact.count = 0;
    disabled_.emplace_back(contact);
  }
  ++changes_;
  if (!disabled_.empty()) {
    std::erase_if(rows_, [](const Contact& contact) { return contact.count == 0; });
    disturb();
  }
  if (!valid) {
    throw std::invalid_argument(
        "World: the pre-solve callback must set frictions of at least 0, the dynamic one at most the static one, and a "
        "restitution from 0 to 1");
  }
}

bool ContactSet::disabled(const Proxy& a, const Proxy& b) const {
  return std::binary_search(disabled_.begin(), disabled_.end(), ContactOrder(a, b));
}

void ContactSet::mix_again(const BodySet& bodies, const Settings& settings) {
  mixed_by_ = {settings.friction_mixing, settings.restitution_mixing};
  ++changes_;
  for (Contact& contact : rows_) {
    mix_materials(contact, bodies.detail[contact.body_a].parts[contact.part_a].material,
                  bodies.detail[contact.body_b].parts[contact.part_b].material, settings);
  }
}

// Only a part that touches several fixed shapes can have a ghost collision at their join.
void ContactSet::remove_ghosts(const BodySet& bodies, const Margin& margin) {
  const auto part = [](const OnGround& meets) { return std::tie(meets.body, meets.part); };
  const auto before = [&](const OnGround& left, const OnGround& right) { return part(left) < part(right); };
  // Sorted already on a single floor, and sorting allocates memory.
  if (!std::is_sorted(on_ground_.begin(), on_ground_.end(), before)) {
    std::stable_sort(on_ground_.begin(), on_ground_.end(), before);
  }
  bool removed = false;
  for (auto first = on_ground_.cbegin(), next = first; first != on_ground_.cend(); first = next) {
    next = std::find_if(first, on_ground_.cend(), [&](const OnGround& meets) { return part(meets) != part(*first); });
    const bool several = next - first > 1;
    for (auto one = first; one != next; ++one) {
      rows_[one->row].joins = several && goes_on(*one, {first, next}, bodies);
      rows_[one->row].in_corner = several && is_in_corner(*one, {first, next}, bodies);
    }
    if (several) removed |= remove_ghosts({first, next}, bodies, margin);
  }
  if (!removed) return;
  std::erase_if(rows_, [](const Contact& contact) { return contact.count == 0; });
  disturb();
}

/// Whether another of the shapes that the part meets continues this one. A plane ends nowhere.
bool ContactSet::goes_on(const OnGround& one, std::span<const OnGround> of_part, const BodySet& bodies) const {
  constexpr Real over = static_cast<Real>(0.01);  // m, gap over which a part slides as over a join
  const GroundContact here(rows_[one.row], bodies, one.dynamic_first);
  if (here.ground.type() == ShapeType::half_space) return false;
  return std::any_of(of_part.begin(), of_part.end(), [&](const OnGround& other) {
    if (other.row == one.row || !joined(bodies, one.ground, other.ground)) return false;
    const GroundContact there(rows_[other.row], bodies, other.dynamic_first);
    return !form_corner(here, there, bodies) &&
           distance(here.ground, bodies.pose[here.fixed], there.ground, bodies.pose[there.fixed]).distance <= over;
  });
}

/// Whether another of the shapes that the part meets forms a corner with this one.
bool ContactSet::is_in_corner(const OnGround& one, std::span<const OnGround> of_part, const BodySet& bodies) const {
  const GroundContact here(rows_[one.row], bodies, one.dynamic_first);
  return std::any_of(of_part.begin(), of_part.end(), [&](const OnGround& other) {
    return other.row != one.row && joined(bodies, one.ground, other.ground) &&
           form_corner(here, GroundContact(rows_[other.row], bodies, other.dynamic_first), bodies);
  });
}

// A face that replaced a ghost can in turn reveal others, at the next join but one.
bool ContactSet::remove_ghosts(std::span<const OnGround> of_part, const BodySet& bodies, const Margin& margin) {
  supports_.assign(of_part.begin(), of_part.end());
  bool removed = false;
  for (std::size_t i = 0; i < supports_.size(); ++i) {
    const OnGround below = supports_[i];
    if (rows_[below.row].count == 0) continue;
    const std::optional<Plane> plane = face_under(GroundContact(rows_[below.row], bodies, below.dynamic_first), bodies);
    if (!plane) continue;
    for (const OnGround& ahead : of_part) {
      Contact& contact = rows_[ahead.row];
      if (ahead.row == below.row || contact.count == 0 || !joined(bodies, below.ground, ahead.ground)) continue;
      const std::optional<Manifold> instead =
          without_ghost(GroundContact(contact, bodies, ahead.dynamic_first), *plane, bodies, margin);
      if (!instead) continue;
      const Contact was = contact;
      take_points(contact, bodies, points_of(*instead, bodies.pose[contact.body_a].p, bodies.pose[contact.body_b].p));
      match_impulses(contact, std::span(was.points).first(static_cast<std::size_t>(was.count)));
      supports_.push_back(ahead);
      removed |= contact.count == 0;
    }
  }
  return removed;
}

void ContactSet::forget(std::size_t body) {
  disturb();
  const auto of_it = [body](const Contact& c) { return c.body_a == body || c.body_b == body; };
  std::erase_if(rows_, of_it);
  std::erase_if(resting_, of_it);
}

void ContactSet::lay_to_rest(const BodySet& bodies) {
  disturb();
  const auto awake = [&](std::uint32_t body) { return bodies.dynamic(body) && bodies.asleep[body] == 0; };
  std::copy_if(rows_.begin(), rows_.end(), std::back_inserter(resting_),
               [&](const Contact& c) { return is_asleep(c, bodies) && !awake(c.body_a) && !awake(c.body_b); });
  std::sort(resting_.begin(), resting_.end(), comes_before);
  std::erase_if(rows_, [&](const Contact& c) { return is_asleep(c, bodies); });
}

void ContactSet::take_back(const BodySet& bodies) {
  disturb();
  const auto woken =
      std::stable_partition(resting_.begin(), resting_.end(), [&](const Contact& c) { return is_asleep(c, bodies); });
  const auto awake = static_cast<std::ptrdiff_t>(rows_.size());
  rows_.insert(rows_.end(), woken, resting_.end());
  resting_.erase(woken, resting_.end());
  mixed_by_.reset();  // they may have been mixed by other rules
  std::inplace_merge(rows_.begin(), rows_.begin() + awake, rows_.end(), comes_before);
}

void ContactSet::forget_new() {
  disturb();
  std::erase_if(rows_, [](const Contact& contact) { return contact.age == 0; });
}

void ContactSet::leave_to_piles(const BodySet& bodies) {
  disturb();
  const auto still = [&](std::uint32_t body) { return bodies.pile[body] != 0 || !bodies.pushable(body); };
  std::erase_if(rows_, [&](const Contact& contact) {
    return still(contact.body_a) && still(contact.body_b) &&
           (bodies.pile[contact.body_a] != 0 || bodies.pile[contact.body_b] != 0);
  });
}

void ContactSet::put_in(std::span<const Contact> contacts) {
  if (contacts.empty()) return;
  disturb();
  const auto before = static_cast<std::ptrdiff_t>(rows_.size());
  rows_.insert(rows_.end(), contacts.begin(), contacts.end());
  std::sort(rows_.begin() + before, rows_.end(), comes_before);
  std::inplace_merge(rows_.begin(), rows_.begin() + before, rows_.end(), comes_before);
}

void ContactSet::stretch_rest(Real times) {
  for (Contact& contact : resting_) {
    for (ContactPoint& point : contact.points) {
      point.total_normal_impulse *= times;
      point.total_tangent_impulse *= times;
    }
  }
}

void ContactSet::all(std::span<const Contact> more, std::vector<const Contact*>& merged) const {
  merged.clear();
  merged.reserve(rows_.size() + resting_.size() + more.size());
  for (const std::span<const Contact> some :
       {std::span<const Contact>(rows_), std::span<const Contact>(resting_), more}) {
    for (const Contact& contact : some) merged.push_back(&contact);
  }
  std::sort(merged.begin(), merged.end(),
            [](const Contact* left, const Contact* right) { return comes_before(*left, *right); });
}

}  // namespace impulse::inline IMPULSE_PRECISION
