#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "kernels.h"
#include "solver.h"
#include "solvers/colouring.h"
#include "solvers/island.h"
#include "solvers/motion.h"
#include "solvers/partition.h"
#include "solvers/pile_lanes.h"

namespace impulse::inline IMPULSE_PRECISION {

/// A large island of `accurate` without joints and rebounds, carried over a step eight or sixteen contacts at a time:
/// the same sub-step as in accurate.cpp with two liberties that cost no accuracy. Contacts are taken by colours, and
/// bodies keep what their contacts gave them in a sub-step, so that giving half of it again needs no pass over the
/// contacts.
class Pile {
 public:
  explicit Pile(const PileKernels& by) : kernels_(&by), lanes_(PileLanes::make(by)) {}

  /// Leaves velocities in the bodies, motions in `motion`, impulses and offsets in the contacts.
  void step(const StepData& data, const Partition& parts, const Island& island,
            const std::vector<Velocity>& acceleration, std::vector<Motion>& motion);

 private:
  void take_bodies(const StepData& data, const Island& island, const std::vector<Velocity>& acceleration);
  void give_row(std::uint32_t body);
  void substep(const Island& island, bool first);
  void turn_far();
  void relax_until_bounded(const Island& island);
  void weigh(const StepData& data, const Island& island);
  Real kinetic_energy() const;
  Real work() const;
  void leave(const StepData& data, const Island& island, std::vector<Motion>& motion);

  const PileKernels* kernels_;
  std::unique_ptr<PileLanes> lanes_;
  std::vector<std::uint32_t> row_;      // of each body of the world, where it has one
  std::vector<std::uint32_t> present_;  // bodies that have a row, in order of their rows
  Colouring colouring_;
  std::uint64_t version_ = 0;     // of the partition that was coloured last
  std::uint32_t first_body_ = 0;  // of its island
  std::vector<Real> velocity_, before_, kick_, motion_, turn_, acceleration_;
  std::vector<Real> start_motion_, start_turn_;  // of the sub-step
  Real start_energy_ = 0;                        // J
  std::vector<Real> mass_;                       // kg, kg, kg m^2, 0 of each row
  BodyRows rows_{};
};

}  // namespace impulse::inline IMPULSE_PRECISION
