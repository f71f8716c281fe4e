#include "solver/direct_island.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "narrow_phase/collide.h"
#include "narrow_phase/margin.h"
#include "solver/impact_row.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr Real slid_far = static_cast<Real>(0.002);      // m, that bodies slide before their contact is found again
constexpr Real sought_within = static_cast<Real>(0.05);  // m, gap up to which points are sought
/// Of a sub-step: intervals are not halved further.
constexpr Real shortest = Real{1} / 16;

/// The next search finds the points of the contact again, however little its bodies have moved.
void forget_place(Contact& contact) {
  contact.found_a.p = contact.found_b.p = Vec2{1, 1} * std::numeric_limits<Real>::infinity();
}

}  // namespace

void DirectIsland::step(DirectStep& step, const Members& members) {
  step_ = &step;
  members_ = members;
  begin();
  for (int i = 0; i < substeps_; ++i) substep();
  end();
}

void DirectIsland::begin() {
  StepData& data = step_->data;
  substeps_ = data.settings.substeps;
  solvable_ = last_ = h_ = data.settings.dt / static_cast<Real>(substeps_);
  Vec2 least = step_->start[members_.bodies[0]].p;
  Vec2 most = least;
  Real fastest = 0;
  for (const std::uint32_t body : members_.bodies) {
    const Vec2 at = step_->start[body].p;
    least = {std::min(least.x, at.x), std::min(least.y, at.y)};
    most = {std::max(most.x, at.x), std::max(most.y, at.y)};
    fastest = std::max(fastest, length(step_->acceleration[body].v));
  }
  tall_ = most.y - least.y > most.x - least.x;
  gained_ = fastest * h_;
  begin_contacts();
  const Real share = 1 / static_cast<Real>(substeps_);
  for (ActiveJoint* joint : members_.joints) {
    for_each_row(joint->block, [&](JointRow& row) {
      row.impulse *= share;
      row.half *= share;
    });
  }
  // What bore the bodies in the last step.
  std::vector<Velocity>& velocity = data.bodies.velocity;
  note_velocities(before_);
  by_forces_.assign(members_.bodies.size(), {});
  for (const DirectContact& contact : contacts_) {
    for (std::size_t i = 0; i < contact.count; ++i) push(contact, contact.frame, i, contact.impulse[i]);
  }
  for (const ActiveJoint* joint : members_.joints) {
    const JointBlock& block = joint->block;
    for_each_row(block,
                 [&](const JointRow& row) { apply(block, row, row.impulse, velocity[block.a], velocity[block.b]); });
  }
  note_loads(h_);
  restore_velocities();
}

void DirectIsland::begin_contacts() {
  StepData& data = step_->data;
  contacts_.clear();
  for (const Tie& tie : members_.contacts) {
    const Contact& from = data.contacts[tie.contact];
    DirectContact contact;
    contact.contact = tie.contact;
    contact.a = from.body_a;
    contact.b = from.body_b;
    contact.mass_a = data.bodies.inverse_mass[contact.a];
    contact.mass_b = data.bodies.inverse_mass[contact.b];
    contact.count = static_cast<std::size_t>(from.count);
    contact.static_friction = from.static_friction;
    contact.dynamic_friction = from.dynamic_friction;
    contact.restitution = from.restitution;
    contact.slips = from.slips;
    contact.joins = from.joins;
    contact.touch = Touch(from, data.bodies, step_->start[contact.a], step_->start[contact.b]);
    contact.frame = contact.touch.at(step_->motion[contact.a], step_->motion[contact.b]);
    for (std::size_t i = 0; i < contact.count; ++i) {
      const ContactPoint& p = from.points[i];
      contact.impulse[i] = Vec2{p.normal_impulse, p.tangent_impulse} / static_cast<Real>(substeps_);
      contact.pressed[i] = contact.impulse[i] / Real{2};
    }
    contacts_.push_back(contact);
  }
}

/// Between impacts bodies move as RATTLE moves them (H. C. Andersen, J. Comput. Phys. 52 (1983)).
///
/// `then`: the contact that is struck at the end of the interval. False, with nothing changed, if impulses
/// for so long an interval are not found: gaps are too far from linear in it.
bool DirectIsland::advance(Real h, std::uint32_t then) {
  refresh();
  for (std::uint32_t c = 0; c < contacts_.size(); ++c) let_wait(contacts_[c], c == then);
  note_velocities(before_);
  by_forces_.assign(members_.bodies.size(), {});
  kick(h);
  const bool found = press(h);
  if (!found) {
    restore_velocities();
    if (h > shortest * h_) return false;
    bound_.note(members_.bodies, is_held(), step_->data.bodies, step_->motion);
    by_forces_.assign(members_.bodies.size(), {});
    kick(h);
    press_as_linear(h);
  }
  note_press();
  drift(h);
  refresh();
  kick(h);
  relax(h);
  if (!found && !is_driven()) {
    bound_.keep(step_->data.bodies, step_->start, step_->motion, step_->acceleration, 0);
  }
  if (8 * h < h_) return true;  // too short to tell loads from rounding
  note_loads(h);
  last_ = h;
  return true;
}

void DirectIsland::end() {
  StepData& data = step_->data;
  const Real per_step = data.settings.dt / last_;
  for (const DirectContact& contact : contacts_) {
    Contact& to = data.contacts[contact.contact];
    to.slips = contact.slips;
    to.offset = 0;
    const std::array<Vec2, 2> total = reported(contact, to);
    if (contact.found_again) forget_place(to);
    for (std::size_t i = 0; i < contact.count; ++i) {
      ContactPoint& p = to.points[i];
      p.normal_impulse = per_step * contact.impulse[i].x;
      p.tangent_impulse = per_step * contact.impulse[i].y;
      p.total_normal_impulse = total[i].x;
      p.total_tangent_impulse = total[i].y;
    }
  }
  for (ActiveJoint* joint : members_.joints) {
    for_each_row(joint->block, [&](JointRow& row) {
      row.impulse *= per_step;
      row.half *= per_step;
    });
  }
}

/// N s, of each point along the normal and tangent of the step's end, that act on the bodies as all impulses of the
/// step did: if the normal turned meanwhile, they get the mean one, and points where they turn the bodies as much. None
/// if all that is left of opposite ones is rounding, which has no direction.
std::array<Vec2, 2> DirectIsland::reported(const DirectContact& contact, Contact& to) {
  std::array<Vec2, 2> total = contact.total;
  const Vec2 sum = total[0] + total[1];
  const Real effect = length(contact.acted);
  const Real all = length(sum);
  constexpr Real rounding = 64 * std::numeric_limits<Real>::epsilon();
  if (effect <= rounding * contact.given) return {};
  const Real share = effect / static_cast<Real>(contact.count);
  for (std::size_t i = 0; i < contact.count; ++i) {
    total[i] = all > 0 ? (effect / all) * total[i] : Vec2{share, 0};
  }
  const Vec2 along = all > 0 ? sum : Vec2{1, 0};
  const Vec2 normal = normalized(Rotation(along.x, along.y).inverse() * contact.acted);
  if (length(normal - to.normal) <= rounding) return total;
  to.normal = normal;
  forget_place(to);
  const Real pushes = total[0].x + total[1].x;
  if (!(pushes > 0)) return total;
  Real turned_a = 0;
  Real turned_b = 0;
  for (std::size_t i = 0; i < contact.count; ++i) {
    const Vec2 world = total[i].x * normal + total[i].y * perpendicular(normal);
    turned_a += cross(to.points[i].arm_a, world);
    turned_b += cross(to.points[i].arm_b, world);
  }
  for (std::size_t i = 0; i < contact.count; ++i) {
    to.points[i].arm_a += (turned_a - contact.turned_a) / pushes * perpendicular(normal);
    to.points[i].arm_b += (turned_b - contact.turned_b) / pushes * perpendicular(normal);
  }
  return total;
}

void DirectIsland::note_velocities(std::vector<Velocity>& to) const {
  to.clear();
  for (const std::uint32_t body : members_.bodies) to.push_back(step_->data.bodies.velocity[body]);
}

/// What rebounds does so until it is as slow as a body at rest may get in two sub-steps. What does not is struck at any
/// speed: pressed instead, it would lose its speed at the sub-step's end, wherever its other points have gone by then.
Real DirectIsland::slow(const DirectContact& contact) const {
  constexpr Real elastic = static_cast<Real>(2.4);
  constexpr Real inelastic = static_cast<Real>(0.1);
  return (contact.restitution > 0 ? elastic : inelastic) * gained_ + no_speed;
}

/// Points that are struck at the end of the interval do nothing in it, but what the contact rests on does.
void DirectIsland::let_wait(DirectContact& contact, bool struck) const {
  for (std::size_t i = 0; i < contact.count; ++i) {
    const bool apart = contact.frame.points[i].separation > touching_gap;
    contact.waits[i] = struck && (apart || closing(contact, contact.frame, i, 0) > slow(contact));
  }
}

void DirectIsland::restore_velocities() {
  for (std::size_t i = 0; i < members_.bodies.size(); ++i) {
    step_->data.bodies.velocity[members_.bodies[i]] = before_[i];
  }
}

/// The accelerations from now on, from the changes of velocities that constraints caused in an interval.
void DirectIsland::note_loads(Real h) {
  for (std::size_t i = 0; i < members_.bodies.size(); ++i) {
    const std::uint32_t body = members_.bodies[i];
    const Velocity& now = step_->data.bodies.velocity[body];
    Velocity& flight = step_->flight[body];
    flight = step_->acceleration[body];
    if (!step_->data.bodies.pushable(body)) continue;
    flight.v += (now.v - before_[i].v - by_forces_[i].v) / h;
    flight.w += (now.w - before_[i].w - by_forces_[i].w) / h;
  }
}

void DirectIsland::refresh() {
  for (DirectContact& contact : contacts_) {
    find(contact);
    contact.frame = contact.touch.at(step_->motion[contact.a], step_->motion[contact.b]);
  }
  for (ActiveJoint* joint : members_.joints) joint->block = ahead(*joint, 0);
}

/// Finds a contact again if its bodies have slid past each other since the last time, because other corners may be
/// near. Where a body meets several shapes of the ground, only the search removes ghost collisions at joins.
bool DirectIsland::find(DirectContact& contact) {
  StepData& data = step_->data;
  const BodySet& bodies = data.bodies;
  const Motion& a = step_->motion[contact.a];
  const Motion& b = step_->motion[contact.b];
  if (contact.joins ||
      contact.touch.moved(a, b, bodies.bounding_radius[contact.a], bodies.bounding_radius[contact.b]) < slid_far) {
    return false;
  }
  Contact& found = data.contacts[contact.contact];
  const Pose pose_a = a.from(step_->start[contact.a]);
  const Pose pose_b = b.from(step_->start[contact.b]);
  const Shape& shape_a = bodies.detail[contact.a].parts[found.part_a].shape;
  const Shape& shape_b = bodies.detail[contact.b].parts[found.part_b].shape;
  const auto found_within = [&](Real t) {
    return collide(shape_a, pose_a, shape_b, pose_b, speculative_gap(bodies, contact.a, contact.b, {sought_within, t}));
  };
  Manifold m = found_within(h_);
  if (m.count == 0) m = found_within(data.settings.dt);
  if (m.count == 0) return false;
  const std::array<ContactPoint, 2> last = found.points;
  const DirectContact before = contact;
  contact.impulse = contact.pressed = contact.pressing = contact.total = {};
  contact.waits = {};
  contact.count = static_cast<std::size_t>(m.count);
  counts_changed_ = counts_changed_ || found.count != m.count;
  found.count = m.count;
  found.normal = m.normal;
  found.found_a = pose_a;
  found.found_b = pose_b;
  for (std::size_t i = 0; i < contact.count; ++i) {
    ContactPoint& p = found.points[i];
    p = {};
    p.arm_a = m.points[i].point - pose_a.p;
    p.arm_b = m.points[i].point - pose_b.p;
    p.separation = found.found_separation[i] = m.points[i].separation;
    p.feature = m.points[i].feature;
  }
  // To the point that is nearest now: which faces meet, and so the names of points, may be a matter of rounding.
  for (std::size_t j = 0; j < before.count; ++j) {
    const auto away = [&](std::size_t i) { return length(found.points[i].arm_a - last[j].arm_a); };
    const std::size_t i = contact.count == 2 && away(1) < away(0) ? 1 : 0;
    contact.impulse[i] += before.impulse[j];
    contact.pressed[i] += before.pressed[j];
    contact.pressing[i] += before.pressing[j];
    contact.total[i] += before.total[j];
    contact.waits[i] = contact.waits[i] || before.waits[j];
  }
  contact.touch = Touch(found, bodies, a, b);
  contact.found_again = true;
  return true;
}

Motion DirectIsland::motion_after(std::uint32_t body, Real t) const {
  Motion after = step_->motion[body];
  after.advance(step_->data.bodies.velocity[body], t);
  return after;
}

JointBlock DirectIsland::ahead(const ActiveJoint& joint, Real t) const {
  JointBlock block = joint.block;
  const auto pose = [&](std::uint32_t body) {
    const Motion there = motion_after(body, t);
    return JointPose{there.from(step_->start[body]), step_->data.bodies.angle[body] + there.turn};
  };
  joint.model->write(pose(block.a), pose(block.b), block);
  return block;
}

}  // namespace impulse::inline IMPULSE_PRECISION
