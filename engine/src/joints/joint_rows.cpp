#include "joints/joint_rows.h"

#include <algorithm>
#include <cmath>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// The entry of K, the matrix of inverse effective masses, for two rows of a joint.
Real inverse_effective_mass(const JointBlock& block, const JointRow& p, const JointRow& q) {
  return (block.inv_mass_a.m + block.inv_mass_b.m) * dot(p.axis, q.axis) + block.inv_mass_a.i * p.arm_a * q.arm_a +
         block.inv_mass_b.i * p.arm_b * q.arm_b;
}

}  // namespace

void apply(const JointBlock& block, const JointRow& row, Real impulse, Velocity& a, Velocity& b) {
  // Don't write to a body without mass: islands that other threads solve may share it.
  if (block.inv_mass_a.m + block.inv_mass_a.i > 0) {
    a.v -= block.inv_mass_a.m * impulse * row.axis;
    a.w -= block.inv_mass_a.i * impulse * row.arm_a;
  }
  if (block.inv_mass_b.m + block.inv_mass_b.i > 0) {
    b.v += block.inv_mass_b.m * impulse * row.axis;
    b.w += block.inv_mass_b.i * impulse * row.arm_b;
  }
}

Real rate(const JointRow& row, const Velocity& a, const Velocity& b) {
  return dot(row.axis, b.v - a.v) + row.arm_b * b.w - row.arm_a * a.w;
}

Real effective_mass(const JointBlock& block, const JointRow& row) {
  const Real inverse = inverse_effective_mass(block, row, row);
  return inverse > 0 ? 1 / inverse : Real{0};
}

namespace {

/// Of a joint with n equations: with their number known, the compiler keeps K in registers.
template <std::size_t n>
void solve_all(JointBlock& block, const std::array<Real, 3>& bias, Velocity& a, Velocity& b, const Softness& soft) {
  std::array<std::array<Real, n>, n> k;
  std::array<Real, n> x;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) k[i][j] = inverse_effective_mass(block, block.equation[i], block.equation[j]);
    x[i] = -(rate(block.equation[i], a, b) + bias[i]);
  }
  // K is symmetric and positive semidefinite, so elimination needs no pivoting. Rows with a zero pivot are skipped.
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
    const Real impulse = soft.mass_scale * x[i] - soft.impulse_scale * block.equation[i].impulse;
    block.equation[i].impulse += impulse;
    apply(block, block.equation[i], impulse, a, b);
  }
}

}  // namespace

void solve_equations(JointBlock& block, const std::array<Real, 3>& bias, Velocity& a, Velocity& b,
                     const Softness& soft) {
  if (block.equations == 1) solve_all<1>(block, bias, a, b, soft);
  if (block.equations == 2) solve_all<2>(block, bias, a, b, soft);
  if (block.equations == 3) solve_all<3>(block, bias, a, b, soft);
}

void solve_stops(JointBlock& block, const std::array<Real, 2>& bias, Velocity& a, Velocity& b) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(block.stops); ++i) {
    JointRow& row = block.stop[i];
    const Real k = inverse_effective_mass(block, row, row);
    if (!(k > 0)) continue;
    const Real total = std::max(row.impulse - (rate(row, a, b) + bias[i]) / k, Real{0});
    apply(block, row, total - row.impulse, a, b);
    row.impulse = total;
  }
}

void solve_motor(JointBlock& block, Real h, Velocity& a, Velocity& b) {
  if (!block.driven) return;
  JointRow& row = block.motor;
  const Real k = inverse_effective_mass(block, row, row);
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

/// Solves all rows of a joint; equations correct errors at the speed `correction` (1/s) times the error, and a motor
/// acts for `driven`, s.
void solve_rows(JointBlock& block, Real h, Real driven, Real correction, const Softness& soft, BodySet& bodies) {
  Velocity& a = bodies.velocity[block.a];
  Velocity& b = bodies.velocity[block.b];
  std::array<Real, 3> bias{};
  std::array<Real, 2> stop_bias{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(block.equations); ++i) {
    bias[i] = correction * block.equation[i].error;
  }
  // A stop not reached yet may be reached within h, but not passed.
  for (std::size_t i = 0; i < static_cast<std::size_t>(block.stops); ++i) {
    const Real error = block.stop[i].error;
    stop_bias[i] = error > 0 ? error / h : correction * error;
  }
  solve_motor(block, driven, a, b);
  solve_equations(block, bias, a, b, soft);
  solve_stops(block, stop_bias, a, b);
}

}  // namespace

void solve_joint(JointBlock& block, Real h, Real share, BodySet& bodies) {
  solve_rows(block, h, h, share / h, {}, bodies);
}

void solve_soft_joint(JointBlock& block, Real h, Real driven, const Softness& soft, BodySet& bodies) {
  solve_rows(block, h, driven, soft.bias_rate, soft, bodies);
}

void warm_start(const JointBlock& block, Real scale, Velocity& a, Velocity& b) {
  for_each_row(block, [&](const JointRow& row) { apply(block, row, scale * row.impulse, a, b); });
}

}  // namespace impulse::inline IMPULSE_PRECISION
