#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernels.h"
#include "solver.h"
#include "solvers/colouring.h"
#include "solvers/island.h"
#include "solvers/motion.h"
#include "solvers/partition.h"

namespace impulse::inline IMPULSE_PRECISION {

/// A large island of `accurate` without joints and rebounds, carried over a step eight contacts at a time: the same
/// sub-step as in accurate.cpp with two liberties that cost no accuracy. Contacts are taken by colours, and bodies keep
/// what their contacts gave them in a sub-step, so that giving half of it again needs no pass over the contacts.
class Pile {
 public:
  /// Leaves velocities in the bodies, motions in `motion`, impulses and offsets in the contacts.
  void step(const StepData& data, const Partition& parts, const Island& island,
            const std::vector<Velocity>& acceleration, std::vector<Motion>& motion);

 private:
  void take_bodies(const StepData& data, const Island& island, const std::vector<Velocity>& acceleration);
  void give_row(std::uint32_t body);
  void lay_out(const StepData& data, const Island& island);
  template <class Lanes>
  void fill_all(const StepData& data, const Island& island, LanesKind kind, std::vector<Lanes>& all);
  static void fetch(const std::vector<Contact>& contacts, const Slot& slot);
  template <class Lanes>
  void clear(Lanes& lanes) const;
  template <class Lanes>
  void fill(const StepData& data, const Island& island, const Slot& slot, std::size_t lane, Lanes& lanes);
  void substep(const StepData& data, const Island& island, bool first);
  void turn_far();
  void relax_until_bounded(const StepData& data, const Island& island);
  Real kinetic_energy(const StepData& data, const Island& island) const;
  Real work(const StepData& data, const Island& island) const;
  void leave(const StepData& data, const Island& island, std::vector<Motion>& motion);
  template <class Lanes>
  void store_all(const StepData& data, const Island& island, LanesKind kind, const std::vector<Lanes>& all);
  template <class Lanes>
  void store(const Island& island, const Lanes& lanes, std::size_t lane, Contact& contact);

  const Kernels* kernels_ = nullptr;
  std::vector<std::uint32_t> row_;      // of each body of the world, where it has one
  std::vector<std::uint32_t> present_;  // bodies that have a row, in order of their rows
  Colouring colouring_;
  std::uint64_t version_ = 0;     // of the partition that was coloured last
  std::uint32_t first_body_ = 0;  // of its island
  std::vector<ContactLanes<1>> one_;
  std::vector<DiscLanes> discs_;
  std::vector<ContactLanes<2>> two_;
  std::vector<ContactLanes<2>> block_;
  std::vector<Real> velocity_, before_, kick_, motion_, turn_, acceleration_;
  std::vector<Real> start_motion_, start_turn_;  // of the sub-step
  Real start_energy_ = 0;                        // J
  BodyRows rows_{};
  ContactTable table_{};
};

}  // namespace impulse::inline IMPULSE_PRECISION
