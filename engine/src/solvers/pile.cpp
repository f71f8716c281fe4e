#include "solvers/pile.h"

#include <limits>

#include "stages.h"

namespace impulse::inline IMPULSE_PRECISION {

void Pile::step(const StepData& data, const Partition& parts, const Island& island,
                const std::vector<Velocity>& acceleration, std::vector<Motion>& motion) {
  kernels_ = &kernels();
  take_bodies(data, island, acceleration);
  end_stage("pile: bodies");
  const std::uint32_t first = island.bodies.front();
  if (version_ != parts.version() || first_body_ != first) {
    colouring_.assign(parts, island);
    version_ = parts.version();
    first_body_ = first;
  }
  end_stage("pile: colour");
  lay_out(data, island);
  end_stage("pile: lay out");
  kernels_->weigh_contacts(table_);
  kernels_->kick_by_forces(rows_, island.h);
  kernels_->kick_by_contacts(table_, rows_);
  for (int i = 0; i < island.substeps; ++i) substep(data, island, i == 0);
  end_stage("pile: sub-steps");
  kernels_->settle_offsets(table_, island.settling);
  leave(data, island, motion);
  end_stage("pile: leave");
}

void Pile::substep(const StepData& data, const Island& island, bool first) {
  if (island.more_sweeps > 0) {
    start_energy_ = kinetic_energy(data, island);
    start_motion_ = motion_;
    start_turn_ = turn_;
  }
  kernels_->kick_bodies(rows_, first);
  kernels_->press_contacts(table_, rows_, island.h);
  if (kernels_->drift_bodies(rows_, island.h)) turn_far();
  for (int sweep = 0; sweep < island.sweeps; ++sweep) kernels_->relax_contacts(table_, rows_, sweep > 0);
  if (island.more_sweeps > 0) relax_until_bounded(data, island);
}

/// As Accurate::relax_until_bounded.
void Pile::relax_until_bounded(const StepData& data, const Island& island) {
  const Real rounding = 64 * std::numeric_limits<Real>::epsilon();
  const Real most = start_energy_ + work(data, island) + rounding * start_energy_;
  for (int sweep = 0; sweep < island.more_sweeps && kinetic_energy(data, island) > most; ++sweep) {
    kernels_->relax_contacts(table_, rows_, true);
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
