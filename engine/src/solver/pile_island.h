#pragma once

#include <vector>

#include "solver/island.h"
#include "solver/motion.h"
#include "solver/partition.h"
#include "solver/pile.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Whether an island under constant forces is worth the laying out in lanes, and needs nothing that these cannot do:
/// few bodies in motion are followed closely, but for discs, whose normals turn in lanes, too.
bool is_pile(const StepData& data, const Island& island);

/// Chooses sub-steps and sweeps of a pile.
void plan_pile(const StepData& data, Island& island, const std::vector<Velocity>& acceleration);
/// Those sweeps more that it may take after a blow at one of its contacts.
void relax_blows(const StepData& data, Island& island);

/// Carries a pile that was planned over a step.
void step_as_pile(StepData& data, const Partition& parts, const Island& island,
                  const std::vector<Velocity>& acceleration, std::vector<Motion>& motion, Pile& pile,
                  Pile::RowOf& row_of);

}  // namespace impulse::inline IMPULSE_PRECISION
