#pragma once

#include "core/instruction_set.h"
#include "solver/lanes/contact_lanes.h"
#include "solver/lanes/rotations.h"

namespace impulse::inline IMPULSE_PRECISION {

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
