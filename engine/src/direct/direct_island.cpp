#include "direct/direct_island.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "narrow_phase/collide.h"
#include "narrow_phase/margin.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr Real far = static_cast<Real>(0.002);   // m, sliding before a contact is found again
constexpr Real near = static_cast<Real>(0.05);   // m, gap up to which points are sought
constexpr Real give = static_cast<Real>(1e-6);   // compliance of joints: a spring with w h = 1000
constexpr Real most_push = static_cast<Real>(.001);  // m, by which an overlap is pushed apart in a sub-step
constexpr Real together = static_cast<Real>(0.0005);
constexpr Real touching = static_cast<Real>(1e-6);   // m


/// m, by which a point of body b slides along the tangent past body a while they move by these.
Real slip(const TouchFrame& frame, const PointArms& p, const Motion& a, const Motion& b) {
  const Real centres = dot(perpendicular(frame.normal), b.d - a.d);
  const Real core_b = b.sine * p.turn_b - b.drop * p.cross_b;
  const Real core_a = a.sine * p.turn_a - a.drop * p.cross_a;
  return centres + (core_b + b.turn * (p.dot_b - p.turn_b)) - (core_a + a.turn * (p.dot_a - p.turn_a));
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
  h_ = data.settings.dt / static_cast<Real>(substeps_);
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
    contact.touch = Touch(from, data.bodies, step_->start[contact.a], step_->start[contact.b]);
    for (std::size_t i = 0; i < contact.count; ++i) {
      contact.impulse[i] = Vec2{from.points[i].normal_impulse, from.points[i].tangent_impulse} / static_cast<Real>(substeps_);
    }
    contacts_.push_back(contact);
  }
  for (DirectContact& contact : contacts_) {
    if (pushable(contact.mass_a) && pushable(contact.mass_b)) continue;
    const std::uint32_t body = pushable(contact.mass_a) ? contact.a : contact.b;
    contact.may_join = std::count_if(contacts_.begin(), contacts_.end(), [body](const DirectContact& other) {
                         return (other.a == body && !pushable(other.mass_b)) || (other.b == body && !pushable(other.mass_a));
                       }) > 1;
  }
  for (ActiveJoint* joint : members_.joints) {
    for_each_row(joint->block, [&](JointRow& row) { row.impulse /= static_cast<Real>(substeps_); });
  }
  // What bore the bodies in the last sub-step.
  std::vector<Velocity>& velocity = data.bodies.velocity;
  before_.clear();
  for (const std::uint32_t body : members_.bodies) before_.push_back(velocity[body]);
  for (const DirectContact& contact : contacts_) {
    const TouchFrame frame = contact.touch.at(step_->motion[contact.a], step_->motion[contact.b]);
    for (std::size_t i = 0; i < contact.count; ++i) {
      const Vec2 world = contact.impulse[i].x * frame.normal + contact.impulse[i].y * perpendicular(frame.normal);
      const Real turn_a = contact.impulse[i].x * frame.points[i].cross_a + contact.impulse[i].y * frame.points[i].dot_a;
      const Real turn_b = contact.impulse[i].x * frame.points[i].cross_b + contact.impulse[i].y * frame.points[i].dot_b;
      if (pushable(contact.mass_a)) {
        velocity[contact.a].v -= contact.mass_a.m * world;
        velocity[contact.a].w -= contact.mass_a.i * turn_a;
      }
      if (pushable(contact.mass_b)) {
        velocity[contact.b].v += contact.mass_b.m * world;
        velocity[contact.b].w += contact.mass_b.i * turn_b;
      }
    }
  }
  for (const ActiveJoint* joint : members_.joints) {
    const JointBlock& block = joint->block;
    for_each_row(block, [&](const JointRow& row) { apply(block, row, row.impulse, velocity[block.a], velocity[block.b]); });
  }
  note_loads(before_);
  for (std::size_t i = 0; i < members_.bodies.size(); ++i) velocity[members_.bodies[i]] = before_[i];
}

/// The accelerations until now, from the change of velocities that constraints caused in a sub-step.
void DirectIsland::note_loads(const std::vector<Velocity>& before) {
  for (std::size_t i = 0; i < members_.bodies.size(); ++i) {
    const std::uint32_t body = members_.bodies[i];
    const Velocity& now = step_->data.bodies.velocity[body];
    Velocity& flight = step_->flight[body];
    flight = step_->acceleration[body];
    if (!step_->data.bodies.pushable(body)) continue;
    flight.v += (now.v - before[i].v) / h_;
    flight.w += (now.w - before[i].w) / h_;
  }
}

void DirectIsland::note(DirectContact& contact, std::size_t point, Vec2 impulse, Vec2 normal) {
  contact.total[point] += impulse;
  contact.acted += impulse.x * normal + impulse.y * perpendicular(normal);
}

void DirectIsland::refresh() {
  for (DirectContact& contact : contacts_) {
    const Motion& a = step_->motion[contact.a];
    const Motion& b = step_->motion[contact.b];
    find(contact, a, b);
    contact.frame = contact.touch.at(a, b);
  }
}

/// Finds a contact again if its bodies have slid past each other since the last time, because other corners may be near.
/// Where a body meets several shapes of the ground, only the search removes ghost collisions at joins.
bool DirectIsland::find(DirectContact& contact, const Motion& a, const Motion& b) {
  StepData& data = step_->data;
  const BodySet& bodies = data.bodies;
  if (contact.may_join ||
      contact.touch.moved(a, b, bodies.bounding_radius[contact.a], bodies.bounding_radius[contact.b]) < far) {
    return false;
  }
  Contact& found = data.contacts[contact.contact];
  const Pose pose_a = a.from(step_->start[contact.a]);
  const Pose pose_b = b.from(step_->start[contact.b]);
  const Shape& shape_a = bodies.detail[contact.a].parts[found.part_a].shape;
  const Shape& shape_b = bodies.detail[contact.b].parts[found.part_b].shape;
  const auto found_within = [&](Real t) {
    return collide(shape_a, pose_a, shape_b, pose_b, speculative_gap(bodies, contact.a, contact.b, {near, t}));
  };
  Manifold m = found_within(h_);
  if (m.count == 0) m = found_within(data.settings.dt);
  if (m.count == 0) return false;
  const std::array<ContactPoint, 2> last = found.points;
  const std::size_t last_count = contact.count;
  const std::array<Vec2, 2> impulse = contact.impulse;
  const std::array<Vec2, 2> total = contact.total;
  contact.impulse = {};
  contact.total = {};
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
  for (std::size_t j = 0; j < last_count; ++j) {
    std::size_t i = 0;
    while (i < contact.count && found.points[i].feature != last[j].feature) ++i;
    if (i == contact.count) i = 0;
    contact.impulse[i] += impulse[j];
    contact.total[i] += total[j];
  }
  contact.touch = Touch(found, bodies, a, b);
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

void DirectIsland::kick() {
  for (const std::uint32_t body : members_.bodies) {
    Velocity& velocity = step_->data.bodies.velocity[body];
    velocity.v += h_ / 2 * step_->acceleration[body].v;
    velocity.w += h_ / 2 * step_->acceleration[body].w;
  }
}

void DirectIsland::list_contact(DirectContact& contact, const TouchFrame& frame, bool rubs) {
  Constraint row;
  row.a = contact.a;
  row.b = contact.b;
  row.mass_a = contact.mass_a;
  row.mass_b = contact.mass_b;
  row.axis = frame.normal;
  row.law = Law::pushes;
  for (std::size_t i = 0; i < contact.count; ++i) {
    row.arm_a = frame.points[i].cross_a;
    row.arm_b = frame.points[i].cross_b;
    row.acts = contact.impulse[i].x > 0;
    contact.row[i] = system_.add(row);
  }
  contact.friction_row = ~std::uint32_t{0};
  if (!rubs || !(contact.friction() > 0)) return;
  row.axis = perpendicular(frame.normal);
  row.law = Law::rubs;
  row.first = contact.row[0];
  row.count = static_cast<std::uint32_t>(contact.count);
  row.friction = contact.friction();
  for (std::size_t i = 0; i < contact.count; ++i) {
    row.point_a[i] = frame.points[i].dot_a;
    row.point_b[i] = frame.points[i].dot_b;
  }
  row.arm_a = row.point_a[0];
  row.arm_b = row.point_b[0];
  row.acts = contact.impulse[0].x + contact.impulse[1].x > 0;
  contact.friction_row = system_.add(row);
}

void DirectIsland::list_joint(const JointBlock& block) {
  joint_rows_.push_back(static_cast<std::uint32_t>(system_.all().size()));
  const auto add = [&](const JointRow& from, Law law) {
    Constraint row;
    row.a = block.a;
    row.b = block.b;
    row.mass_a = block.inv_mass_a;
    row.mass_b = block.inv_mass_b;
    row.axis = from.axis;
    row.arm_a = from.arm_a;
    row.arm_b = from.arm_b;
    row.law = law;
    const Real mass = effective_mass(block, from);
    if (law == Law::holds && mass > 0) row.compliance = give / mass;
    row.acts = from.impulse != 0;
    system_.add(row);
  };
  for (int i = 0; i < block.equations; ++i) add(block.equation[static_cast<std::size_t>(i)], Law::holds);
  for (int i = 0; i < block.stops; ++i) add(block.stop[static_cast<std::size_t>(i)], Law::pushes);
  if (block.driven) add(block.motor, Law::drives);
}

/// Sets the biases so that gaps, slips and the errors of joints after a drift at the present velocities vanish if they
/// are linear.
void DirectIsland::bias_press() {
  const std::vector<Velocity>& velocity = step_->data.bodies.velocity;
  const auto set = [&](std::uint32_t at, Real miss) {
    Constraint& row = system_[at];
    row.bias = miss / h_ - ConstraintSystem::speed(row, velocity);
  };
  for (const DirectContact& contact : contacts_) {
    const Motion a = motion_after(contact.a, h_);
    const Motion b = motion_after(contact.b, h_);
    const bool rubs = contact.friction_row != ~std::uint32_t{0};
    Motion by_a, by_b;
    if (rubs) {
      by_a.advance(velocity[contact.a], h_);
      by_b.advance(velocity[contact.b], h_);
    }
    for (std::size_t i = 0; i < contact.count; ++i) {
      const Real now = contact.frame.points[i].separation;
      const Real least = now < 0 ? std::min(now + most_push, Real{0}) : Real{0};
      set(contact.row[i], contact.touch.gap(i, a, b) - least);
      if (!rubs) continue;
      Constraint& row = system_[contact.friction_row];
      const Real speed = dot(row.axis, velocity[contact.b].v - velocity[contact.a].v) +
                         velocity[contact.b].w * row.point_b[i] - velocity[contact.a].w * row.point_a[i];
      row.point_bias[i] = slip(contact.frame, contact.frame.points[i], by_a, by_b) / h_ - speed;
    }
  }
  for (std::size_t j = 0; j < members_.joints.size(); ++j) {
    const JointBlock there = ahead(*members_.joints[j], h_);
    std::uint32_t at = joint_rows_[j];
    for (int i = 0; i < there.equations; ++i) set(at++, there.equation[static_cast<std::size_t>(i)].error);
    for (int i = 0; i < there.stops; ++i) set(at++, there.stop[static_cast<std::size_t>(i)].error);
    if (there.driven) system_[at].bias = -there.motor_speed;
  }
}

/// Impulses before the drift, after which nothing overlaps, what sticks has not slid, and joints hold.
void DirectIsland::press() {
  std::vector<Velocity>& velocity = step_->data.bodies.velocity;
  system_.clear();
  joint_rows_.clear();
  for (DirectContact& contact : contacts_) list_contact(contact, contact.frame, true);
  for (ActiveJoint* joint : members_.joints) {
    list_joint(joint->block);
    if (joint->block.driven) system_[system_.all().size() - 1].most = h_ / 2 * joint->block.motor_strength;
  }
  constexpr int rounds = 6;
  for (int round = 0; round < rounds; ++round) {
    bias_press();
    const bool ok = system_.solve(velocity);
    if (getenv("DBG") && !ok) fprintf(stderr, "press fails: %zu rows\n", system_.all().size());
    if (round == 0 && stick_or_slip()) {
      bias_press();
      system_.solve(velocity);
    }
    if (residual_of_press() <= static_cast<Real>(1e-12)) break;
  }
  read_impulses(true);
  if (getenv("DBG3")) { for (auto& c : contacts_) { fprintf(stderr, "press n %.3g %.3g:", (double)c.frame.normal.x, (double)c.frame.normal.y); for (std::size_t i = 0; i < c.count; ++i) fprintf(stderr, " [s %.6g j %.9g %.9g cr %.6g]", (double)c.frame.points[i].separation, (double)c.impulse[i].x, (double)c.impulse[i].y, (double)c.frame.points[i].cross_b); fprintf(stderr, " res %.3g\n", (double)residual_of_press()); } }
}

/// m, by how much gaps and errors of joints that act will be off after the drift.
Real DirectIsland::residual_of_press() const {
  Real most = 0;
  for (const DirectContact& contact : contacts_) {
    for (std::size_t i = 0; i < contact.count; ++i) {
      ConstraintSystem& system = const_cast<ConstraintSystem&>(system_);
      const Real now = contact.frame.points[i].separation;
      const Real least = now < 0 ? std::min(now + most_push, Real{0}) : Real{0};
      const Real gap = contact.touch.gap(i, motion_after(contact.a, h_), motion_after(contact.b, h_)) - least;
      most = std::max(most, system[contact.row[i]].impulse > 0 ? std::abs(gap) : -gap);
    }
  }
  for (const ActiveJoint* joint : members_.joints) {
    const JointBlock there = ahead(*joint, h_);
    for (int i = 0; i < there.equations; ++i) {
      most = std::max(most, std::abs(there.equation[static_cast<std::size_t>(i)].error));
    }
  }
  return most;
}

/// Contacts that slide have the dynamic coefficient from now on; those that stick again the static one. Returns whether
/// some began to slide.
bool DirectIsland::stick_or_slip() {
  bool broke = false;
  for (DirectContact& contact : contacts_) {
    if (contact.static_friction == contact.dynamic_friction || contact.friction_row == ~std::uint32_t{0}) continue;
    Constraint& row = system_[contact.friction_row];
    Real load = 0;
    for (std::size_t i = 0; i < contact.count; ++i) load += system_[contact.row[i]].impulse;
    const bool slips = load > 0 && std::abs(row.impulse) >= row.friction * load;
    broke = broke || (slips && !contact.slips);
    contact.slips = slips;
    row.friction = contact.friction();
  }
  return broke;
}

/// Takes the impulses of contacts and joints from the system.
void DirectIsland::read_impulses(bool pressing) {
  for (DirectContact& contact : contacts_) {
    if (pressing) contact.impulse = {};
    Real load = 0;
    Real most = 0;
    for (std::size_t i = 0; i < contact.count; ++i) {
      if (contact.row[i] == ~std::uint32_t{0}) continue;
      load += system_[contact.row[i]].impulse;
      most = std::max(most, system_[contact.row[i]].impulse);
    }
    const Real friction = contact.friction_row == ~std::uint32_t{0} ? Real{0} : system_[contact.friction_row].impulse;
    for (std::size_t i = 0; i < contact.count; ++i) {
      if (contact.row[i] == ~std::uint32_t{0}) continue;
      const Real normal = system_[contact.row[i]].impulse;
      const Vec2 now{normal, load > 0 ? friction * (normal / load) : Real{0}};
      note(contact, i, now - contact.impulse[i], contact.frame.normal);
      contact.impulse[i] = now;
    }
  }
  for (std::size_t j = 0; j < members_.joints.size(); ++j) {
    std::uint32_t at = joint_rows_[j];
    for_each_row(members_.joints[j]->block, [&](JointRow& row) { row.impulse = system_[at++].impulse; });
  }
}

void DirectIsland::drift() {
  BodySet& bodies = step_->data.bodies;
  for (const std::uint32_t body : members_.bodies) step_->motion[body].advance(bodies.velocity[body], h_);
  if (!members_.varies) return;
  for (std::size_t i = 0; i < members_.bodies.size(); ++i) {
    const std::uint32_t body = members_.bodies[i];
    bodies.pose[body] = step_->motion[body].from(step_->start[body]);
    // What constraints give after the drift is about what they gave before.
    step_->held[body].v = bodies.velocity[body].v + (bodies.velocity[body].v - before_[i].v);
    step_->held[body].w = bodies.velocity[body].w + (bodies.velocity[body].w - before_[i].w);
    step_->later[body].v = step_->held[body].v + h_ / 2 * step_->acceleration[body].v;
    step_->later[body].w = step_->held[body].w + h_ / 2 * step_->acceleration[body].w;
  }
  step_->data.forces.accelerations(bodies, members_.bodies, members_.pulls, h_ / 2, step_->held, step_->later,
                                   step_->acceleration);
}

/// Impulses after the drift, so that what pushes no longer approaches, and joints stay as they are.
void DirectIsland::relax() {
  std::vector<Velocity>& velocity = step_->data.bodies.velocity;
  system_.clear();
  joint_rows_.clear();
  for (DirectContact& contact : contacts_) {
    const std::array<Vec2, 2> given = contact.impulse;
    list_contact(contact, contact.frame, true);
    Real load = 0;
    Real rubs = 0;
    for (std::size_t i = 0; i < contact.count; ++i) {
      Constraint& row = system_[contact.row[i]];
      row.impulse = row.given = given[i].x;
      load += given[i].x;
      rubs += given[i].y;
      // What does not touch yet takes no part.
      const bool near_by = contact.frame.points[i].separation <= touching;
      const bool blow = ConstraintSystem::speed(row, velocity) < -slow_;
      if (given[i].x == 0 && (!near_by || blow)) row.mass_a = row.mass_b = {};
    }
    if (contact.friction_row != ~std::uint32_t{0}) system_[contact.friction_row].impulse = system_[contact.friction_row].given = rubs;
  }
  for (ActiveJoint* joint : members_.joints) {
    const std::size_t first = system_.all().size();
    list_joint(joint->block);
    std::size_t at = first;
    for_each_row(joint->block, [&](const JointRow& row) {
      system_[at].impulse = system_[at].given = row.impulse;
      ++at;
    });
    for (std::size_t i = 0; i < static_cast<std::size_t>(joint->block.stops); ++i) {
      Constraint& row = system_[first + static_cast<std::size_t>(joint->block.equations) + i];
      if (joint->block.stop[i].error > touching && row.impulse == 0) row.mass_a = row.mass_b = {};
    }
    if (joint->block.driven) {
      system_[system_.all().size() - 1].most = h_ * joint->block.motor_strength;
      system_[system_.all().size() - 1].bias = -joint->block.motor_speed;
    }
  }
  const bool ok = system_.solve(velocity);
  if (getenv("DBG") && !ok) fprintf(stderr, "relax fails: %zu rows\n", system_.all().size());
  if (stick_or_slip()) system_.solve(velocity);
  read_impulses(false);
}

void DirectIsland::substep() {
  BodySet& bodies = step_->data.bodies;
  refresh();
  Real fastest = 0;
  for (const std::uint32_t body : members_.bodies) fastest = std::max(fastest, length(step_->acceleration[body].v));
  slow_ = static_cast<Real>(2.4) * fastest * h_ + static_cast<Real>(1e-4);
  resolve_blows();
  for (DirectContact& contact : contacts_) contact.frame = contact.touch.at(step_->motion[contact.a], step_->motion[contact.b]);
  for (ActiveJoint* joint : members_.joints) joint->block = ahead(*joint, 0);
  std::vector<Velocity> first;
  for (const std::uint32_t body : members_.bodies) first.push_back(bodies.velocity[body]);
  std::vector<Velocity> by_forces(members_.bodies.size());
  const auto add_forces = [&] {
    for (std::size_t i = 0; i < by_forces.size(); ++i) {
      by_forces[i].v += h_ / 2 * step_->acceleration[members_.bodies[i]].v;
      by_forces[i].w += h_ / 2 * step_->acceleration[members_.bodies[i]].w;
    }
  };
  add_forces();
  kick();
  before_.clear();
  for (const std::uint32_t body : members_.bodies) before_.push_back(bodies.velocity[body]);
  press();
  drift();
  for (DirectContact& contact : contacts_) contact.frame = contact.touch.at(step_->motion[contact.a], step_->motion[contact.b]);
  for (ActiveJoint* joint : members_.joints) joint->block = ahead(*joint, 0);
  add_forces();
  kick();
  relax();
  for (std::size_t i = 0; i < first.size(); ++i) {
    first[i].v += by_forces[i].v;
    first[i].w += by_forces[i].w;
  }
  note_loads(first);
  if (getenv("DBG4")) { Real e = 0; for (auto b : members_.bodies) { auto& m = bodies.inverse_mass[b]; auto& v = bodies.velocity; if (m.m > 0) e += dot(v[b].v, v[b].v) / (2 * m.m); if (m.i > 0) e += v[b].w * v[b].w / (2 * m.i); } fprintf(stderr, "substep energy %.9g\n", (double)e); }
}

void DirectIsland::end() {

  StepData& data = step_->data;
  const auto n = static_cast<Real>(substeps_);
  for (const DirectContact& contact : contacts_) {
    Contact& to = data.contacts[contact.contact];
    to.slips = contact.slips;
    to.offset = 0;
    std::array<Vec2, 2> total = contact.total;
    const Vec2 sum = total[0] + total[1];
    const Real effect = length(contact.acted);
    const Real all = length(sum);
    if (all > 0 && effect > 0) {
      // Impulses along a turning normal, as along one.
      for (Vec2& each : total) each = (effect / all) * each;
      const Vec2 normal = normalized(Rotation(sum.x, sum.y).inverse() * contact.acted);
      if (length(normal - to.normal) > 64 * std::numeric_limits<Real>::epsilon()) {
        to.normal = normal;
        to.found_a.p = to.found_b.p = Vec2{1, 1} * std::numeric_limits<Real>::infinity();
      }
    }
    for (std::size_t i = 0; i < contact.count; ++i) {
      ContactPoint& p = to.points[i];
      p.normal_impulse = n * contact.impulse[i].x;
      p.tangent_impulse = n * contact.impulse[i].y;
      p.total_normal_impulse = total[i].x;
      p.total_tangent_impulse = total[i].y;
    }
  }
  for (ActiveJoint* joint : members_.joints) {
    for_each_row(joint->block, [&](JointRow& row) { row.impulse *= n; });
  }
}

// Blows ---------------------------------------------------------------------------------------------------------------

Motion DirectIsland::flown_motion(std::uint32_t body, Real t) const {
  const Velocity& v = step_->data.bodies.velocity[body];
  const Velocity& a = step_->flight[body];
  Motion at = step_->motion[body];
  if (t == 0) return at;
  at.d += t * v.v + (t * t / 2) * a.v;
  at.turn_by(t * v.w + (t * t / 2) * a.w);
  return at;
}

Velocity DirectIsland::flown_velocity(std::uint32_t body, Real t) const {
  const Velocity& v = step_->data.bodies.velocity[body];
  const Velocity& a = step_->flight[body];
  return {v.v + t * a.v, v.w + t * a.w};
}

/// m/s, at which the gap of a point grows.
Real DirectIsland::approach(const DirectContact& contact, const TouchFrame& frame, std::size_t point, Real t) const {
  const Velocity a = flown_velocity(contact.a, t);
  const Velocity b = flown_velocity(contact.b, t);
  return dot(frame.normal, b.v - a.v) + b.w * frame.points[point].cross_b - a.w * frame.points[point].cross_a;
}

bool DirectIsland::later_event(const Event& left, const Event& right) {
  if (left.time != right.time) return left.time > right.time;
  if (left.speed != right.speed) return left.speed < right.speed;
  return left.contact > right.contact;
}

/// Schedules the first time from now on at which a point of the contact touches faster than the threshold.
///
/// The parabola through the gap now, its rate, and the gap at the end of the sub-step gives a guess; Newton's iteration on
/// the exact path refines it.
void DirectIsland::aim(std::uint32_t index, Real now) {
  const DirectContact& contact = contacts_[index];
  ++candidates_[index].aims;
  const auto frame_at = [&](Real t) { return contact.touch.at(flown_motion(contact.a, t), flown_motion(contact.b, t)); };
  const TouchFrame here = frame_at(now);
  const Real rest = h_ - now;
  const TouchFrame end = frame_at(h_);
  Event first{std::numeric_limits<Real>::infinity(), 0, index, candidates_[index].aims};
  for (std::size_t i = 0; i < contact.count; ++i) {
    const Real s = here.points[i].separation;
    const Real v = approach(contact, here, i, now);
    Real time = now;
    Real speed = -v;
    if (s > 0) {
      if (!(rest > 0)) continue;
      const Real c = 2 * (end.points[i].separation - s - v * rest) / (rest * rest);
      const Real discriminant = v * v - 2 * c * s;
      if (discriminant < 0) continue;
      const Real closing = std::sqrt(discriminant) - v;
      if (closing <= 0) continue;
      Real x = 2 * s / closing;
      if (x > 2 * rest) continue;
      constexpr int rounds = 4;
      bool parts = false;
      for (int round = 0; round < rounds && !parts; ++round) {
        const TouchFrame there = frame_at(now + x);
        const Real rate = approach(contact, there, i, now + x);
        parts = rate >= 0;
        if (!parts) x = std::max(x - there.points[i].separation / rate, Real{0});
      }
      if (parts || x > rest) continue;
      time = now + x;
      speed = -approach(contact, frame_at(time), i, time);
    }
    if (speed <= slow_) continue;
    if (time < first.time || (time == first.time && speed > first.speed)) {
      first.time = time;
      first.speed = speed;
    }
  }
  if (first.time == std::numeric_limits<Real>::infinity()) return;
  events_.push_back(first);
  std::push_heap(events_.begin(), events_.end(), later_event);
}

/// Newton's law with friction can create energy at eccentric impacts (Kane and Levinson 1985), and has no solution for
/// some (Painleve). Then the normal impulses are those without friction, and friction only removes energy.
void DirectIsland::solve_blow(std::vector<Velocity>& velocity) {
  const bool solved = system_.solve(velocity);
  if (getenv("DBG") && !solved) fprintf(stderr, "blow fails: %zu rows\n", system_.all().size());
  if (solved && !system_.drove(velocity)) return;
  for (std::size_t i = 0; i < members_.bodies.size(); ++i) velocity[members_.bodies[i]] = before_[i];
  const auto anew = [&](bool rubs) {
    for (Constraint& row : system_.all()) {
      if (!rubs) row.impulse = 0;
      row.fixed = rubs ? row.law == Law::pushes : row.law == Law::rubs;
    }
    system_.begin_anew();
    system_.solve(velocity);
  };
  anew(false);
  anew(true);
}

/// Resolves the impact of a contact at tau: velocities change there, and the start of the sub-step's path shifts so that
/// the path still passes through the bodies' places at tau.
void DirectIsland::strike(std::uint32_t index, Real tau) {
  BodySet& bodies = step_->data.bodies;
  std::vector<Velocity>& velocity = bodies.velocity;
  const bool inelastic = contacts_[index].restitution == 0;
  // Whom it concerns: bodies at the time of impact.
  before_.clear();
  for (const std::uint32_t body : members_.bodies) {
    if (bodies.pushable(body)) velocity[body] = flown_velocity(body, tau);
    before_.push_back(velocity[body]);
  }
  system_.clear();
  joint_rows_.clear();
  std::vector<std::pair<std::uint32_t, TouchFrame>> struck;
  for (std::uint32_t c = 0; c < contacts_.size(); ++c) {
    if (c != index && !inelastic) continue;
    DirectContact& contact = contacts_[c];
    Motion a = step_->motion[contact.a];
    Motion b = step_->motion[contact.b];
    const auto fly = [&](std::uint32_t body, Motion& m) {
      if (tau == 0) return;
      const std::size_t k = static_cast<std::size_t>(std::find(members_.bodies.begin(), members_.bodies.end(), body) - members_.bodies.begin());
      if (k == members_.bodies.size()) {
        m.advance(velocity[body], tau);
        return;
      }
      const Velocity& acc = step_->flight[body];
      m.d += tau * before_[k].v - (tau * tau / 2) * acc.v;
      m.turn_by(tau * before_[k].w - (tau * tau / 2) * acc.w);
    };
    fly(contact.a, a);
    fly(contact.b, b);
    const TouchFrame frame = contact.touch.at(a, b);
    const std::array<Vec2, 2> given = contact.impulse;
    const Real reach = c == index ? together : touching;
    bool any = false;
    for (std::size_t i = 0; i < contact.count; ++i) any = any || frame.points[i].separation <= reach;
    if (!any) continue;
    contact.impulse = {};
    // A point that slides when it is hit slides until friction has stopped it.
    const bool slips = contact.slips;
    Real slides = 0;
    for (std::size_t i = 0; i < contact.count; ++i) {
      const Velocity& va = velocity[contact.a];
      const Velocity& vb = velocity[contact.b];
      slides = std::max(slides, std::abs(dot(perpendicular(frame.normal), vb.v - va.v) + vb.w * frame.points[i].dot_b -
                                         va.w * frame.points[i].dot_a));
    }
    contact.slips = slides > static_cast<Real>(1e-4);
    list_contact(contact, frame, true);
    contact.slips = slips;
    contact.impulse = given;
    for (std::size_t i = 0; i < contact.count; ++i) {
      Constraint& row = system_[contact.row[i]];
      const Real v = ConstraintSystem::speed(row, velocity);
      if (frame.points[i].separation > reach) row.mass_a = row.mass_b = {};
      row.acts = v < 0;
      if (v < -slow_ || c == index) row.bias = contact.restitution * std::min(v, Real{0});
    }
    struck.emplace_back(c, frame);
  }
  std::vector<JointBlock> kept;
  for (ActiveJoint* joint : members_.joints) {
    const std::size_t first = system_.all().size();
    list_joint(joint->block);
    for (std::size_t i = 0; i < static_cast<std::size_t>(joint->block.stops); ++i) {
      Constraint& row = system_[first + static_cast<std::size_t>(joint->block.equations) + i];
      if (joint->block.stop[i].error > touching) row.mass_a = row.mass_b = {};
    }
    if (joint->block.driven) system_[system_.all().size() - 1].most = 0;
  }
  const auto energy = [&] { Real e = 0; for (auto b : members_.bodies) { auto& m = bodies.inverse_mass[b]; if (m.m > 0) e += dot(velocity[b].v, velocity[b].v) / (2 * m.m); if (m.i > 0) e += velocity[b].w * velocity[b].w / (2 * m.i); } return e; };
  const Real e0 = energy();
  solve_blow(velocity);
  if (getenv("DBG4")) { fprintf(stderr, "blow tau %.6g contact %u energy %.9g -> %.9g:", (double)tau, index, (double)e0, (double)energy()); for (auto& r : system_.all()) fprintf(stderr, " [%d j %.6g w %.6g b %.6g]", (int)r.law, (double)r.impulse, (double)ConstraintSystem::speed(r, velocity), (double)r.bias); fprintf(stderr, "\n"); }
  for (const auto& [c, frame] : struck) {
    DirectContact& contact = contacts_[c];
    Real load = 0;
    for (std::size_t i = 0; i < contact.count; ++i) load += system_[contact.row[i]].impulse;
    const Real friction = contact.friction_row == ~std::uint32_t{0} ? Real{0} : system_[contact.friction_row].impulse;
    for (std::size_t i = 0; i < contact.count; ++i) {
      const Real normal = system_[contact.row[i]].impulse;
      note(contact, i, {normal, load > 0 ? friction * (normal / load) : Real{0}}, frame.normal);
    }
  }
  for (std::size_t i = 0; i < members_.bodies.size(); ++i) {
    const std::uint32_t body = members_.bodies[i];
    if (!bodies.pushable(body)) continue;
    Velocity& v = velocity[body];
    step_->motion[body].d -= tau * (v.v - before_[i].v);
    step_->motion[body].turn_by(-tau * (v.w - before_[i].w));
    v.v -= tau * step_->flight[body].v;
    v.w -= tau * step_->flight[body].w;
  }
}

void DirectIsland::resolve_blows() {
  candidates_.assign(contacts_.size(), {});
  events_.clear();
  for (std::uint32_t c = 0; c < contacts_.size(); ++c) aim(c, 0);
  const std::size_t most = 64 + 16 * contacts_.size();
  std::size_t count = 0;
  std::size_t elastic = 0;
  while (count < most && elastic < 5000 && !events_.empty()) {
    std::pop_heap(events_.begin(), events_.end(), later_event);
    const Event next = events_.back();
    events_.pop_back();
    if (next.aims != candidates_[next.contact].aims) continue;
    DirectContact& hit = contacts_[next.contact];
    ++(hit.restitution < 1 ? count : elastic);
    if (find(hit, flown_motion(hit.a, next.time), flown_motion(hit.b, next.time))) {
      aim(next.contact, next.time);
      continue;
    }
    strike(next.contact, next.time);
    const bool all = hit.restitution == 0 || !members_.joints.empty();
    for (std::uint32_t c = 0; c < contacts_.size(); ++c) {
      const DirectContact& other = contacts_[c];
      const auto moves = [&](std::uint32_t body) { return step_->data.bodies.pushable(body); };
      const auto shares = [&](std::uint32_t body) { return moves(body) && (body == hit.a || body == hit.b); };
      if (all || shares(other.a) || shares(other.b)) aim(c, next.time);
    }
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
