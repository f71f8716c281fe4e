#include "solver/direct_island.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/impact_row.h"
#include "solver/island.h"
#include "solver/island_joints.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Of the farthest coordinate: by what the gap between two bodies and their anchors is rounded.
constexpr Real places_round_by = 4 * std::numeric_limits<Real>::epsilon();
/// Of a sub-step: intervals are not halved further.
constexpr Real shortest = Real{1} / 16;

}  // namespace

ContactEffect DirectContact::forget_press(Real share) {
  const ContactEffect back = -share * pressed_by;
  effect += back;
  pressed_by += back;
  for (std::size_t i = 0; i < pressing.size(); ++i) {
    total[i] -= share * pressing[i];
    pressing[i] = (1 - share) * pressing[i];
  }
  return back;
}

void DirectIsland::step(DirectStep& step, const Members& members) {
  step_ = &step;
  members_ = members;
  begin();
  for (int left = substeps_; left > 0;) {
    for (DirectContact& contact : contacts_) contact.approached = 0;
    approached_stops_.assign(2 * members_.joints.size(), 0);
    const int gone = glide(left);
    if (gone == 0) substep();
    left -= std::max(gone, 1);
  }
  end();
}

void DirectIsland::begin() {
  StepData& data = step_->data;
  met_jam_ = false;
  substeps_ = members_.varies ? substeps_past(data, members_.bodies) : data.settings.substeps;
  solvable_ = last_ = h_ = data.settings.dt / static_cast<Real>(substeps_);
  Vec2 least = step_->start[members_.bodies[0]].p;
  Vec2 most = least;
  Real fastest = 0;
  Real turned = 0;
  for (const std::uint32_t body : members_.bodies) {
    const Vec2 at = step_->start[body].p;
    least = {std::min(least.x, at.x), std::min(least.y, at.y)};
    most = {std::max(most.x, at.x), std::max(most.y, at.y)};
    fastest = std::max(fastest, length(step_->acceleration[body].v));
    turned = std::max(turned, std::abs(data.bodies.angle[body]));
  }
  extent_ = std::max(most.x - least.x, most.y - least.y);
  tall_ = most.y - least.y > most.x - least.x;
  gained_ = fastest * h_;
  turns_round_by_ = places_round_by * turned;
  rounding_ = places_round_by * std::max({std::abs(least.x), std::abs(least.y), std::abs(most.x), std::abs(most.y)});
  touching_ = std::max(touching_gap, rounding_);
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
    ContactEffect last;
    for (std::size_t i = 0; i < contact.count; ++i) {
      last.note(contact.frame.points[i], contact.frame.normal, contact.impulse[i]);
    }
    push(contact, last);
  }
  for (const ActiveJoint* joint : members_.joints) {
    const JointBlock& block = joint->block;
    for_each_row(block,
                 [&](const JointRow& row) { apply(block, row, row.impulse, velocity[block.a], velocity[block.b]); });
  }
  note_loads(h_);
  restore_velocities();
  refresh();
}

/// Between impacts bodies move as RATTLE moves them (H. C. Andersen, J. Comput. Phys. 52 (1983)).
///
/// `then`: what is struck at the end of the interval, if anything. s, by which it went on: less if that closes sooner
/// than it seemed to; 0, with nothing changed, if impulses for so long an interval are not found: gaps are too
/// far from linear in it, or if something changes within several sub-steps. A jam is none of that: shorter intervals
/// have no solution either.
Real DirectIsland::advance(Real h, const Impact& then) {
  for (std::uint32_t c = 0; c < contacts_.size(); ++c) let_wait(contacts_[c], c == then.contact);
  waiting_stop_ = then.stop;
  note_velocities(before_);
  by_forces_.assign(members_.bodies.size(), {});
  kick(h);
  note_velocities(kicked_);
  const bool mends = joints_are_apart();
  const bool found = press(h);
  const bool glides = h > h_;
  if (glides && !(found && stays(h) && apart_for(then, h) == 1)) {
    restore_velocities();
    return 0;
  }
  if (found && !glides && h > shortest * h_ && swings(h) * h > far_swing) {
    restore_velocities();
    return 0;
  }
  if (found && !glides && then.contact == DirectContact::no_row && then.stop == DirectContact::no_row) {
    if (const std::optional<std::uint32_t> struck = stopped_unforeseen()) {
      restore_velocities();
      ++contacts_[*struck].approached;
      return advance(h, {.time = h, .contact = *struck});
    }
  }
  const bool jammed = !found && system_.yielded() && overlaps();
  met_jam_ = met_jam_ || jammed;
  bool runs_away = false;
  if (!found) {
    restore_velocities();
    if (h > shortest * h_ && !jammed) return 0;
    const bool held = list_touched(h);
    bound_.note(touched_, held, step_->data.bodies, step_->motion);
    by_forces_.assign(members_.bodies.size(), {});
    kick(h);
    note_velocities(kicked_);
    const Real most = most_kinetic(kinetic_energy(members_.bodies, step_->data.bodies), h);
    press_as_linear(h);
    runs_away = !jammed && !is_driven() && kinetic_energy(members_.bodies, step_->data.bodies) > most;
  }
  const Real share = found && !glides && h > shortest * h_ ? apart_for(then, h) : Real{1};
  if (share < 1) {
    restore_velocities();
    return advance(share * h, then);
  }
  note_press();
  if (runs_away) take_back();
  drift(h);
  if ((jammed || mends) && !runs_away) take_back();
  refresh();
  kick(h);
  relax(h);
  if (!found && !is_driven()) {
    bound_.keep(step_->data.bodies, step_->start, step_->motion, step_->acceleration, 0);
  }
  if (8 * h < h_) return h;  // too short to tell loads from rounding
  note_loads(h);
  last_ = h;
  return h;
}

/// What was pressed in a jam displaces bodies, and is no load: it may be a thousand times what bodies bear, and would
/// shoot out what turns meanwhile. What would run away is not even to displace them.
void DirectIsland::take_back() {
  for (std::size_t i = 0; i < members_.bodies.size(); ++i) {
    step_->data.bodies.velocity[members_.bodies[i]] = kicked_[i];
  }
  for (DirectContact& contact : contacts_) contact.forget_press(1);
  std::fill(pressing_joints_.begin(), pressing_joints_.end(), Real{0});
}

/// J, after constraints that do no work in an interval: those that hold already only turn velocities, by as much as
/// mends what places are rounded by, and of bodies that overlap none is pushed faster than all in a row would be.
Real DirectIsland::most_kinetic(Real before, Real h) const {
  constexpr Real gain = static_cast<Real>(0.1);
  Real most = (1 + gain) * before;
  const Real pushed = most_push / h_;
  const Real fastest =
      overlaps() ? static_cast<Real>(members_.bodies.size()) * pushed : std::min(rounding_ / h, pushed);
  for (const std::uint32_t body : members_.bodies) {
    const InverseMass& inverse = step_->data.bodies.inverse_mass[body];
    if (inverse.m > 0) most += fastest * fastest / (2 * inverse.m);
  }
  return most;
}

/// Whether joints are so far apart that what mends them is no load either.
bool DirectIsland::joints_are_apart() const {
  constexpr Real apart = 10 * tolerated_joint_gap;
  return std::any_of(members_.joints.begin(), members_.joints.end(), [](const ActiveJoint* joint) {
    const JointBlock& block = joint->block;
    return std::any_of(block.equation.begin(), block.equation.begin() + block.equations,
                       [](const JointRow& row) { return std::abs(row.error) > apart; });
  });
}

/// The contact that meets first of those that were open and have been pressed though they close as fast as an impact,
/// which only the loads of this interval tell: pressed, it would not rebound. None of those approached in vain.
std::optional<std::uint32_t> DirectIsland::stopped_unforeseen() const {
  std::optional<std::uint32_t> first;
  double soonest = 0;  // s
  for (std::uint32_t c = 0; c < contacts_.size(); ++c) {
    const DirectContact& contact = contacts_[c];
    for (std::size_t i = 0; i < contact.count && contact.approached <= most_approaches; ++i) {
      const double gap = contact.frame.points[i].separation;
      if (!(gap > touching_) || !(system_[contact.row + i].impulse > 0)) continue;
      const double speed = -system_.speed_at_start(contact.row + i);
      if (!strikes(contact, static_cast<Real>(speed)) || (first && gap / speed >= soonest)) continue;
      soonest = gap / speed;
      first = c;
    }
  }
  return first;
}

bool DirectIsland::overlaps() const {
  return std::any_of(contacts_.begin(), contacts_.end(), [this](const DirectContact& contact) {
    for (std::size_t i = 0; i < contact.count; ++i) {
      if (contact.frame.points[i].separation < -touching_) return true;
    }
    return false;
  });
}

/// Whether constraints may do work: by motors, or bodies that move as they are told.
bool DirectIsland::is_driven() const {
  return std::any_of(members_.joints.begin(), members_.joints.end(),
                     [](const ActiveJoint* joint) { return joint->block.driven; }) ||
         std::any_of(members_.bodies.begin(), members_.bodies.end(),
                     [this](std::uint32_t body) { return !step_->data.bodies.pushable(body); });
}

/// Lists the bodies that joints hold or that something touches now or at the end of the interval: what else is there
/// flies on, whatever becomes of these. Returns whether a body that cannot be pushed is among what they touch.
bool DirectIsland::list_touched(Real h) {
  touched_.clear();
  bool held = false;
  const auto add = [&](std::uint32_t body, const InverseMass& mass) {
    if (pushable(mass)) {
      touched_.push_back(body);
    } else {
      held = true;
    }
  };
  for (const DirectContact& contact : contacts_) {
    bool near = false;
    for (std::size_t i = 0; i < contact.count && !near; ++i) {
      near = std::min(contact.frame.points[i].separation,
                      contact.touch.gap(i, motion_after(contact.a, h), motion_after(contact.b, h))) <= touching_;
    }
    if (!near) continue;
    add(contact.a, contact.mass_a);
    add(contact.b, contact.mass_b);
  }
  for (const ActiveJoint* joint : members_.joints) {
    add(joint->block.a, joint->block.inv_mass_a);
    add(joint->block.b, joint->block.inv_mass_b);
  }
  std::sort(touched_.begin(), touched_.end());
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  return held;
}

/// The share of an interval that can be gone without overlaps that nothing resolves: until what waits for its impact
/// closes, as that is predicted from the loads of the last interval, which this one may not have; half of it if other
/// features meet before its end. And what bears a disc that rolls over its corner does so on another path from there.
Real DirectIsland::apart_for(const Impact& then, Real h) const {
  constexpr Real little = static_cast<Real>(5e-5);  // m
  // Of the two faces that meet one is preferred, though what lies on the other may be so far below it (see beats()).
  constexpr Real unseen = little + static_cast<Real>(1e-4);
  Real share = 1;
  for (std::uint32_t c = 0; c < contacts_.size(); ++c) {
    const DirectContact& contact = contacts_[c];
    const Motion a = motion_after(contact.a, h);
    const Motion b = motion_after(contact.b, h);
    Real least = 0;  // m, gap at the end
    if (contact.count > 0 && (system_[contact.row].impulse > 0 || contact.impulse[0].x > 0)) {
      const Real till = contact.touch.until_corner(step_->motion[contact.a], step_->motion[contact.b], a, b);
      if (!is_brief(till * h) && !is_brief((1 - till) * h)) share = std::min(share, till);
    }
    for (std::size_t i = 0; i < contact.count; ++i) {
      const Real now = contact.frame.points[i].separation;
      const Real later = contact.touch.gap(i, a, b);
      least = std::min(least, later);
      if (c == then.contact && contact.waits[i] && now > 0 && later < -little)
        share = std::min(share, now / (now - later));
    }
    if (least < -little || !slides_far(contact, a, b)) continue;
    const Manifold found = collide_at(contact, a, b, 0);
    for (std::size_t i = 0; i < static_cast<std::size_t>(found.count); ++i) {
      if (found.points[i].separation < -unseen) share = std::min(share, Real{0.5});
    }
  }
  if (then.stop != DirectContact::no_row) {
    const ActiveJoint& joint = *members_.joints[then.stop / 2];
    const Real now = joint.block.stop[then.stop % 2].error;
    const Real later = ahead(joint, h).stop[then.stop % 2].error;
    if (now > 0 && later < -little) share = std::min(share, now / (now - later));
  }
  return share;
}

void DirectIsland::end() {
  StepData& data = step_->data;
  const Real per_step = data.settings.dt / last_;
  for (const DirectContact& contact : contacts_) {
    Contact& to = data.contacts[contact.contact];
    to.slips = contact.slips;
    to.offset = 0;
    const std::array<Vec2, 2> total = reported(contact.effect, contact.total, contact.mass_a, contact.mass_b, to);
    if (contact.found_again) to.forget_place();
    for (std::size_t i = 0; i < static_cast<std::size_t>(to.count); ++i) {
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

void DirectIsland::note_velocities(std::vector<Velocity>& to) const {
  to.clear();
  for (const std::uint32_t body : members_.bodies) to.push_back(step_->data.bodies.velocity[body]);
}

/// Whether a point of the contact that closes at this speed, m/s, is struck. What rebounds alone does so unless it
/// would be back within a sub-step even if it lost nothing; among others, where impacts at one moment have no single
/// outcome, until it is as slow as a body at rest may get in two sub-steps. What does not rebound is struck at any
/// speed: pressed instead, it would lose its speed at the sub-step's end, wherever its other points have gone by then.
bool DirectIsland::strikes(const DirectContact& contact, Real speed) const {
  const Real elastic = static_cast<Real>(members_.bodies.size() == 1 ? 0.5 : 2.4);
  constexpr Real inelastic = static_cast<Real>(0.1);
  if (speed <= no_speed) return false;
  if (contact.restitution == 0) return speed > inelastic * gained_ + no_speed;
  return speed > elastic * gained_ + no_speed || speed > elastic * gained_by(contact) + no_speed;
}

/// m/s, by which forces make a point of the contact close faster in a sub-step, and its bodies as they turn: none of
/// two that fall beside each other, less on a slope, and none where a dome falls away under a body.
Real DirectIsland::gained_by(const DirectContact& contact) const {
  if (is_borne(contact.a) || is_borne(contact.b)) return gained_;
  const TouchFrame then = contact.touch.at(flown_motion(contact.a, h_), flown_motion(contact.b, h_));
  Real most = 0;
  for (std::size_t i = 0; i < contact.count; ++i) {
    most = std::max(most, closing(contact, then, i, h_) - closing(contact, contact.frame, i, 0));
  }
  return std::min(most, gained_);
}

/// Whether contacts or joints bore the body in the last interval, so that they may push it now.
bool DirectIsland::is_borne(std::uint32_t body) const {
  if (!step_->data.bodies.pushable(body)) return false;
  const Velocity& flight = step_->flight[body];
  const Velocity& by_forces = step_->acceleration[body];
  const Real reach = step_->data.bodies.bounding_radius[body];
  return h_ * (length(flight.v - by_forces.v) + reach * std::abs(flight.w - by_forces.w)) > no_speed;
}

/// Points that are struck at the end of the interval do nothing in it, but what the contact rests on does.
void DirectIsland::let_wait(DirectContact& contact, bool struck) const {
  for (std::size_t i = 0; i < contact.count; ++i) {
    const bool apart = contact.frame.points[i].separation > touching_;
    contact.waits[i] = struck && (apart || strikes(contact, closing(contact, contact.frame, i, 0)));
  }
}

void DirectIsland::restore_velocities() {
  for (std::size_t i = 0; i < members_.bodies.size(); ++i) {
    step_->data.bodies.velocity[members_.bodies[i]] = before_[i];
  }
}

/// The accelerations from now on, from the changes of velocities that constraints caused in an interval.
void DirectIsland::note_loads(Real h) {
  if (is_brief(h)) return;
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

Motion DirectIsland::motion_after(std::uint32_t body, Real t) const {
  Motion after = step_->motion[body];
  after.advance(step_->data.bodies.velocity[body], t);
  return after;
}

JointBlock DirectIsland::ahead(const ActiveJoint& joint, Real t) const {
  return placed(joint, motion_after(joint.block.a, t), motion_after(joint.block.b, t));
}

/// A joint when its bodies have moved by a and b since the start of the step.
JointBlock DirectIsland::placed(const ActiveJoint& joint, const Motion& a, const Motion& b) const {
  JointBlock block = joint.block;
  const auto pose = [&](std::uint32_t body, const Motion& there) {
    return JointPose{there.from(step_->start[body]), step_->data.bodies.angle[body] + there.turn};
  };
  joint.model->write(pose(block.a, a), pose(block.b, b), block);
  return block;
}

}  // namespace impulse::inline IMPULSE_PRECISION
