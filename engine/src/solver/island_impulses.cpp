#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/direct_island.h"
#include "solver/impact_row.h"

/// The impulses of a small island's contacts and joints before and after the drift.
namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// m, by which gaps and joints may be off after the drift.
constexpr Real exact = static_cast<Real>(sizeof(Real) == 8 ? 1e-12 : 1e-6);

/// m, by which a point of body b slides along the tangent past body a while they move by these.
Real slip(const TouchFrame& frame, const PointArms& p, const Motion& a, const Motion& b) {
  const Real centres = dot(perpendicular(frame.normal), b.d - a.d);
  const Real core_b = b.sine * p.turn_b - b.drop * p.cross_b;
  const Real core_a = a.sine * p.turn_a - a.drop * p.cross_a;
  return centres + (core_b + b.turn * (p.dot_b - p.turn_b)) - (core_a + a.turn * (p.dot_a - p.turn_a));
}

}  // namespace

void DirectIsland::kick(Real h) {
  for (std::size_t i = 0; i < members_.bodies.size(); ++i) {
    const std::uint32_t body = members_.bodies[i];
    const Velocity& by = step_->acceleration[body];
    for (Velocity* velocity : {&step_->data.bodies.velocity[body], &by_forces_[i]}) {
      velocity->v += h / 2 * by.v;
      velocity->w += h / 2 * by.w;
    }
  }
}

/// m, along the longer side of the island: between bodies that are pushed.
Real DirectIsland::place_of(std::uint32_t a, std::uint32_t b) const {
  const BodySet& bodies = step_->data.bodies;
  const auto at = [&](std::uint32_t body) { return tall_ ? step_->start[body].p.y : step_->start[body].p.x; };
  if (!bodies.pushable(a)) return at(b);
  return bodies.pushable(b) ? (at(a) + at(b)) / 2 : at(a);
}

void DirectIsland::list_contact(DirectContact& contact) {
  Constraint row;
  row.a = contact.a;
  row.b = contact.b;
  row.place = place_of(contact.a, contact.b);
  row.mass_a = contact.mass_a;
  row.mass_b = contact.mass_b;
  row.axis = contact.frame.normal;
  row.law = Law::pushes;
  contact.row = static_cast<std::uint32_t>(system_.all().size());
  for (std::size_t i = 0; i < contact.count; ++i) {
    row.arm_a = contact.frame.points[i].cross_a;
    row.arm_b = contact.frame.points[i].cross_b;
    system_.add(row);
  }
  contact.friction_row = DirectContact::no_row;
  if (contact.count == 0 || !(contact.friction() > 0)) return;
  row.axis = perpendicular(contact.frame.normal);
  row.law = Law::rubs;
  row.first = contact.row;
  row.count = static_cast<std::uint32_t>(contact.count);
  row.friction = contact.friction();
  for (std::size_t i = 0; i < contact.count; ++i) {
    row.point_a[i] = contact.frame.points[i].dot_a;
    row.point_b[i] = contact.frame.points[i].dot_b;
  }
  contact.friction_row = system_.add(row);
}

void DirectIsland::list_joint(const JointBlock& block) {
  joint_rows_.push_back(static_cast<std::uint32_t>(system_.all().size()));
  const auto add = [&](const JointRow& from, Law law) {
    Constraint row;
    row.a = block.a;
    row.b = block.b;
    row.place = place_of(block.a, block.b);
    row.mass_a = block.inv_mass_a;
    row.mass_b = block.inv_mass_b;
    row.axis = from.axis;
    row.arm_a = from.arm_a;
    row.arm_b = from.arm_b;
    row.law = law;
    system_.add(row);
  };
  for (int i = 0; i < block.equations; ++i) add(block.equation[static_cast<std::size_t>(i)], Law::holds);
  for (int i = 0; i < block.stops; ++i) add(block.stop[static_cast<std::size_t>(i)], Law::pushes);
  if (block.driven) add(block.motor, Law::drives);
}

/// Sets the biases so that gaps, slips and the errors of joints after a drift at the present velocities vanish if they
/// are linear.
void DirectIsland::bias_press(Real h) {
  const std::vector<Velocity>& velocity = step_->data.bodies.velocity;
  const auto set = [&](std::uint32_t at, Real miss) {
    system_[at].bias = miss / h - ConstraintSystem::speed(system_[at], velocity);
  };
  // What differs from how a gap or error changes now by no more than places are rounded by, goes on as it does now.
  const auto after = [&](std::uint32_t at, Real now, Real then, Real rounding) {
    const auto straight = static_cast<Real>(now + h * ConstraintSystem::speed(system_[at], velocity));
    return std::abs(then - straight) <= rounding ? straight : then;
  };
  // In a short interval the rounding of a gap is a great speed, which relax() takes back, but not with its friction.
  const Real rounding_of_gaps = is_brief(h) ? rounding_ : 0;
  for (const DirectContact& contact : contacts_) {
    const Motion a = motion_after(contact.a, h);
    const Motion b = motion_after(contact.b, h);
    const bool rubs = contact.friction_row != DirectContact::no_row;
    Motion by_a, by_b;
    if (rubs) {
      by_a.advance(velocity[contact.a], h);
      by_b.advance(velocity[contact.b], h);
    }
    for (std::size_t i = 0; i < contact.count; ++i) {
      const PointArms& p = contact.frame.points[i];
      const std::uint32_t at = contact.row + static_cast<std::uint32_t>(i);
      const Real miss =
          after(at, p.separation, contact.touch.gap(i, a, b), rounding_of_gaps) - least_gap(p.separation, h);
      // What comes to touch at the end by rounding is not stopped.
      set(at, system_[at].impulse == 0 && miss > -exact ? std::max(miss, Real{0}) : miss);
      if (!rubs) continue;
      Constraint& row = system_[contact.friction_row];
      const Real speed = dot(row.axis, velocity[contact.b].v - velocity[contact.a].v) +
                         velocity[contact.b].w * row.point_b[i] - velocity[contact.a].w * row.point_a[i];
      row.point_bias[i] = slip(contact.frame, p, by_a, by_b) / h - speed;
    }
  }
  for (std::size_t j = 0; j < members_.joints.size(); ++j) {
    const JointBlock& now = members_.joints[j]->block;
    const JointBlock there = ahead(*members_.joints[j], h);
    std::uint32_t at = joint_rows_[j];
    // A net of hinges has motions that hardly change their errors, and makes a thousand times as much of rounding.
    for (std::size_t i = 0; i < static_cast<std::size_t>(there.equations); ++i, ++at) {
      const JointRow& row = now.equation[i];
      set(at, after(at, row.error, there.equation[i].error, rounding_of(row)) - least_error(row, h));
    }
    for (int i = 0; i < there.stops; ++i) set(at++, there.stop[static_cast<std::size_t>(i)].error);
    if (there.driven) system_[at].bias = -there.motor_speed;
  }
}

/// m, what a gap may be after the drift: an overlap is pushed apart bit by bit.
Real DirectIsland::least_gap(Real now, Real h) const {
  if (now >= -rounding_) return std::min(now, Real{0});
  return now + h / h_ * std::min(-now, most_push);
}

/// m or rad, what the error of a joint may be after the drift: it is mended bit by bit, but for half of what may be
/// rounding: mended, that would say how several contacts share a load. No more is mended than what exceeds it, as a net
/// of hinges makes a thousand times as much of a sudden correction.
Real DirectIsland::least_error(const JointRow& row, Real h) const {
  const Real stays = rounding_of(row) / 2;
  const Real more = row.error - clamp(row.error, -stays, stays);
  const Real most = most_push * (h / h_);
  return row.error - clamp(more, -most, most);
}

/// m, by how much gaps and errors of joints that act will be off after the drift; of angles, what they move at the
/// island's other end.
Real DirectIsland::missed(Real h) const {
  Real most = 0;
  for (const DirectContact& contact : contacts_) {
    const Motion a = motion_after(contact.a, h);
    const Motion b = motion_after(contact.b, h);
    for (std::size_t i = 0; i < contact.count; ++i) {
      if (contact.waits[i]) continue;
      const Real gap = contact.touch.gap(i, a, b) - least_gap(contact.frame.points[i].separation, h);
      most = std::max(most, system_[contact.row + i].impulse > 0 ? std::abs(gap) : -gap);
    }
  }
  for (const ActiveJoint* joint : members_.joints) {
    const JointBlock there = ahead(*joint, h);
    for (std::size_t i = 0; i < static_cast<std::size_t>(there.equations); ++i) {
      const Real error = there.equation[i].error - least_error(joint->block.equation[i], h);
      most = std::max(most, std::abs(error) * (there.equation[i].axis == Vec2{} ? extent_ : Real{1}));
    }
  }
  return most;
}

/// Contacts that slide have the dynamic coefficient from now on; those that stick again the static one. One that bears
/// all of its static friction and stays where it is holds: where several share a load, only motion tells that it was
/// too little. Returns whether some began to slide.
bool DirectIsland::stick_or_slip() {
  bool broke = false;
  for (DirectContact& contact : contacts_) {
    if (contact.static_friction == contact.dynamic_friction || contact.friction_row == DirectContact::no_row) continue;
    const Constraint& row = system_[contact.friction_row];
    double load = 0;
    for (std::size_t i = 0; i < contact.count; ++i) load += system_[contact.row + i].impulse;
    const double rate = ConstraintSystem::speed(row, step_->data.bodies.velocity) + row.bias;
    const bool slips = load > 0 && std::abs(row.impulse) >= row.friction * load && std::abs(rate) > no_slip;
    broke = broke || (slips && !contact.slips);
    contact.slips = slips;
    system_.set_friction(contact.friction_row, contact.friction());
  }
  return broke;
}

/// N s, the impulse of a point along normal and tangent: friction is shared as the load is.
Vec2 DirectIsland::solved(const DirectContact& contact, std::size_t point) const {
  double load = 0;
  for (std::size_t i = 0; i < contact.count; ++i) load += system_[contact.row + i].impulse;
  const double normal = system_[contact.row + point].impulse;
  if (contact.friction_row == DirectContact::no_row) return {static_cast<Real>(normal), 0};
  const double share = load > 0 ? normal / load : 1 / static_cast<double>(contact.count);
  return {static_cast<Real>(normal), static_cast<Real>(system_[contact.friction_row].impulse * share)};
}

/// Adds what the system has just changed to what the contact did in this step. `before`: N s, of each point, what it
/// had when the system began.
void DirectIsland::note(DirectContact& contact, const std::array<Vec2, 2>& before) const {
  const Vec2 normal = contact.frame.normal;
  for (std::size_t i = 0; i < contact.count; ++i) {
    const Constraint& row = system_[contact.row + i];
    contact.total[i] += solved(contact, i) - before[i];
    contact.effect.note(contact.frame.points[i], normal, {static_cast<Real>(row.impulse - row.given), 0});
  }
  if (contact.friction_row == DirectContact::no_row) return;
  const Constraint& friction = system_[contact.friction_row];
  PointArms at;  // both points rub as one
  at.dot_a = friction.arm_a;
  at.dot_b = friction.arm_b;
  contact.effect.note(at, normal, {0, static_cast<Real>(friction.impulse - friction.given)});
}

void DirectIsland::push(const DirectContact& contact, const ContactEffect& by) {
  std::vector<Velocity>& velocity = step_->data.bodies.velocity;
  if (pushable(contact.mass_a)) {
    velocity[contact.a].v -= contact.mass_a.m * by.impulse;
    velocity[contact.a].w -= contact.mass_a.i * by.turned_a;
  }
  if (pushable(contact.mass_b)) {
    velocity[contact.b].v += contact.mass_b.m * by.impulse;
    velocity[contact.b].w += contact.mass_b.i * by.turned_b;
  }
}

/// What lets go after the drift, of most that it bore, should not have been pressed: that is taken back where it acted.
/// Returns whether there was any.
bool DirectIsland::let_go() {
  constexpr double kept = .01;
  bool any = false;
  for (DirectContact& contact : contacts_) {
    const Real pressed = contact.pressing[0].x + contact.pressing[1].x;
    double left = 0;
    for (std::size_t i = 0; i < contact.count; ++i) left += system_[contact.row + i].impulse;
    const bool moved = contact.count == 0 || !looks_the_same(contact, contact.pressed_in);
    contact.lets_go = moved && left < kept * pressed ? static_cast<Real>(1 - left / pressed) : Real{0};
    any = any || contact.lets_go > 0;
  }
  if (!any) return false;
  system_.restart(step_->data.bodies.velocity);
  for (DirectContact& contact : contacts_) {
    if (contact.lets_go == 0) continue;
    push(contact, contact.forget_press(contact.lets_go));
    Vec2 given;
    for (std::size_t i = 0; i < contact.count; ++i) {
      Constraint& row = system_[contact.row + i];
      if (contact.lets_go == 1) row.mass_a = row.mass_b = {};
      row.given = row.impulse = contact.pressing[i].x;
      given += contact.pressing[i];
    }
    if (contact.friction_row == DirectContact::no_row) continue;
    system_[contact.friction_row].given = system_[contact.friction_row].impulse = given.y;
  }
  return true;
}

/// Lists what may act before the drift, with the impulses of the last interval as guesses.
void DirectIsland::list_for_press(Real h) {
  const Real share = h / last_;
  system_.clear();
  joint_rows_.clear();
  for (DirectContact& contact : contacts_) {
    list_contact(contact);
    for (std::size_t i = 0; i < contact.count; ++i) {
      Constraint& row = system_[contact.row + i];
      if (contact.waits[i]) {
        row.mass_a = row.mass_b = {};
        continue;
      }
      row.impulse = share * contact.pressed[i].x;
      if (contact.friction_row == DirectContact::no_row) continue;
      system_[contact.friction_row].impulse += share * contact.pressed[i].y;
    }
  }
  for (ActiveJoint* joint : members_.joints) {
    list_joint(joint->block);
    std::size_t at = joint_rows_.back();
    for_each_row(joint->block, [&](const JointRow& row) { system_[at++].impulse = share * row.half; });
    if (joint->block.driven) system_[at - 1].most = h / 2 * joint->block.motor_strength;
  }
  if (waiting_stop_ != DirectContact::no_row) leave_out(stop_row(waiting_stop_));
}

/// The row in the system of a stop, 2 j or 2 j + 1 of the joint j.
Constraint& DirectIsland::stop_row(std::uint32_t stop) {
  const std::size_t joint = stop / 2;
  return system_[joint_rows_[joint] + static_cast<std::size_t>(members_.joints[joint]->block.equations) + stop % 2];
}

void DirectIsland::leave_out(Constraint& row) {
  row.mass_a = row.mass_b = {};
  row.impulse = 0;
}

/// Impulses before the drift, after which nothing overlaps, what sticks has not slid, and joints hold. False if there
/// are none in reach: gaps and errors are too far from linear, as of a chain that hangs straight.
bool DirectIsland::press(Real h) {
  std::vector<Velocity>& velocity = step_->data.bodies.velocity;
  const Real before = kinetic_energy(members_.bodies, step_->data.bodies);
  list_for_press(h);
  if (fastest() * h > far_turn) {  // as forces alone would turn it: another of many turns would hold as well
    bias_as_linear(h);
    system_.solve(velocity);
  }
  constexpr int rounds = 12;
  constexpr Real runs_off = 16;  // times what an earlier round left: further ones lead nowhere
  Real off = 0;
  Real least = std::numeric_limits<Real>::infinity();
  for (int round = 0; round < rounds; ++round) {
    bias_press(h);
    bool solved = system_.solve(velocity);
    if (round == 0 && stick_or_slip()) {
      bias_press(h);
      solved = system_.solve(velocity);
    }
    off = missed(h);
    if (off <= std::max(exact, rounding_) || !solved) break;
    if (off > std::max(runs_off * least, touching_)) break;
    least = std::min(least, off);
  }
  return off <= touching_ &&
         (is_driven() || kinetic_energy(members_.bodies, step_->data.bodies) <= most_kinetic(before, h));
}

/// The same for gaps and errors that change as they do now.
void DirectIsland::press_as_linear(Real h) {
  list_for_press(h);
  bias_as_linear(h);
  system_.solve(step_->data.bodies.velocity);
  stick_or_slip();
}

void DirectIsland::bias_as_linear(Real h) {
  for (const DirectContact& contact : contacts_) {
    for (std::size_t i = 0; i < contact.count; ++i) {
      const Real gap = contact.frame.points[i].separation;
      system_[contact.row + i].bias = (gap - least_gap(gap, h)) / h;
    }
  }
  for (std::size_t j = 0; j < members_.joints.size(); ++j) {
    const JointBlock& block = members_.joints[j]->block;
    std::uint32_t at = joint_rows_[j];
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.equations); ++i) {
      system_[at++].bias = (block.equation[i].error - least_error(block.equation[i], h)) / h;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.stops); ++i) {
      system_[at++].bias = (block.stop[i].error - least_gap(block.stop[i].error, h)) / h;
    }
    if (block.driven) system_[at].bias = -block.motor_speed;
  }
}

void DirectIsland::note_press() {
  for (DirectContact& contact : contacts_) {
    const ContactEffect before = std::exchange(contact.effect, {});
    note(contact, {});
    contact.pressed_in = contact.frame;
    contact.pressed_by = contact.effect;
    contact.effect += before;
    for (std::size_t i = 0; i < contact.count; ++i) contact.pressing[i] = solved(contact, i);
  }
  pressing_joints_.clear();
  for (std::size_t j = 0; j < members_.joints.size(); ++j) {
    std::size_t at = joint_rows_[j];
    for_each_row(members_.joints[j]->block,
                 [&](const JointRow&) { pressing_joints_.push_back(static_cast<Real>(system_[at++].impulse)); });
  }
}

void DirectIsland::drift(Real h) {
  BodySet& bodies = step_->data.bodies;
  for (const std::uint32_t body : members_.bodies) step_->motion[body].advance(bodies.velocity[body], h);
  if (!members_.varies) return;
  for (std::size_t i = 0; i < members_.bodies.size(); ++i) {
    const std::uint32_t body = members_.bodies[i];
    bodies.pose[body] = step_->motion[body].from(step_->start[body]);
    // What constraints give after the drift is about what they gave before.
    const Velocity& now = bodies.velocity[body];
    Velocity& held = step_->held[body];
    held.v = now.v + (now.v - before_[i].v - by_forces_[i].v);
    held.w = now.w + (now.w - before_[i].w - by_forces_[i].w);
    step_->later[body].v = held.v + h / 2 * step_->acceleration[body].v;
    step_->later[body].w = held.w + h / 2 * step_->acceleration[body].w;
  }
  step_->data.forces.accelerations(bodies, members_.bodies, members_.pulls, h / 2, step_->held, step_->later,
                                   step_->acceleration);
}

/// Impulses after the drift, so that what pushes no longer approaches, and joints stay as they are. They may take back
/// what was pressed too much.
void DirectIsland::relax(Real h) {
  std::vector<Velocity>& velocity = step_->data.bodies.velocity;
  const Real share = h / last_;
  const auto start = [&](Constraint& row, Real given, Real guess) {
    row.given = given;
    row.impulse = guess;
  };
  system_.clear();
  joint_rows_.clear();
  for (DirectContact& contact : contacts_) {
    list_contact(contact);
    Vec2 given, guess;
    for (std::size_t i = 0; i < contact.count; ++i) {
      Constraint& row = system_[contact.row + i];
      const Vec2 pressed = contact.pressing[i];
      const bool touches = contact.frame.points[i].separation <= touching_;
      const auto closing = static_cast<Real>(-ConstraintSystem::speed(row, velocity));
      if (contact.waits[i] || (pressed.x == 0 && (!touches || strikes(contact, closing)))) {
        row.mass_a = row.mass_b = {};
        continue;
      }
      // As much more as the last time.
      const Vec2 total = pressed + share * (contact.impulse[i] - contact.pressed[i]);
      start(row, pressed.x, std::max(total.x, Real{0}));
      given += pressed;
      guess += total;
    }
    if (contact.friction_row != DirectContact::no_row) start(system_[contact.friction_row], given.y, guess.y);
  }
  auto pressing = pressing_joints_.begin();
  for (ActiveJoint* joint : members_.joints) {
    JointBlock& block = joint->block;
    list_joint(block);
    std::size_t at = joint_rows_.back();
    for_each_row(block, [&](const JointRow& row) {
      start(system_[at++], *pressing, *pressing + share * (row.impulse - row.half));
      ++pressing;
    });
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.stops); ++i) {
      Constraint& row = system_[joint_rows_.back() + static_cast<std::size_t>(block.equations) + i];
      if (block.stop[i].error > touching_gap && row.given == 0) leave_out(row);
    }
    if (block.driven) {
      system_[at - 1].most = h * block.motor_strength;
      system_[at - 1].bias = -block.motor_speed;
    }
  }
  if (waiting_stop_ != DirectContact::no_row) leave_out(stop_row(waiting_stop_));
  system_.solve(velocity);
  if (stick_or_slip()) system_.solve(velocity);
  while (let_go()) system_.solve(velocity);
  const bool tells = 8 * h >= h_;  // guesses for the next interval
  for (DirectContact& contact : contacts_) {
    note(contact, contact.pressing);
    if (!tells) continue;
    for (std::size_t i = 0; i < contact.count; ++i) contact.impulse[i] = solved(contact, i);
    contact.pressed = contact.pressing;
  }
  if (!tells) return;
  pressing = pressing_joints_.begin();
  for (std::size_t j = 0; j < members_.joints.size(); ++j) {
    std::size_t at = joint_rows_[j];
    for_each_row(members_.joints[j]->block, [&](JointRow& row) {
      row.impulse = static_cast<Real>(system_[at++].impulse);
      row.half = *pressing++;
    });
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
