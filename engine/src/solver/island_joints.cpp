#include "solver/island_joints.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/energy_bound.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr Real slack = tolerated_joint_gap;

/// Compliance: a joint is a spring with w h = 1/sqrt(give), 1000. Its load displaces it by g h^2 give, 2e-10 m at 240
/// Hz; a taut chain's forces stay finite.
constexpr Real give = static_cast<Real>(1e-6);
/// The damping, as in Levenberg (1944), of a step towards unsatisfied joints: nothing springs back at w h = 3.
constexpr Real give_when_unfit = static_cast<Real>(0.1);

/// Multiplications for one factoring, above which joints are solved by iteration instead: nearly a millisecond, five
/// times in a step. A net of k x k discs in order takes 8.7 k^4, so that 18 x 18 are still factored (4 ms a step) and
/// 19 x 19 are not; iteration takes .1 us a hinge and sub-step. A chain's cost is proportional to its length: 10 000
/// links are factored.
constexpr std::uint64_t expensive = 1000000;

}  // namespace

IslandJoints::IslandJoints(std::span<ActiveJoint* const> joints, std::span<const std::uint32_t> members,
                           BodySet& bodies, const std::vector<Pose>& start, const std::vector<Motion>& motion,
                           JointWorkspace& work)
    : joints_(joints),
      members_(members),
      bodies_(bodies),
      start_(start),
      motion_(motion),
      work_(work),
      cost_(joints.empty() ? 0 : work.system.cost(joints, motion.size(), expensive)),
      swept_(cost_ > expensive) {}

Softness softness_of_swept(Real h) {
  constexpr Real damping_ratio = 5;
  return Softness::of(1 / (6 * h), damping_ratio, h);
}

JointPose IslandJoints::pose(std::uint32_t body, Real ahead) const {
  Motion there = motion_[body];
  if (ahead > 0) there.advance(bodies_.velocity[body], ahead);
  return {there.from(start_[body]), bodies_.angle[body] + there.turn};
}

void IslandJoints::share(Real by) {
  for (ActiveJoint* joint : joints_) {
    for_each_row(joint->block, [by](JointRow& row) { row.impulse *= by; });
  }
}

void IslandJoints::halve() {
  for (ActiveJoint* joint : joints_) {
    for_each_row(joint->block, [](JointRow& row) {
      row.half = row.impulse / 2;
      row.impulse = 0;
    });
  }
}

void IslandJoints::forget() {
  for (ActiveJoint* joint : joints_) forget_impulses(joint->block);
}

void IslandJoints::kick() {
  for (ActiveJoint* joint : joints_) {
    JointBlock& block = joint->block;
    for_each_row(block, [&](JointRow& row) {
      apply(block, row, row.half, bodies_.velocity[block.a], bodies_.velocity[block.b]);
      row.impulse += row.half;
    });
  }
}

void IslandJoints::push_halves(std::vector<Velocity>& velocities) const {
  for (const ActiveJoint* joint : joints_) {
    const JointBlock& block = joint->block;
    for_each_row(block,
                 [&](const JointRow& row) { apply(block, row, row.half, velocities[block.a], velocities[block.b]); });
  }
}

JointBlock IslandJoints::ahead(const ActiveJoint& joint, Real h) const {
  JointBlock block = joint.block;
  joint.model->write(pose(block.a, h), pose(block.b, h), block);
  return block;
}

/// The sum of the squares of the joints' errors after a drift of h. Writes the bias that would correct them if they
/// were linear, rate + bias = error / h, to the workspace.
Real IslandJoints::miss(Real h) {
  work_.bias.clear();
  Real sum = 0;
  for (const ActiveJoint* joint : joints_) {
    const JointBlock& block = joint->block;
    if (block.equations == 0) continue;
    const JointBlock there = ahead(*joint, h);
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.equations); ++i) {
      const Real error = there.equation[i].error + h * work_.system.give(work_.bias.size()) * block.equation[i].impulse;
      sum += error * error;
      work_.bias.push_back(error / h - rate(block.equation[i], bodies_.velocity[block.a], bodies_.velocity[block.b]));
    }
  }
  return sum;
}

void IslandJoints::press(Real h) {
  if (swept_) return press_by_sweep(h);
  drive_motors(h / 2);  // before the drift half of an impulse acts, as of forces
  const Real most = most_energy();
  if (fit_) {
    remember();
    fit_ = fit_by_present_rows(h) && kinetic_energy(members_, bodies_) <= most;
    if (!fit_) take_back();
  }
  if (!fit_) approach_by_rows_ahead(h, most);
  for (ActiveJoint* joint : joints_) {
    JointBlock& block = joint->block;
    if (block.stops == 0) continue;
    Velocity& a = bodies_.velocity[block.a];
    Velocity& b = bodies_.velocity[block.b];
    const JointBlock there = ahead(*joint, h);
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.stops); ++i) {
      JointRow& stop = block.stop[i];
      const Real now = rate(block.stop[i], a, b);
      drive(block, stop, now - there.stop[i].error / h, 0, std::numeric_limits<Real>::infinity());
    }
  }
}

/// Changes the impulse of a stop or motor, from `least` to `most` in total, so that its rate becomes `wanted`. The
/// equations answer at once, and their rates stay as they are: alone, a stop of a hinged rod would need an iteration
/// for each quarter of what is left. All is linear, so that one trial tells its effective mass.
void IslandJoints::drive(JointBlock& block, JointRow& row, Real wanted, Real least, Real most) {
  Velocity& a = bodies_.velocity[block.a];
  Velocity& b = bodies_.velocity[block.b];
  const Real mass = effective_mass(block, row);
  const Real change = wanted - rate(row, a, b);
  const Real trial = mass * change;
  if (clamp(row.impulse + trial, least, most) == row.impulse) return;
  work_.bias.clear();
  for (const ActiveJoint* joint : joints_) {
    const JointBlock& other = joint->block;
    for (std::size_t i = 0; i < static_cast<std::size_t>(other.equations); ++i) {
      work_.bias.push_back(-rate(other.equation[i], bodies_.velocity[other.a], bodies_.velocity[other.b]));
    }
  }
  apply(block, row, trial, a, b);
  work_.system.solve(joints_, bodies_, work_.bias);
  work_.system.push(joints_, bodies_, 1, true);
  const Real gained = change - (wanted - rate(row, a, b));
  // Less is the give of equations that hold it still.
  constexpr Real least_share = 10 * give;
  const bool moves = gained / change > least_share;
  const Real total = moves ? clamp(row.impulse + trial * (change / gained), least, most) : row.impulse;
  const Real share = (total - row.impulse) / trial;
  apply(block, row, (share - 1) * trial, a, b);
  work_.system.push(joints_, bodies_, share - 1, true);
  row.impulse = total;
}

void IslandJoints::drive_motors(Real h) {
  for (ActiveJoint* joint : joints_) {
    JointBlock& block = joint->block;
    const Real most = h * block.motor_strength;
    if (block.driven) drive(block, block.motor, block.motor_speed, -most, most);
  }
}

/// J, the limit of the energy after a press. Setting rates to zero is a projection, which removes energy; only
/// correcting errors and bending paths can add some. If the energy more than doubles, the solution jumped elsewhere.
Real IslandJoints::most_energy() const {
  constexpr Real mending = 1;  // m/s
  Real sum = 2 * kinetic_energy(members_, bodies_);
  for (const std::uint32_t body : members_) {
    const Real m = bodies_.inverse_mass[body].m;
    if (m > 0) sum += mending * mending / (2 * m);
  }
  return sum;
}

void IslandJoints::remember() {
  work_.before.clear();
  for (const ActiveJoint* joint : joints_) {
    for_each_row(joint->block, [&](const JointRow& row) { work_.before.push_back(row.impulse); });
  }
}

void IslandJoints::take_back() {
  std::size_t next = 0;
  for (ActiveJoint* joint : joints_) {
    JointBlock& block = joint->block;
    for_each_row(block, [&](JointRow& row) {
      const Real before = work_.before[next++];
      apply(block, row, before - row.impulse, bodies_.velocity[block.a], bodies_.velocity[block.b]);
      row.impulse = before;
    });
  }
}

/// The sum of squares of errors up to which the joints are satisfied: slack, and rounding this far from the origin.
Real IslandJoints::good_enough() const {
  constexpr Real rounding = 4 * std::numeric_limits<Real>::epsilon();
  Real sum = 0;
  for (const ActiveJoint* joint : joints_) {
    const JointBlock& block = joint->block;
    const Real each = slack + rounding * (length(start_[block.a].p) + length(start_[block.b].p));
    sum += static_cast<Real>(block.equations) * each * each;
  }
  return sum;
}

/// Newton's method on error(x + h v) = 0 with the matrix of the current rows. Each iteration gains a factor of about h
/// w; five are below round-off. If an iteration gains little, the joints are too taut for these rows (a force along a
/// straight chain cannot bend it): then that iteration is undone, and the remaining error decides.
bool IslandJoints::fit_by_present_rows(Real h) {
  constexpr int rounds = 5;
  constexpr Real least_gain = static_cast<Real>(.25);
  const Real enough = good_enough();
  Real left = miss(h);
  for (int round = 0; round < rounds && left > 0; ++round) {
    work_.system.solve(joints_, bodies_, work_.bias);
    work_.system.push(joints_, bodies_, 1, true);
    const Real now = miss(h);
    if (!(now <= least_gain * left || now <= enough)) {
      work_.system.push(joints_, bodies_, -1, true);
      break;
    }
    left = now;
  }
  return left <= enough;
}

/// One damped step towards error(x + h v) = 0 along the rows at the predicted poses, as in implicit Euler: these pull
/// bodies back to the joints, and remove energy where the current rows would add it.
void IslandJoints::approach_by_rows_ahead(Real h, Real most) {
  write_rows(h, give_when_unfit);
  work_.bias.clear();
  for (const ActiveJoint* joint : joints_) {
    const JointBlock& block = joint->block;
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.equations); ++i) {
      const JointRow& row = block.equation[i];
      work_.bias.push_back(row.error / h - rate(row, bodies_.velocity[block.a], bodies_.velocity[block.b]));
    }
  }
  work_.system.solve(joints_, bodies_, work_.bias);
  work_.system.push(joints_, bodies_, 1, true);
  const Real energy = kinetic_energy(members_, bodies_);
  if (energy > most) work_.system.push(joints_, bodies_, std::sqrt(most / energy) - 1, true);
}

void IslandJoints::write_rows(Real ahead, Real give_way) {
  for (ActiveJoint* joint : joints_) {
    joint->model->write(pose(joint->block.a, ahead), pose(joint->block.b, ahead), joint->block);
  }
  if (!swept_) work_.system.factor(joints_, motion_.size(), give_way);
}

void IslandJoints::write() {
  fit_ = true;
  write_rows(0, give);
}

void IslandJoints::press_by_sweep(Real h) {
  const Softness soft = softness_of_swept(h);
  const Real driven = h / 2;  // as in press()
  for (ActiveJoint* joint : joints_) solve_soft_joint(joint->block, h, driven, soft, bodies_);
}

/// In the opposite order of press, so that loads propagate both ways.
void IslandJoints::relax_by_sweep(Real h) {
  for (std::size_t i = joints_.size(); i-- > 0;) solve_joint(joints_[i]->block, h, 0, bodies_);
}

void IslandJoints::relax(Real h) {
  if (swept_) return relax_by_sweep(h);
  work_.bias.assign(work_.system.equations(), 0);
  work_.system.solve(joints_, bodies_, work_.bias);
  work_.system.push(joints_, bodies_, 1, true);
  drive_motors(h);
  for (ActiveJoint* joint : joints_) {
    JointBlock& block = joint->block;
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.stops); ++i) {
      JointRow& stop = block.stop[i];
      if (stop.error > 0 && stop.impulse == 0) continue;  // would be braked a sub-step before it arrives
      drive(block, stop, -std::max(stop.error / h, Real{0}), 0, std::numeric_limits<Real>::infinity());
    }
  }
}

void IslandJoints::absorb_impact() {
  if (swept_) {
    for (const ActiveJoint* joint : joints_) {
      JointBlock block = joint->block;
      solve_equations(block, {}, bodies_.velocity[block.a], bodies_.velocity[block.b]);
    }
    return;
  }
  // Compliance leaves a share of each solution to the next: 1e-4 where a net of 64 discs is struck at a corner.
  constexpr int most_rounds = 8;
  constexpr Real rounding = 64 * std::numeric_limits<Real>::epsilon();
  work_.bias.assign(work_.system.equations(), 0);
  Real first = 0;
  for (int round = 0; round < most_rounds; ++round) {
    work_.system.solve(joints_, bodies_, work_.bias);
    work_.system.push(joints_, bodies_, 1, false);
    const Real last = work_.system.largest();
    if (round == 0) first = last;
    if (last <= rounding * first) break;
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
