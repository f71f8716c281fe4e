#include "solvers/island_joints.h"

#include <algorithm>

namespace impulse::inline IMPULSE_PRECISION {

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

void IslandJoints::kick() {
  for (ActiveJoint* joint : joints_) {
    JointBlock& block = joint->block;
    for_each_row(block, [&](JointRow& row) {
      apply(block, row, row.half, bodies_.velocity[block.a], bodies_.velocity[block.b]);
      row.impulse += row.half;
    });
  }
}

JointBlock IslandJoints::ahead(const ActiveJoint& joint, Real h) const {
  JointBlock block = joint.block;
  joint.model->write(pose(block.a, h), pose(block.b, h), block);
  return block;
}

void IslandJoints::press(Real h) {
  if (joints_.empty()) return;
  for (ActiveJoint* joint : joints_) {
    JointBlock& block = joint->block;
    solve_motor(block, h, bodies_.velocity[block.a], bodies_.velocity[block.b]);
  }
  // Newton's method on error(x + h v) = 0 with the matrix of the present rows: in terms of the linear solve, a bias
  // that makes rate + bias the true error over h. Each round gains a factor of about h w; five are below round-off.
  constexpr int rounds = 5;
  for (int round = 0; round < rounds; ++round) {
    work_.bias.clear();
    for (const ActiveJoint* joint : joints_) {
      const JointBlock& block = joint->block;
      if (block.equations == 0) continue;
      const JointBlock there = ahead(*joint, h);
      for (std::size_t i = 0; i < static_cast<std::size_t>(block.equations); ++i) {
        work_.bias.push_back(there.equation[i].error / h -
                             rate(block.equation[i], bodies_.velocity[block.a], bodies_.velocity[block.b]));
      }
    }
    work_.system.solve(joints_, bodies_, work_.bias, true);
  }
  for (ActiveJoint* joint : joints_) {
    JointBlock& block = joint->block;
    if (block.stops == 0) continue;
    Velocity& a = bodies_.velocity[block.a];
    Velocity& b = bodies_.velocity[block.b];
    const JointBlock there = ahead(*joint, h);
    std::array<Real, 2> bias{};
    for (std::size_t i = 0; i < 2; ++i) bias[i] = there.stop[i].error / h - rate(block.stop[i], a, b);
    solve_stops(block, bias, a, b);
  }
}

void IslandJoints::write() {
  if (joints_.empty()) return;
  for (ActiveJoint* joint : joints_) {
    joint->model->write(pose(joint->block.a, 0), pose(joint->block.b, 0), joint->block);
  }
  work_.system.factor(joints_, motion_.size());
}

void IslandJoints::relax(Real h) {
  if (joints_.empty()) return;
  for (ActiveJoint* joint : joints_) {
    JointBlock& block = joint->block;
    Velocity& a = bodies_.velocity[block.a];
    Velocity& b = bodies_.velocity[block.b];
    std::array<Real, 2> bias{};
    for (std::size_t i = 0; i < 2; ++i) bias[i] = std::max(block.stop[i].error / h, Real{0});
    solve_motor(block, h, a, b);
    solve_stops(block, bias, a, b);
  }
  work_.bias.assign(work_.system.equations(), 0);
  work_.system.solve(joints_, bodies_, work_.bias, true);
}

void IslandJoints::absorb_impact() {
  work_.bias.assign(work_.system.equations(), 0);
  work_.system.solve(joints_, bodies_, work_.bias, false);
}

}  // namespace impulse::inline IMPULSE_PRECISION
