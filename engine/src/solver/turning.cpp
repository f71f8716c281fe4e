#include "solver/turning.h"

#include <algorithm>
#include <cmath>

#include "narrow_phase/collide.h"
#include "narrow_phase/margin.h"
#include "solver/scalar_contacts.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

// m, sliding before a contact is found again; a corner that appears meanwhile penetrates by at most a fraction of this.
constexpr Real far = static_cast<Real>(0.002);

// m, gap of the mid-step re-collision, beyond what the bodies move in a sub-step; farther points are sought only where
// none is nearer.
constexpr Real near = static_cast<Real>(0.05);

// Vectors here are in the row's initial frame: x along its normal n, y along t = perpendicular(n); an arm r is
// (r . n, -(r x n)).

/// The motion of a body from `then` to `now`.
Motion moved_since(const Motion& then, const Motion& now) {
  Motion since;
  since.d = now.d - then.d;
  since.turn_by(now.turn - then.turn);
  return since;
}

Vec2 turned_arm(Real turn, Real cross, const Motion& by) { return rotation(by) * Vec2{turn, -cross}; }

/// Whether a disc touches a face that stands still: its normal and arms stay constant however it rolls.
bool stands_still(const Contact& contact, const ImpactRow& row, NormalOf normal_of) {
  return (normal_of == NormalOf::a && !row.stirs_a && contact.disc_b) ||
         (normal_of == NormalOf::b && !row.stirs_b && contact.disc_a);
}

}  // namespace

Stir stir_of(const Contact& contact, const BodySet& bodies) {
  const Velocity& a = bodies.velocity[contact.body_a];
  const Velocity& b = bodies.velocity[contact.body_b];
  Stir stir;
  stir.speed = length(b.v - a.v);
  if (!contact.disc_a) {
    stir.speed += rim_speed(bodies, contact.body_a);
    stir.turning += std::abs(a.w);
  }
  if (!contact.disc_b) {
    stir.speed += rim_speed(bodies, contact.body_b);
    stir.turning += std::abs(b.w);
  }
  return stir;
}

bool turns(const Contact& contact, const Stir& stir, const BodySet& bodies, Real dt) {
  constexpr Real felt = static_cast<Real>(6e-4);  // m/s
  if (stir.turning * stir.speed * dt > felt) return true;
  // Rounded shapes roll over corners.
  const Real round = contact.radius_a + contact.radius_b;
  return round > 0 && (stir.turning + stir.speed / round) * stir.speed * dt > felt &&
         owner(contact, bodies) == NormalOf::between;
}

void Turning::begin(const Island& island, const StepData& data) {
  turned_.clear();
  if (!island.turning) return;
  for (ImpactRow& row : island.rows) {
    const Contact& contact = data.contacts[row.contact];
    if (row.disc_distance > 0) continue;
    if (!island.struck && !turns(contact, stir_of(contact, data.bodies), data.bodies, data.settings.dt)) continue;
    const NormalOf normal_of = owner(contact, data.bodies);
    if (stands_still(contact, row, normal_of)) continue;
    row.turns = true;
    row.normal_of = normal_of;
    row.made = false;  // must be made anew in the next step
    turned_.push_back({&row,
                       normal_of,
                       row.normal,
                       contact.radius_a,
                       contact.radius_b,
                       {row.points[0], row.points[1]},
                       contact.joins});
  }
}

Turning::Pair Turning::Turned::since(const Pair& now) const {
  if (!again) return now;
  return {moved_since(found.a, now.a), moved_since(found.b, now.b)};
}

/// m, bound of the relative displacement of the bodies' points since the contact was found.
Real Turning::way(const Turned& turned, const Pair& now, const BodySet& bodies) {
  const Pair gone = turned.since(now);
  return length(gone.b.d - gone.a.d) + std::abs(gone.a.turn) * bodies.bounding_radius[turned.row->a] +
         std::abs(gone.b.turn) * bodies.bounding_radius[turned.row->b];
}

/// From the core of a to that of b, without their rounding radii.
Vec2 Turning::between(const Turned& turned, const PointArms& p, const Pair& by) {
  const Vec2 n = turned.normal;
  const Vec2 apart = by.b.d - by.a.d;
  const Vec2 at_first{turned.radius_a + turned.radius_b + p.separation, 0};
  const Vec2 moved{dot(n, apart), dot(perpendicular(n), apart)};
  return at_first + moved + (turned_arm(p.turn_b, p.cross_b, by.b) - Vec2{p.turn_b, -p.cross_b}) -
         (turned_arm(p.turn_a, p.cross_a, by.a) - Vec2{p.turn_a, -p.cross_a});
}

Vec2 Turning::direction(const Turned& turned, const Pair& by) {
  if (turned.normal_of == NormalOf::a) return {1 + by.a.drop, by.a.sine};
  if (turned.normal_of == NormalOf::b) return {1 + by.b.drop, by.b.sine};
  const Vec2 cores = between(turned, turned.points[0], by);
  // Corners that slide past each other have no well-defined direction.
  return cores.x > std::abs(cores.y) ? normalized(cores) : Vec2{1, 0};
}

void Turning::turn(const Island& island, const Turned& turned, const Pair& at, const Pair& by_then, bool from_start) {
  ImpactRow& row = *turned.row;
  const bool same = &at == &by_then;
  const Pair now = turned.since(at);
  const Pair then = same ? now : turned.since(by_then);
  const Vec2 n = direction(turned, then);
  const Vec2 t = perpendicular(n);
  const Vec2 facing = same ? n : direction(turned, now);
  row.normal = n.x * turned.normal + n.y * perpendicular(turned.normal);
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
    const PointArms& place = turned.points[i];
    RowPoint& p = row.points[i];
    Vec2 a = turned_arm(place.turn_a, place.cross_a, then.a);
    Vec2 b = turned_arm(place.turn_b, place.cross_b, then.b);
    // The contact point on the face follows the other body's point.
    const auto slid = [&] { return dot(t, between(turned, place, then)) * t; };
    if (turned.normal_of == NormalOf::a && row.stirs_a) a += slid();
    if (turned.normal_of == NormalOf::b && row.stirs_b) b -= slid();
    if (from_start) {
      a = rotation(by_then.a).inverse() * a;
      b = rotation(by_then.b).inverse() * b;
    }
    p.turn_a = dot(n, a);
    p.turn_b = dot(n, b);
    p.cross_a = -dot(t, a);
    p.cross_b = -dot(t, b);
    p.dot_a = p.turn_a + turned.radius_a;
    p.dot_b = p.turn_b - turned.radius_b;
    p.normal_mass = effective_mass(row, p.cross_a, p.cross_b);
    p.tangent_mass = effective_mass(row, p.dot_a, p.dot_b);
    const Real s = dot(facing, between(turned, place, now)) - (turned.radius_a + turned.radius_b);
    p.separation += s - separation(row, p, at.a, at.b);
  }
  if (row.block) row.pair = ScalarContacts::pair_of(island, row);
}

// Where a body meets several shapes of the ground, their contacts keep their points: only the search removes ghost
// collisions at joins.
bool Turning::is_far(const Turned& turned, const Pair& now, const BodySet& bodies) {
  return !turned.may_join && way(turned, now, bodies) >= far;
}

void Turning::find_again(StepData& data, const std::vector<Pose>& start, const std::vector<Motion>& motion) {
  for (Turned& turned : turned_) {
    const Pair now{motion[turned.row->a], motion[turned.row->b]};
    if (is_far(turned, now, data.bodies)) find(data, turned, now, start);
  }
}

bool Turning::find_at(StepData& data, const Island& island, const std::vector<Pose>& start,
                      const std::vector<Motion>& motion, const ImpactRow& row, const Pair& then) {
  if (!row.turns) return false;
  const auto turned = std::lower_bound(turned_.begin(), turned_.end(), &row,
                                       [](const Turned& one, const ImpactRow* other) { return one.row < other; });
  if (turned == turned_.end() || turned->row != &row || !is_far(*turned, then, data.bodies)) return false;
  find(data, *turned, then, start);
  const Pair now{motion[row.a], motion[row.b]};
  turn(island, *turned, now, now, true);
  return true;
}

void Turning::find(StepData& data, Turned& turned, const Pair& now, const std::vector<Pose>& start) {
  const ImpactRow& row = *turned.row;
  Contact& contact = data.contacts[row.contact];
  const Pose pose_a = now.a.from(start[row.a]);
  const Pose pose_b = now.b.from(start[row.b]);
  const Shape& shape_a = data.bodies.detail[row.a].parts[contact.part_a].shape;
  const Shape& shape_b = data.bodies.detail[row.b].parts[contact.part_b].shape;
  const auto found_within = [&](Real t) {
    return collide(shape_a, pose_a, shape_b, pose_b, speculative_gap(data.bodies, row.a, row.b, {near, t}));
  };
  Manifold m = found_within(data.settings.dt / static_cast<Real>(data.settings.substeps));
  if (m.count == 0) m = found_within(data.settings.dt);
  if (m.count == 0) return lose_points(*turned.row);
  contact.found_a = pose_a;
  contact.found_b = pose_b;
  take_points(turned, contact, m);
  turned.normal_of = turned.row->normal_of = owner(contact, data.bodies);
  turned.again = true;
  turned.found = now;
}

/// The plane of a face that turns sweeps over bodies far away.
void Turning::lose_points(ImpactRow& row) {
  row.count = 0;
  row.block = false;
  for (RowPoint& p : row.points) p.normal_impulse = p.tangent_impulse = 0;
}

/// New points inherit the impulses of the points with the same feature, and their totals of the step; those of a point
/// that vanished go to another.
void Turning::take_points(Turned& turned, Contact& contact, const Manifold& found) {
  ImpactRow& row = *turned.row;
  const auto last_count = static_cast<std::size_t>(contact.count);  // before it lost them, too
  const std::array<ContactPoint, 2> last = contact.points;
  const std::array<RowPoint, 2> given = row.points;
  row.points = {};
  counts_changed_ = counts_changed_ || found.count != contact.count;
  if (found.count != row.count) {
    contact.count = row.count = found.count;
    row.block = !row.web && row.count == 2;
  }
  contact.normal = turned.normal = found.normal;
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
    ContactPoint& p = contact.points[i];
    p = {};
    p.arm_a = found.points[i].point - contact.found_a.p;
    p.arm_b = found.points[i].point - contact.found_b.p;
    p.separation = contact.found_separation[i] = found.points[i].separation;
    p.feature = found.points[i].feature;
    turned.points[i] = arms_of(contact, i);
  }
  for (std::size_t j = 0; j < last_count; ++j) {
    std::size_t i = 0;
    while (i < static_cast<std::size_t>(row.count) && contact.points[i].feature != last[j].feature) ++i;
    if (i < static_cast<std::size_t>(row.count)) {
      row.points[i].normal_impulse = given[j].normal_impulse;
      row.points[i].tangent_impulse = given[j].tangent_impulse;
    } else {
      i = 0;
    }
    row.points[i].total_normal += given[j].total_normal;
    row.points[i].total_tangent += given[j].total_tangent;
  }
}

void Turning::follow(const Island& island, const std::vector<Motion>& motion) {
  for (const Turned& turned : turned_) {
    const Pair now{motion[turned.row->a], motion[turned.row->b]};
    turn(island, turned, now, now, true);
  }
}

void Turning::lead(const Island& island, const BodySet& bodies, const std::vector<Motion>& motion) {
  const Real half = island.h / 2;
  ahead_.begin(island.rows, bodies.size());
  const auto then = [&](std::uint32_t body) {
    if (ahead_.knows(body, half)) return ahead_.of(body);
    Motion advanced = motion[body];
    advanced.advance(bodies.velocity[body], half);
    ahead_.keep(body, half, advanced);
    return advanced;
  };
  for (const Turned& turned : turned_) {
    const ImpactRow& row = *turned.row;
    turn(island, turned, {motion[row.a], motion[row.b]}, {then(row.a), then(row.b)}, false);
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
