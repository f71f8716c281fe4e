#pragma once

#include <array>
#include <cstdint>

#include "bodies/body_set.h"
#include "solver/softness.h"

namespace impulse::inline IMPULSE_PRECISION {

/// One scalar condition between two bodies. Its error e changes at
///
///   rate = axis . (vB - vA) + arm_b wB - arm_a wA
struct JointRow {
  Vec2 axis;
  Real arm_a = 0, arm_b = 0;  // (arm x axis) in m for a length; 1 for an angle
  Real error = 0;             // m or rad
  Real impulse = 0;           // N s or N m s, accumulated
  Real half = 0;              // for solvers that give an impulse in two halves
};

/// A joint as solvers see it: up to three equations (error = 0), solved together, then up to two stops (error >= 0) and
/// a motor, one at a time.
struct JointBlock {
  std::uint32_t a = 0, b = 0;
  InverseMass mass_a, mass_b;
  int equations = 0;
  std::array<JointRow, 3> equation;
  int stops = 0;
  std::array<JointRow, 2> stop;
  bool driven = false;
  JointRow motor;
  Real motor_speed = 0;     // wanted rate
  Real motor_strength = 0;  // N or N m
};

/// Gives both bodies an impulse along a row.
void apply(const JointBlock& block, const JointRow& row, Real impulse, Velocity& a, Velocity& b);

Real rate(const JointRow& row, const Velocity& a, const Velocity& b);

/// Brings the rates of the equations to -bias[i]: K d = -(rate + bias), K the matrix of inverse effective masses; as
/// far as `soft` allows, whose own rate is not looked at.
void solve_equations(JointBlock& block, const std::array<Real, 3>& bias, Velocity& a, Velocity& b,
                     const Softness& soft = {});

/// Keeps each stop's rate at or above -bias[i]; a stop only ever pushes.
void solve_stops(JointBlock& block, const std::array<Real, 2>& bias, Velocity& a, Velocity& b);

/// Drives the rate to the motor's speed with at most strength * h.
void solve_motor(JointBlock& block, Real h, Velocity& a, Velocity& b);

/// Starts the impulses from zero.
void forget_impulses(JointBlock& block);

/// One pass over a joint for solvers that correct velocities: rates that take away `share` of the error within h.
void solve_joint(JointBlock& block, Real h, Real share, BodySet& bodies);

/// The same for a joint that gives way like a damped spring. Its stops are rigid, but no faster out of an error.
void solve_soft_joint(JointBlock& block, Real h, const Softness& soft, BodySet& bodies);

/// Gives both bodies all accumulated impulses, times `scale`.
void warm_start(const JointBlock& block, Real scale, Velocity& a, Velocity& b);

/// Calls f on every row in use.
template <class Block, class F>
void for_each_row(Block& block, F f) {
  for (int i = 0; i < block.equations; ++i) f(block.equation[static_cast<std::size_t>(i)]);
  for (int i = 0; i < block.stops; ++i) f(block.stop[static_cast<std::size_t>(i)]);
  if (block.driven) f(block.motor);
}

}  // namespace impulse::inline IMPULSE_PRECISION
