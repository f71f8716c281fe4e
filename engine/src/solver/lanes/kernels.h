#pragma once

#include "core/instruction_set.h"
#include "solver/lanes/contact_lanes.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The most angles in one register.
constexpr std::uint32_t most_angles_at_once = 16;

/// Cosines and sines of `count` angles, with the bits of sin_cos. Whole registers are read and written: the arrays need
/// room up to a multiple of most_angles_at_once.
using TurnToAngles = void(const Real* angles, std::uint32_t count, Real* cosines, Real* sines);

/// The kernels of the solver: those that solve piles, and rotations.
struct SolverKernels {
  // One of these two is null.
  const ContactPasses<8>* contacts_by_eight;
  const ContactPasses<16>* contacts_by_sixteen;
  KickByForces* kick_by_forces;
  KickBodies* kick_bodies;
  DriftBodies* drift_bodies;
  TurnToAngles* turn_to_angles;
};
const SolverKernels& solver_kernels(InstructionSet set = fastest_instruction_set());

}  // namespace impulse::inline IMPULSE_PRECISION
