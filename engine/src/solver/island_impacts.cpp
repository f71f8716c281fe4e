#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "joints/joint_rows.h"
#include "solver/direct_island.h"
#include "solver/impact_row.h"
#include "solver/restitution.h"

/// What ends an interval of a small island before its sub-step does: an impact, of a contact or of a joint with its
/// stop, which comes at its own time and changes velocities there, and a motor that reaches its speed.
namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Of the distance between a contact's points: the gap of the one up to which it is struck together with the other.
constexpr Real struck_together = static_cast<Real>(1e-4);
constexpr Real slides_at = static_cast<Real>(1e-4);  // m/s, what slides faster when it is struck has sliding friction
/// m, gap that is none: less than rounding leaves of an advance to the time of an impact.
constexpr Real no_gap = static_cast<Real>(sizeof(Real) == 8 ? 1e-13 : 1e-6);
/// Of an interval: an impact that comes later by less is at its end, so that nothing brakes it before; and one that
/// comes sooner is now. Of a sub-step: no interval is shorter, in which gaps change by less than they are rounded by.
constexpr Real at_the_end = static_cast<Real>(1e-9);

/// A gap, m or rad, and the speed at which it closes.
struct Nearing {
  Real gap = 0, speed = 0;
};

/// s, from where Newton's iteration finds when a gap closes that is open now and at the end: where bodies pass each
/// other it is least in between, sought by the secant of its rate. As it is convex, the iteration then comes from one
/// side. nullopt if it stays open.
template <class At>
std::optional<Real> before_least(const Nearing& now, const Nearing& end, Real within, const At& at) {
  if (!(now.speed > 0 && end.speed < 0)) return std::nullopt;
  constexpr int rounds = 6;
  Real low = 0;
  Real high = within;
  Nearing at_low = now;
  Nearing at_high = end;
  for (int round = 0; round < rounds; ++round) {
    const Real t = low + (high - low) * at_low.speed / (at_low.speed - at_high.speed);
    const Nearing there = at(t);
    if (!(there.gap > 0)) return low;
    (there.speed > 0 ? low : high) = t;
    (there.speed > 0 ? at_low : at_high) = there;
  }
  return std::nullopt;
}

/// s and the speed at which a gap closes, sought within `within`; nullopt if it does not. `at(t)`: what is near at that
/// time. The parabola through the gap now, its rate, and the gap at the end gives a guess; Newton's iteration on the
/// path refines it.
template <class At>
std::optional<std::pair<Real, Real>> closes(const Nearing& now, Real within, const At& at) {
  if (!(now.gap > no_gap)) return std::pair{Real{0}, now.speed};
  const auto refined = [&](Real t) -> std::optional<std::pair<Real, Real>> {
    constexpr int rounds = 4;
    Nearing there;
    bool settled = false;  // further rounds change nothing
    for (int round = 0; round < rounds && !settled; ++round) {
      there = at(t);
      if (there.speed <= 0) return std::nullopt;
      const Real last = std::exchange(t, std::max(t + there.gap / there.speed, Real{0}));
      settled = t == last;
    }
    if (t > (1 + at_the_end) * within) return std::nullopt;
    const Real time = std::min(t, within);
    if (!settled || time != t) there = at(time);
    return std::pair{time, there.speed};
  };
  const Nearing end = at(within);
  const Real v = -now.speed;
  const Real c = 2 * (end.gap - now.gap - v * within) / (within * within);
  const Real discriminant = v * v - 2 * c * now.gap;
  if (discriminant >= 0) {
    const Real mean = std::sqrt(discriminant) - v;
    if (mean > 0 && 2 * now.gap <= 2 * within * mean) {
      if (const auto met = refined(2 * now.gap / mean)) return met;
    }
  }
  const std::optional<Real> guess = before_least(now, end, within, at);
  return guess ? refined(*guess) : std::nullopt;
}

}  // namespace

void DirectIsland::substep() {
  // Of going to an impact and of resolving it. Elastic ones end by themselves.
  const std::size_t most = 128 + 32 * (contacts_.size() + members_.joints.size());
  constexpr std::size_t most_elastic = 10000;
  std::size_t count = 0;
  std::size_t elastic = 0;
  Real left = h_;
  while (left > 0) {
    Real now = motors_reach(std::min({left, longest(h_), solvable_}));
    std::optional<Impact> next;
    if (count < most && elastic < most_elastic) next = next_impact(now);
    if (next) {
      const bool rebounds = next->stop == DirectContact::no_row && contacts_[next->contact].restitution >= 1;
      ++(rebounds ? elastic : count);
      // What is nearer than time can tell is struck now: another contact may keep it from ever coming nearer.
      if (!(next->time > at_the_end * h_)) {
        strike(*next);
        approaches(*next) = system_.yielded() ? most_approaches + 1 : 0;
        continue;
      }
      now = next->time;
    }
    if (left - now <= at_the_end * h_) now = left;
    const Real gone = advance(now, next.value_or(Impact{}));
    if (gone > 0) {
      left -= gone;
      if (next) ++approaches(*next);
    } else {
      solvable_ = now / 2;
    }
  }
}

/// s, up to `most`, but no less than 1/64 of a sub-step: in which no body turns far, because normals turn with the
/// bodies, nor does what one bears run far along it, as a face that rolls over a disc, and none goes farther than its
/// size past what it has not reached yet, because other corners may meet than are nearest now. In a jam no motion is
/// exact: once a step has met one, what bears runs on for a quarter of a sub-step.
Real DirectIsland::longest(Real most) const {
  const Real shortest_of_all = h_ / 64;
  const Real shortest_run = met_jam_ ? h_ / 4 : shortest_of_all;
  const Real w = fastest();
  Real time = w * most > far_turn ? std::max(far_turn / w, shortest_of_all) : most;
  const BodySet& bodies = step_->data.bodies;
  for (const DirectContact& contact : contacts_) {
    if (contact.lasts || contact.count == 0) continue;
    const auto& [p, q] = contact.frame.points;
    const Real gap = contact.count == 2 ? std::min(p.separation, q.separation) : p.separation;
    if (gap <= touching_) {
      const Real turned = turns(contact, time);
      if (turned > far_turn) time = std::max(time * far_turn / turned, std::min(time, shortest_run));
      continue;
    }
    const Real speed = length(bodies.velocity[contact.b].v - bodies.velocity[contact.a].v);
    const Real size = std::min(bodies.bounding_radius[contact.a], bodies.bounding_radius[contact.b]);
    const Real way = std::max(gap, size);
    if (size > 0 && speed * time > way) time = std::max(way / speed, shortest_of_all);
  }
  return time;
}

/// By how much a contact changes that touches: rad, its normal; of their bodies' reach, the arms of its points.
Real DirectIsland::turns(const DirectContact& contact, Real within) const {
  const TouchFrame then = contact.touch.at(flown_motion(contact.a, within), flown_motion(contact.b, within));
  Real most = length(then.normal - contact.frame.normal);
  const auto consider = [&](std::uint32_t body, const InverseMass& mass, Vec2 change) {
    if (pushable(mass)) most = std::max(most, length(change) / step_->data.bodies.bounding_radius[body]);
  };
  for (std::size_t i = 0; i < contact.count; ++i) {
    const PointArms& p = contact.frame.points[i];
    const PointArms& q = then.points[i];
    if (p.separation > touching_) continue;
    consider(contact.a, contact.mass_a, {q.dot_a - p.dot_a, q.cross_a - p.cross_a});
    consider(contact.b, contact.mass_b, {q.dot_b - p.dot_b, q.cross_b - p.cross_b});
  }
  return most;
}

/// rad/s
Real DirectIsland::fastest() const {
  Real most = 0;
  for (const std::uint32_t body : members_.bodies) {
    most = std::max(most, std::abs(step_->data.bodies.velocity[body].w));
  }
  return most;
}

/// rad/s, of the fastest link that swings under the pull of its hinges, as these are pressed in an interval: a force F
/// at an arm r from its centre turns it back by F r for each radian.
Real DirectIsland::swings(Real h) const {
  std::vector<Velocity>& pull = step_->later;
  for (const std::uint32_t body : members_.bodies) pull[body].w = 0;
  for (std::size_t j = 0; j < members_.joints.size(); ++j) {
    const JointBlock& block = members_.joints[j]->block;
    const JointRow& x = block.equation[0];
    const JointRow& y = block.equation[1];
    const bool hinge = block.equations == 2 && x.axis != Vec2{} && y.axis != Vec2{};
    if (!hinge) continue;
    const auto of_x = static_cast<Real>(system_[joint_rows_[j]].impulse);
    const auto of_y = static_cast<Real>(system_[joint_rows_[j] + 1].impulse);
    // A row has r x n, which is the arm along the other axis.
    if (pushable(block.inv_mass_a)) pull[block.a].w -= of_x * y.arm_a - of_y * x.arm_a;
    if (pushable(block.inv_mass_b)) pull[block.b].w += of_x * y.arm_b - of_y * x.arm_b;
  }
  Real most = 0;
  for (const std::uint32_t body : members_.bodies) {
    most = std::max(most, std::abs(pull[body].w) * step_->data.bodies.inverse_mass[body].i);
  }
  return std::sqrt(2 * most / h);  // half of the impulses come after the drift
}

/// s, until the first motor that works with all its strength has its speed; `within` if that is later, or so soon or so
/// late that what is left to do does not matter. By regula falsi, as forces hardly change.
Real DirectIsland::motors_reach(Real within) {
  const std::vector<Velocity>& velocity = step_->data.bodies.velocity;
  const Real negligible = h_ / 64;
  std::vector<Real> works;  // the direction of each motor's impulse, 0 of those that have their speed
  bool any = false;
  for (const ActiveJoint* joint : members_.joints) {
    const JointBlock& block = joint->block;
    const Real short_of =
        block.driven ? block.motor_speed - rate(block.motor, velocity[block.a], velocity[block.b]) : Real{0};
    works.push_back(std::abs(short_of) > no_speed ? std::copysign(Real{1}, short_of) : Real{0});
    any = any || works.back() != 0;
  }
  if (!any) return within;
  for (DirectContact& contact : contacts_) let_wait(contact, false);
  waiting_stop_ = DirectContact::no_row;
  Real low = negligible;
  Real high = within;
  const std::vector<Real> now = motors_lack(low, works);
  for (std::size_t j = 0; j < works.size(); ++j) {
    if (now[j] <= 0) works[j] = 0;
  }
  const auto least = [&](Real t) {
    const std::vector<Real> all = motors_lack(t, works);
    return *std::min_element(all.begin(), all.end());
  };
  Real at_low = least(low);
  Real at_high = least(high);
  if (!(at_high < 0)) return within;
  constexpr int rounds = 3;
  for (int round = 0; round < rounds && high - low > negligible; ++round) {
    const Real t = low + (high - low) * at_low / (at_low - at_high);
    const Real there = least(t);
    (there > 0 ? low : high) = t;
    (there > 0 ? at_low : at_high) = there;
  }
  const Real reached = low + (high - low) * at_low / (at_low - at_high);
  return within - reached > negligible ? reached : within;
}

/// N s or N m s, of each motor that works: what it needs to have its speed after a time, beyond what it can give in
/// that; else infinite. Sought as what presses in an interval twice as long, whose half has the forces of all that
/// time.
std::vector<Real> DirectIsland::motors_lack(Real time, const std::vector<Real>& works) {
  constexpr Real infinity = std::numeric_limits<Real>::infinity();
  note_velocities(before_);
  by_forces_.assign(members_.bodies.size(), {});
  kick(2 * time);
  list_for_press(2 * time);
  const auto motor = [&](std::size_t j) -> Constraint& {
    const JointBlock& block = members_.joints[j]->block;
    return system_[joint_rows_[j] + static_cast<std::size_t>(block.equations + block.stops)];
  };
  for (std::size_t j = 0; j < works.size(); ++j) {
    if (works[j] != 0) motor(j).most = std::numeric_limits<double>::infinity();
  }
  bias_press(2 * time);
  system_.solve(step_->data.bodies.velocity);
  std::vector<Real> lacks;
  for (std::size_t j = 0; j < works.size(); ++j) {
    const Real gives = time * members_.joints[j]->block.motor_strength;
    lacks.push_back(works[j] != 0 ? works[j] * static_cast<Real>(motor(j).impulse) - gives : infinity);
  }
  restore_velocities();
  return lacks;
}

/// The first impact from now on, the fastest of several.
std::optional<DirectIsland::Impact> DirectIsland::next_impact(Real within) const {
  std::optional<Impact> first;
  const auto consider = [&first](const std::optional<Impact>& one) {
    if (!one) return;
    const bool earlier = !first || one->time < first->time || (one->time == first->time && one->speed > first->speed);
    if (earlier) first = one;
  };
  for (std::uint32_t c = 0; c < contacts_.size(); ++c) {
    if (contacts_[c].approached <= most_approaches) consider(impact_of(c, within));
  }
  for (std::uint32_t stop = 0; stop < approached_stops_.size(); ++stop) {
    if (approached_stops_[stop] <= most_approaches) consider(impact_of_stop(stop, within));
  }
  return first;
}

int& DirectIsland::approaches(const Impact& impact) {
  return impact.stop == DirectContact::no_row ? contacts_[impact.contact].approached : approached_stops_[impact.stop];
}

/// When a joint comes to its stop faster than forces alone drive it there. Rates of hinges and of sliders have units of
/// their own, so forces tell what is slow.
std::optional<DirectIsland::Impact> DirectIsland::impact_of_stop(std::uint32_t stop, Real within) const {
  constexpr Real inelastic = static_cast<Real>(0.1);  // as of contacts, see strikes()
  const ActiveJoint& joint = *members_.joints[stop / 2];
  const JointBlock& block = joint.block;
  if (static_cast<int>(stop % 2) >= block.stops) return std::nullopt;
  const auto at = [&](Real t) {
    const JointBlock there = placed(joint, flown_motion(block.a, t), flown_motion(block.b, t));
    const JointRow& row = there.stop[stop % 2];
    return Nearing{row.error, -rate(row, flown_velocity(block.a, t), flown_velocity(block.b, t))};
  };
  const auto met = closes(at(0), within, at);
  if (!met) return std::nullopt;
  const Real gained = rate(block.stop[stop % 2], step_->acceleration[block.a], step_->acceleration[block.b]) * h_;
  if (met->second <= inelastic * std::abs(gained) + no_speed) return std::nullopt;
  return Impact{.time = met->first, .speed = met->second, .stop = stop};
}

/// When a point of the contact touches faster than the threshold, if bodies go on under forces and what bears them.
std::optional<DirectIsland::Impact> DirectIsland::impact_of(std::uint32_t index, Real within) const {
  const DirectContact& contact = contacts_[index];
  const auto frame_at = [&](Real t) {
    return contact.touch.at(flown_motion(contact.a, t), flown_motion(contact.b, t));
  };
  std::optional<TouchFrame> end;
  std::optional<Impact> first;
  for (std::size_t i = 0; i < contact.count; ++i) {
    const auto near_at = [&](const TouchFrame& frame, Real t) {
      return Nearing{frame.points[i].separation, closing(contact, frame, i, t)};
    };
    const auto met = closes(near_at(contact.frame, 0), within, [&](Real t) {
      if (t != within) return near_at(frame_at(t), t);
      if (!end) end = frame_at(within);
      return near_at(*end, within);
    });
    if (!met || !strikes(contact, met->second)) continue;
    const Impact one{.time = met->first, .speed = met->second, .contact = index};
    if (!first || one.time < first->time || (one.time == first->time && one.speed > first->speed)) first = one;
  }
  return first;
}

Motion DirectIsland::flown_motion(std::uint32_t body, Real t) const {
  const Velocity& v = step_->data.bodies.velocity[body];
  const Velocity& a = step_->flight[body];
  Motion at = step_->motion[body];
  at.d += t * v.v + (t * t / 2) * a.v;
  at.turn_by(t * v.w + (t * t / 2) * a.w);
  return at;
}

Velocity DirectIsland::flown_velocity(std::uint32_t body, Real t) const {
  const Velocity& v = step_->data.bodies.velocity[body];
  const Velocity& a = step_->flight[body];
  return {v.v + t * a.v, v.w + t * a.w};
}

/// m/s, at which the gap of a point closes.
Real DirectIsland::closing(const DirectContact& contact, const TouchFrame& frame, std::size_t point, Real t) const {
  const Velocity a = flown_velocity(contact.a, t);
  const Velocity b = flown_velocity(contact.b, t);
  return dot(frame.normal, a.v - b.v) + a.w * frame.points[point].cross_a - b.w * frame.points[point].cross_b;
}

/// Resolves an impact now. An inelastic one, as that of a joint with its stop, is resolved with all that touch; an
/// elastic one is between its two bodies, as in Newton's cradle, and what these then meet is struck next. Joints hold
/// in either.
void DirectIsland::strike(const Impact& impact) {
  const std::uint32_t index = impact.contact;
  const bool alone = impact.stop == DirectContact::no_row && contacts_[index].restitution > 0;
  system_.clear();
  joint_rows_.clear();
  for (std::uint32_t c = 0; c < contacts_.size(); ++c) {
    DirectContact& contact = contacts_[c];
    contact.struck = c == index || !alone;
    if (contact.struck) list_struck(contact, c == index);
  }
  for (const ActiveJoint* joint : members_.joints) {
    const JointBlock& block = joint->block;
    list_joint(block);
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.stops); ++i) {
      Constraint& row = system_[joint_rows_.back() + static_cast<std::size_t>(block.equations) + i];
      if (block.stop[i].error > touching_gap) row.mass_a = row.mass_b = {};
    }
    // A motor's impulse is 0 in no time.
  }
  solve_impact(alone ? &contacts_[index] : nullptr);
  for (DirectContact& contact : contacts_) {
    if (contact.struck) note(contact, {});
  }
  if (members_.varies) find_forces_again();
}

/// An impact changes the forces that depend on velocities, and bodies go on under these.
void DirectIsland::find_forces_again() {
  const BodySet& bodies = step_->data.bodies;
  std::vector<Velocity>& force = step_->acceleration;
  for (const std::uint32_t body : members_.bodies) {
    step_->flight[body].v -= force[body].v;
    step_->flight[body].w -= force[body].w;
  }
  step_->data.forces.accelerations(bodies, members_.bodies, members_.pulls, 0, bodies.velocity, bodies.velocity, force);
  for (const std::uint32_t body : members_.bodies) {
    step_->flight[body].v += force[body].v;
    step_->flight[body].w += force[body].w;
  }
}

/// `first`: whether the contact is the one that is struck, and not one that only touches.
void DirectIsland::list_struck(DirectContact& contact, bool first) {
  const auto& [one, other] = contact.frame.points;
  const Real apart = contact.count == 2 ? std::abs(one.cross_a - other.cross_a) : Real{0};
  const Real reach = first ? std::max(struck_together * apart, touching_) : touching_;
  const std::vector<Velocity>& velocity = step_->data.bodies.velocity;
  bool any = false;
  bool rebounds = false;  // in an impact of its own, which is next
  Real slide = 0;
  for (std::size_t i = 0; i < contact.count; ++i) {
    const bool touches = contact.frame.points[i].separation <= reach;
    any = any || touches;
    rebounds = rebounds || (touches && !first && contact.restitution > 0 &&
                            strikes(contact, closing(contact, contact.frame, i, 0)));
    slide = std::max(slide, std::abs(contact.frame.sliding(i, velocity[contact.a], velocity[contact.b])));
  }
  contact.struck = any && !rebounds;
  if (!contact.struck) return;
  // What slides when it is struck slides until friction has stopped it.
  const bool slips = std::exchange(contact.slips, slide > slides_at);
  list_contact(contact);
  contact.slips = slips;
  for (std::size_t i = 0; i < contact.count; ++i) {
    Constraint& row = system_[contact.row + i];
    const double v = ConstraintSystem::speed(row, velocity);
    if (contact.frame.points[i].separation > reach) row.mass_a = row.mass_b = {};
    if (first) row.bias = contact.restitution * std::min(v, 0.);
  }
}

/// Newton's law with friction, or at two points of which one parts and is stopped by what the other does to it, can
/// create energy at eccentric impacts (Kane and Levinson 1985): then the contact rebounds by the largest share of its
/// restitution that creates none. It has no solution for some (Painleve): then the normal impulses are those without
/// friction, and friction only removes energy. `alone`: the contact that is struck, if no other is.
void DirectIsland::solve_impact(const DirectContact* alone) {
  std::vector<Velocity>& velocity = step_->data.bodies.velocity;
  bool pushes_first = false;
  bool found = false;
  const auto solve = [&] {
    if (pushes_first) solve_pushes_first();
    found = pushes_first || system_.solve(velocity) || system_.yielded();
  };
  const auto rebound = [&](double share) {
    system_.undo(velocity);
    for (std::size_t i = 0; alone != nullptr && i < alone->count; ++i) {
      Constraint& row = system_[alone->row + i];
      row.bias = share * alone->restitution * std::min(ConstraintSystem::speed(row, velocity), 0.);
    }
    solve();
  };
  const auto work_at = [&](double share) {
    rebound(share);
    return found ? system_.work().done : std::numeric_limits<double>::infinity();
  };
  solve();
  for (const bool first : {false, true}) {
    if (first != std::exchange(pushes_first, first)) rebound(1);
    if (found && system_.work().is_none()) return;
    if (!found || alone == nullptr) continue;
    rebound(largest_share(system_.work().done, work_at));
    if (found && system_.work().is_none()) return;
  }
}

void DirectIsland::solve_pushes_first() {
  std::vector<Velocity>& velocity = step_->data.bodies.velocity;
  for (Constraint& row : system_.all()) row.fixed = row.law == Law::rubs;
  system_.solve(velocity);
  for (Constraint& row : system_.all()) row.fixed = row.law == Law::pushes;
  system_.reconsider();
  system_.solve(velocity);
}

}  // namespace impulse::inline IMPULSE_PRECISION
