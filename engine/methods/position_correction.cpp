#include "methods/position_correction.h"

#include <algorithm>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr Real share = static_cast<Real>(.2);     // of the overlap beyond the slop
constexpr Real farthest = static_cast<Real>(.2);  // m, corrected at most in one iteration

/// r x n after the body has turned: (R r) x n = cos (r x n) - sin (r . n).
Real turned_cross(Real cross, Real dot, const Motion& by) { return cross + by.drop * cross - by.sine * dot; }

}  // namespace

// The velocity equations also work for displacements: from rest, with the error as bias and without accumulation.
void close_joint(const ActiveJoint& joint, const StartPoses& start, Motion& a, Motion& b) {
  JointBlock block = joint.block;
  joint.model->write({a.from(start.pose[block.a]), start.angle[block.a] + a.turn},
                     {b.from(start.pose[block.b]), start.angle[block.b] + b.turn}, block);
  std::array<Real, 3> error{};
  std::array<Real, 2> stop_error{};
  for (std::size_t i = 0; i < 3; ++i) error[i] = clamp(block.equation[i].error, -farthest, farthest);
  for (std::size_t i = 0; i < 2; ++i) {
    stop_error[i] = std::max(block.stop[i].error, -farthest);
    block.stop[i].impulse = 0;
  }
  Velocity move_a;
  Velocity move_b;
  solve_equations(block, error, move_a, move_b);
  solve_stops(block, stop_error, move_a, move_b);
  a.advance(move_a, 1);
  b.advance(move_b, 1);
}

void PositionCorrection::begin(const BodySet& bodies, const StartPoses& start) {
  motion_.assign(bodies.size(), {});
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    motion_[i].d = bodies.pose[i].p - start.pose[i].p;
    motion_[i].turn_by(bodies.angle[i] - start.angle[i]);
  }
  moved_ = motion_;
}

void PositionCorrection::part(const ContactRow& row, Real slop) {
  Motion& a = motion_[row.a];
  Motion& b = motion_[row.b];
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
    const RowPoint& p = row.points[i];
    const Real overlap = -separation(row, p, a, b) - slop;
    if (overlap <= 0) continue;
    const Real cross_a = turned_cross(p.cross_a, p.turn_a, a);
    const Real cross_b = turned_cross(p.cross_b, p.turn_b, b);
    const Real push = effective_mass(row, cross_a, cross_b) * std::min(share * overlap, farthest);
    a.d -= push * row.mass_a.m * row.normal;
    a.turn_by(-push * row.mass_a.i * cross_a);
    b.d += push * row.mass_b.m * row.normal;
    b.turn_by(push * row.mass_b.i * cross_b);
  }
}

void PositionCorrection::finish(BodySet& bodies) const {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    bodies.pose[i].p += motion_[i].d - moved_[i].d;
    if (motion_[i].turn == moved_[i].turn) continue;
    bodies.angle[i] += motion_[i].turn - moved_[i].turn;
    bodies.pose[i].q = Rotation(bodies.angle[i]);
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
