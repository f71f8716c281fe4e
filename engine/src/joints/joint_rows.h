#pragma once

#include <array>
#include <cstdint>

#include "bodies/body_set.h"
#include "core/softness.h"

namespace impulse::inline IMPULSE_PRECISION {

/// One scalar constraint between two bodies. Its error changes at
///
///   rate = axis . (vB - vA) + arm_b wB - arm_a wA
struct JointRow {
  Vec2 axis;
  Real arm_a = 0, arm_b = 0;  // (arm x axis) in m for a length; 1 for an angle
  Real error = 0;             // m or rad
  Real impulse = 0;           // N s or N m s, accumulated
  Real half = 0;              // N s or N m s, for solvers that warm start in two halves
};

/// A joint as solvers see it: up to three equations (error = 0), solved together; up to two stops (error >= 0) and a
/// motor, each solved by itself.
struct JointBlock {
  std::uint32_t a = 0, b = 0;
  InverseMass inv_mass_a, inv_mass_b;
  int equations = 0, stops = 0;
  bool driven = false;
  std::array<JointRow, 3> equation;
  std::array<JointRow, 2> stop;
  JointRow motor;
  Real motor_speed = 0;     // m/s or rad/s, target rate
  Real motor_strength = 0;  // N or N m, maximum
};

/// Applies an impulse along a row to both bodies.
void apply(const JointBlock& block, const JointRow& row, Real impulse, Velocity& a, Velocity& b);

/// The rate of change of the row's error, m/s or rad/s.
Real rate(const JointRow& row, const Velocity& a, const Velocity& b);

/// kg or kg m^2, the effective mass of a row alone; 0 if neither body can move.
Real effective_mass(const JointBlock& block, const JointRow& row);

/// Changes the rates of the equations to -bias[i] by solving K d = -(rate + bias), with K the matrix of inverse
/// effective masses, and scales the impulses d by `soft`. Ignores the bias rate of `soft`.
void solve_equations(JointBlock& block, const std::array<Real, 3>& bias, Velocity& a, Velocity& b,
                     const Softness& soft = {});

/// Keeps each stop's rate at or above -bias[i]; stops only push.
void solve_stops(JointBlock& block, const std::array<Real, 2>& bias, Velocity& a, Velocity& b);

/// Drives the rate to the motor's speed with an impulse of at most strength * h.
void solve_motor(JointBlock& block, Real h, Velocity& a, Velocity& b);

/// Sets all accumulated impulses to zero.
void forget_impulses(JointBlock& block);

/// One iteration over a joint at velocity level: corrects `share` of the error within h.
void solve_joint(JointBlock& block, Real h, Real share, BodySet& bodies);

/// The same for a soft joint, whose motor acts for `driven`, s. Its stops are rigid, but correct errors no faster than
/// the soft equations.
void solve_soft_joint(JointBlock& block, Real h, Real driven, const Softness& soft, BodySet& bodies);

/// Applies all accumulated impulses, times `scale`, to both bodies.
void warm_start(const JointBlock& block, Real scale, Velocity& a, Velocity& b);

/// Calls f on every row in use.
template <class Block, class F>
void for_each_row(Block& block, F f) {
  for (int i = 0; i < block.equations; ++i) f(block.equation[static_cast<std::size_t>(i)]);
  for (int i = 0; i < block.stops; ++i) f(block.stop[static_cast<std::size_t>(i)]);
  if (block.driven) f(block.motor);
}

}  // namespace impulse::inline IMPULSE_PRECISION
