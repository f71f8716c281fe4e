#include "core/simd.h"
#include "solver/lanes/kernels.h"

namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

extern const ContactPasses<lane_count> contact_passes;
KickByForces kick_by_forces;
KickBodies kick_bodies;
DriftBodies drift_bodies;
TurnToAngles turn_to_angles;

namespace {

template <std::size_t width>
constexpr const ContactPasses<width>* passes_of() {
  if constexpr (width == lane_count) {
    return &contact_passes;
  } else {
    return nullptr;
  }
}

}  // namespace

extern const SolverKernels solver_table;
const SolverKernels solver_table{passes_of<8>(), passes_of<16>(), kick_by_forces,
                                 kick_bodies,    drift_bodies,    turn_to_angles};

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
