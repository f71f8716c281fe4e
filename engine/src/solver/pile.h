#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "solver/colouring.h"
#include "solver/island.h"
#include "solver/lanes/kernels.h"
#include "solver/motion.h"
#include "solver/partition.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The contacts of a pile in lanes, of as many as the kernels take at a time.
class PileLanes {
 public:
  static std::unique_ptr<PileLanes> make(const SolverKernels& kernels);
  PileLanes() = default;
  PileLanes(const PileLanes&) = delete;
  PileLanes& operator=(const PileLanes&) = delete;
  virtual ~PileLanes() = default;

  /// How many contacts: the colouring must have been made for that.
  virtual std::uint32_t at_a_time() const = 0;
  /// `row_of` has the row of each body of the world that has one; `no_row` is the first row of no body.
  virtual void lay_out(std::span<Contact> contacts, const BodySet& bodies, const Island& island,
                       const Colouring& colouring, const std::vector<std::uint32_t>& row_of, std::uint32_t no_row) = 0;
  // See ContactPasses.
  virtual void begin_late(const BodyRows& bodies) = 0;
  virtual void kick(const BodyRows& bodies) = 0;
  virtual void press(const BodyRows& bodies, Real h) = 0;
  virtual void relax(const BodyRows& bodies, bool again) = 0;
  virtual void settle(bool settling) = 0;
  /// Hands impulses and offsets back to the contacts that were laid out.
  virtual void store() = 0;
};

/// A large island of `accurate` without joints and rebounds, carried over a step eight or sixteen contacts at a time:
/// the same sub-step as in accurate.cpp with two liberties that cost no accuracy. Contacts are taken by colours, and
/// bodies keep what their contacts gave them in a sub-step, so that giving half of it again needs no pass over the
/// contacts.
class Pile {
 public:
  /// Where each body of the world has its row, while a pile is laid out or carried over a step; nowhere else. Piles
  /// that do so one after the other may share it.
  using RowOf = std::vector<std::uint32_t>;

  explicit Pile(const SolverKernels& by) : kernels_(&by), lanes_(PileLanes::make(by)) {}

  /// Lays contacts out once for many steps: from now on these are the first `island.contacts`, which no step names, of
  /// the bodies `island.bodies`, all of which every step names. `contacts` must live as long, in their place.
  void keep(std::span<Contact> contacts, const BodySet& bodies, const Partition& parts, const Island& island,
            RowOf& row_of);
  /// Impulses, totals of the last step and offsets of those back into them.
  void store_kept() { kept_->store(); }

  /// Leaves velocities in the bodies, motions in `motion` (of those that are kept since they are), impulses and offsets
  /// in the contacts.
  void step(const StepData& data, const Partition& parts, const Island& island,
            const std::vector<Velocity>& acceleration, std::vector<Motion>& motion, RowOf& row_of);

 private:
  void take_bodies(const BodySet& bodies, const Island& island, RowOf& row_of);
  void take_motions(const BodySet& bodies, const std::vector<Velocity>& acceleration);
  void give_row(std::uint32_t body, RowOf& row_of);
  void forget_rows(RowOf& row_of) const;
  /// Those of this step, then those that are kept.
  template <class Act>
  void for_both(Act act) {
    act(*lanes_);
    if (kept_ != nullptr) act(*kept_);
  }
  void substep(const Island& island, bool first);
  void turn_far();
  void relax_until_bounded(const Island& island);
  void weigh(const StepData& data, const Island& island, const RowOf& row_of);
  Real kinetic_energy() const;
  Real work() const;
  void leave(const StepData& data, const Island& island, const RowOf& row_of, std::vector<Motion>& motion);

  const SolverKernels* kernels_;
  std::unique_ptr<PileLanes> lanes_;
  std::unique_ptr<PileLanes> kept_;
  Colouring kept_colouring_;
  std::size_t kept_rows_ = 0;           // of their bodies, and one of no body
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
