// Positions follow velocities.
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "reports/judge/groups.h"
#include "reports/judge/invariant.h"
#include "reports/judge/joint_geometry.h"
#include "reports/judge/mechanics.h"
#include "reports/judge/neighbours.h"
#include "reports/judge/rounding.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/vec.h"

// A step moves a body by dx = int v dt. Whether a method takes the velocity of the step's start (explicit Euler), of
// its end (symplectic Euler), or a mean of both, and even if an impact within the step changes it, dx/dt lies between
// the velocities before and after. The check measures by how far it lies outside, times dt. Rotation likewise, times
// the radius of gyration k. The tolerance covers:
// - forces that change within the step, by F (see AppliedForces::change_in): with all bodies of a group of joints or
//   contacts, they may take an impulse of F dt. Its energy is (F dt)^2/2m, and whichever of the group gets it moves by
//   sqrt(sum (F dt)^2/(m m_i)) dt; torques likewise;
// - joints: each of a group may be off at the start or at the end by what is measured and by the stated slop, and by
//   moving along the tangents; putting that right moves the group's bodies. A limit stops them that a step would pass
//   at the velocities of its start, or those a step later by the forces then, which also swing bodies about a hinge
//   (see JointGeometry::swung_by), as its motor does. A body on a path gets another velocity at the start of a step, by
//   c, and what joints attach to it gets at most the energy m c^2/2, m the group's mass, that takes it along. With that
//   at once, the mean is off by half of it: sqrt(m c^2/m_i) dt/2;
// - motors that reach their speed within the step, or lose it, as an impact may make them: their force changes by up to
//   twice their strength S. An impulse of 2 S dt/8 counts as that of a force that changes;
// - contacts, in a group of bodies that may touch by their shapes (see Neighbours). What closes a gap at the speed c
//   may overlap by c dt before it is noticed, and that, the overlap at the start and the stated gap are pushed out.
//   Energy m c^2/2, m the reduced mass of the two with all that joints hold to each, may pass through a body within the
//   step: sqrt(sum m c^2/m_i) dt. Forces may
//   move it by F/m dt^2 on the way there, and torques by T/(m k) dt^2, whatever it hangs from. At the contact a
//   correction by C turns a body by at most C/2k (of r/(k^2 + r^2), the largest is 1/2k), which is C/2 in k dw;
// - a rotation that goes along its tangent, by atan(w h) in a sub-step: (w h)^2/3 of the turn is missing;
// - the rounding of positions and velocities: of the largest position so far, as one near the origin may be the
//   difference of such.
namespace plumb::invariants::displacement {
namespace {

// How far x lies from the segment between a and b.
double outside(Vec x, Vec a, Vec b) {
  const Vec edge = b - a;
  const double square = dot(edge, edge);
  const double share = square == 0 ? 0 : std::clamp(dot(x - a, edge) / square, 0.0, 1.0);
  return length(x - a - share * edge);
}

// The gap of two convex shapes is a convex function of a straight path, so it closes fastest at the beginning; bodies
// that pass through each other within the step show it there only.
constexpr double beginning = 1e-3;

// What may move the bodies of a group beyond their velocities.
struct Push {
  double correction = 0;  // m
  double energy = 0;      // J, twice, of impacts and of bodies on paths
  double forced = 0;      // J, twice, of changes of forces
  bool touched = false;
};

class Displacement {
 public:
  explicit Displacement(const InvariantContext& context)
      : context_(context),
        forces_(context.scene),
        joints_(context.scene),
        overlap_(context.scene),
        joined_mass_(context.scene.bodies.size()),
        farthest_(context.scene.bodies.size()) {
    Groups joined(joined_mass_.size());
    for (std::size_t joint = 0; joint < joints_.size(); ++joint) {
      const auto [a, b] = joints_.bodies(joint);
      if (mass(a) > 0 && mass(b) > 0) joined.join(a, b);
    }
    std::vector<double> sums(joined_mass_.size());
    for (std::size_t i = 0; i < sums.size(); ++i) sums[joined.of(i)] += mass(i);
    for (std::size_t i = 0; i < sums.size(); ++i) joined_mass_[i] = sums[joined.of(i)];
  }

  InvariantCheck check() {
    const auto& [scene, trace, stepping, neighbours] = context_;
    std::vector<Wrench> before = forces_.at(trace.states(0));
    for (std::size_t moment = 1; moment < trace.size(); ++moment) {
      std::vector<Wrench> after = forces_.at(trace.states(moment));
      Groups groups(scene.bodies.size());
      const std::vector<Push> pushes = pushes_in(moment, groups, before);
      for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        add(moment, i, pushes[groups.of(i)], before[i], after[i]);
      }
      before = std::move(after);
    }
    return worst_.result();
  }

 private:
  double mass(std::size_t body) const { return forces_.masses()[body].mass; }

  // By the index of the group.
  std::vector<Push> pushes_in(std::size_t moment, Groups& groups, std::span<const Wrench> forces) const {
    const auto& [scene, trace, stepping, neighbours] = context_;
    const double dt = trace.time(moment) - trace.time(moment - 1);
    const auto then = trace.states(moment - 1);
    const auto now = trace.states(moment);
    const std::span<const BodyGap> near = neighbours.in_step(moment);
    const auto join = [&](std::size_t a, std::size_t b) {
      if (mass(a) > 0 && mass(b) > 0) groups.join(a, b);
    };
    const auto group_of = [&](std::size_t a, std::size_t b) { return groups.of(mass(a) > 0 ? a : b); };
    for (const BodyGap& pair : near) join(pair.a, pair.b);
    for (std::size_t joint = 0; joint < joints_.size(); ++joint) {
      join(joints_.bodies(joint).first, joints_.bodies(joint).second);
    }
    std::vector<Push> pushes(then.size());
    std::vector<double> group_mass(then.size());
    for (std::size_t i = 0; i < then.size(); ++i) group_mass[groups.of(i)] += mass(i);
    const auto inverse_of = [&](std::size_t body) { return mass(body) > 0 ? 1 / joined_mass_[body] : 0; };
    const std::vector<WrenchError> changes = forces_.change_in(then, now, dt);
    for (std::size_t i = 0; i < then.size(); ++i) {
      const auto& [of_mass, inertia, center] = forces_.masses()[i];
      const double impulse = dt * changes[i].force;
      const double turn = dt * changes[i].torque;
      if (of_mass > 0) pushes[groups.of(i)].forced += impulse * impulse / of_mass;
      if (inertia > 0) pushes[groups.of(i)].forced += turn * turn / inertia;
    }
    std::vector<BodyState> hurried(then.begin(), then.end());  // by the forces of the step's start
    for (std::size_t i = 0; i < hurried.size(); ++i) {
      const Mass& of = forces_.masses()[i];
      if (of.mass > 0) hurried[i].velocity = hurried[i].velocity + dt / of.mass * forces[i].force;
      if (of.inertia > 0) hurried[i].angular_velocity += dt / of.inertia * forces[i].torque;
    }
    const std::vector<BodyState> ahead = moved_on(then, dt);
    const std::vector<BodyState> at_first = moved_on(then, beginning * dt);
    Overlap::Gaps gaps = overlap_.gaps(then);
    Overlap::Gaps gaps_ahead = overlap_.gaps(ahead);
    Overlap::Gaps gaps_at_first = overlap_.gaps(at_first);
    for (const BodyGap& pair : near) {
      Push& push = pushes[group_of(pair.a, pair.b)];
      const bool whole = scene.bodies[pair.a].shapes.size() == 1 && scene.bodies[pair.b].shapes.size() == 1;
      const double gap = whole ? pair.gap : gaps.between(pair.a, pair.b);
      const double closed = std::max(
          {0.0, gap - gaps_ahead.between(pair.a, pair.b), (gap - gaps_at_first.between(pair.a, pair.b)) / beginning});
      push.correction += stepping.contact_gap() + std::max(0.0, -gap) + closed;
      push.energy += closed / dt * (closed / dt) / (inverse_of(pair.a) + inverse_of(pair.b));
      push.touched = true;
    }
    for (std::size_t joint = 0; joint < joints_.size(); ++joint) {
      const auto [a, b] = joints_.bodies(joint);
      if (mass(a) == 0 && mass(b) == 0) continue;
      pushes[group_of(a, b)].correction += stepping.joint_slop + joints_.error(joint, then) +
                                           joints_.error(joint, now) + joints_.linearisation(joint, then, dt) +
                                           joints_.linearisation(joint, now, dt);
      double carried = 0;  // m/s^2
      for (const std::size_t carrier : {a, b}) {
        if (!scene.bodies[carrier].path) continue;
        const Vec jump = now[carrier].velocity - then[carrier].velocity;
        pushes[group_of(a, b)].energy += group_mass[group_of(a, b)] * dot(jump, jump) / 4;
        carried += length(jump) / dt;
      }
      // In the frame of a body on a path, its acceleration is a force on the other.
      const auto felt = [&](std::size_t body) { return length(forces[body].force) + mass(body) * carried; };
      const double spin = dt * joints_.swung_by(joint, felt(a), felt(b)) + joints_.driven_by(joint, hurried, dt);
      const double stopped =
          std::max({joints_.passes_limits(joint, then, dt), joints_.passes_limits(joint, hurried, dt, spin),
                    joints_.passes_limits(joint, hurried, dt, -spin)});
      if (stopped > 0) {
        pushes[group_of(a, b)].correction += stopped;
        pushes[group_of(a, b)].touched = true;
      }
    }
    for (std::size_t joint = 0; joint < joints_.size(); ++joint) {
      const auto [a, b] = joints_.bodies(joint);
      Push& push = pushes[group_of(a, b)];
      // Velocities that change at two rates, R apart, are off from the mean by R dt/8 at most.
      if (push.touched || joints_.switches(joint, then, now)) push.forced += joints_.drive(joint, dt) / 16;
    }
    return pushes;
  }

  void add(std::size_t moment, std::size_t body, const Push& push, const Wrench& before, const Wrench& after) {
    const auto& [scene, trace, stepping, neighbours] = context_;
    const double dt = trace.time(moment) - trace.time(moment - 1);
    const BodyState& then = trace.states(moment - 1)[body];
    const BodyState& now = trace.states(moment)[body];
    const Mass& of = forces_.masses()[body];
    const double gyration = of.inertia > 0 ? std::sqrt(of.inertia / of.mass) : 0;
    const double off = outside(now.position - then.position, dt * then.velocity, dt * now.velocity);
    const auto [low, high] = std::minmax(then.angular_velocity, now.angular_velocity);
    const double turned = now.angle - then.angle;
    const double turned_off = gyration * std::max({0.0, dt * low - turned, turned - dt * high});
    double tolerance = push.correction;
    if (of.mass > 0) {
      tolerance += dt * (std::sqrt(push.energy / of.mass) + std::sqrt(push.forced / of.mass));
      if (push.touched) {
        const double torque = std::max(std::abs(before.torque), std::abs(after.torque));
        const double force = std::max(length(before.force), length(after.force));
        tolerance += dt * dt / of.mass * (force + (gyration > 0 ? torque / gyration : 0));
      }
    }
    const double path = dt * std::max(length(then.velocity), length(now.velocity));
    const double spin = std::max(std::abs(then.angular_velocity), std::abs(now.angular_velocity));
    const double turn = dt * gyration * spin;
    if (stepping.tangent_rotation) tolerance += turn * spin * stepping.h * spin * stepping.h / 3;
    farthest_[body] = std::max({farthest_[body], length(then.position), length(now.position)});
    const double rounded =
        solver_rounding(stepping) * (farthest_[body] + path + gyration * std::abs(now.angle) + turn) +
        2 * 0x1p-53 * trace.time(moment) / dt * (path + turn);
    worst_.add(std::max(off, turned_off), tolerance + rounded, std::max(path, turn), trace.time(moment),
               [&] { return context_.scene.bodies[body].name; });
  }

  const InvariantContext& context_;
  AppliedForces forces_;
  JointGeometry joints_;
  Overlap overlap_;
  std::vector<double> joined_mass_;  // kg, of each body and all that joints hold to it
  std::vector<double> farthest_;     // m, from the origin
  WorstViolation worst_;
};

const Catalog<Invariant>::Entry entry{
    {.name = "displacement",
     .unit = "m",
     .definition = "positions follow velocities: how far a body moves or turns in a step beyond what its velocities "
                   "before and after allow",
     .check = [](const InvariantContext& context) -> std::optional<InvariantCheck> {
       return Displacement(context).check();
     }}};

}  // namespace
}  // namespace plumb::invariants::displacement
