#include "joints/joint_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Inverse effective mass that two rows share.
Real coupling(const JointBlock& block, const JointRow& p, const JointRow& q) {
  return (block.mass_a.m + block.mass_b.m) * dot(p.axis, q.axis) + block.mass_a.i * p.arm_a * q.arm_a +
         block.mass_b.i * p.arm_b * q.arm_b;
}

}  // namespace

void apply(const JointBlock& block, const JointRow& row, Real impulse, Velocity& a, Velocity& b) {
  // What cannot be pushed is not written: it may belong to other islands too.
  if (block.mass_a.m + block.mass_a.i > 0) {
    a.v -= block.mass_a.m * impulse * row.axis;
    a.w -= block.mass_a.i * impulse * row.arm_a;
  }
  if (block.mass_b.m + block.mass_b.i > 0) {
    b.v += block.mass_b.m * impulse * row.axis;
    b.w += block.mass_b.i * impulse * row.arm_b;
  }
}

Real rate(const JointRow& row, const Velocity& a, const Velocity& b) {
  return dot(row.axis, b.v - a.v) + row.arm_b * b.w - row.arm_a * a.w;
}

void solve_equations(JointBlock& block, const std::array<Real, 3>& bias, Velocity& a, Velocity& b,
                     const Softness& soft) {
  const auto n = static_cast<std::size_t>(block.equations);
  std::array<std::array<Real, 3>, 3> k{};
  std::array<Real, 3> x{};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) k[i][j] = coupling(block, block.equation[i], block.equation[j]);
    x[i] = -(rate(block.equation[i], a, b) + bias[i]);
  }
  // K is symmetric and positive semidefinite: elimination needs no pivoting; a row that moves nothing is left out.
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n && k[i][i] > 0; ++j) {
      const Real factor = k[j][i] / k[i][i];
      for (std::size_t c = i; c < n; ++c) k[j][c] -= factor * k[i][c];
      x[j] -= factor * x[i];
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t c = i + 1; c < n; ++c) x[i] -= k[i][c] * x[c];
    x[i] = k[i][i] > 0 ? x[i] / k[i][i] : Real{0};
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Real push = soft.strength * x[i] - soft.relief * block.equation[i].impulse;
    block.equation[i].impulse += push;
    apply(block, block.equation[i], push, a, b);
  }
}

void solve_stops(JointBlock& block, const std::array<Real, 2>& bias, Velocity& a, Velocity& b) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(block.stops); ++i) {
    JointRow& row = block.stop[i];
    const Real k = coupling(block, row, row);
    if (!(k > 0)) continue;
    const Real total = std::max(row.impulse - (rate(row, a, b) + bias[i]) / k, Real{0});
    apply(block, row, total - row.impulse, a, b);
    row.impulse = total;
  }
}

void solve_motor(JointBlock& block, Real h, Velocity& a, Velocity& b) {
  if (!block.driven) return;
  JointRow& row = block.motor;
  const Real k = coupling(block, row, row);
  if (!(k > 0)) return;
  const Real most = h * block.motor_strength;
  const Real total = clamp(row.impulse + (block.motor_speed - rate(row, a, b)) / k, -most, most);
  apply(block, row, total - row.impulse, a, b);
  row.impulse = total;
}

void forget_impulses(JointBlock& block) {
  for_each_row(block, [](JointRow& row) { row.impulse = 0; });
}

namespace {

/// `correction` (1/s) times an error is the speed out of it.
void solve(JointBlock& block, Real h, Real correction, const Softness& soft, BodySet& bodies) {
  Velocity& a = bodies.velocity[block.a];
  Velocity& b = bodies.velocity[block.b];
  std::array<Real, 3> bias{};
  std::array<Real, 2> stop_bias{};
  for (std::size_t i = 0; i < 3; ++i) bias[i] = correction * block.equation[i].error;
  // A stop that is still away may be reached within h, but not passed.
  for (std::size_t i = 0; i < 2; ++i) {
    const Real error = block.stop[i].error;
    stop_bias[i] = error > 0 ? error / h : correction * error;
  }
  solve_motor(block, h, a, b);
  solve_equations(block, bias, a, b, soft);
  solve_stops(block, stop_bias, a, b);
}

}  // namespace

void solve_joint(JointBlock& block, Real h, Real share, BodySet& bodies) { solve(block, h, share / h, {}, bodies); }

void solve_soft_joint(JointBlock& block, Real h, const Softness& soft, BodySet& bodies) {
  solve(block, h, soft.rate, soft, bodies);
}

void warm_start(const JointBlock& block, Real scale, Velocity& a, Velocity& b) {
  for_each_row(block, [&](const JointRow& row) { apply(block, row, scale * row.impulse, a, b); });
}

}  // namespace impulse::inline IMPULSE_PRECISION
