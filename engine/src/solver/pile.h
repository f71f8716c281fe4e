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

/// The contacts of a pile in lanes, as many in a batch as the kernels process at a time.
class PileLanes {
 public:
  static std::unique_ptr<PileLanes> make(const SolverKernels& kernels);
  PileLanes() = default;
  PileLanes& operator=(const PileLanes&) = delete;
  virtual ~PileLanes() = default;

  /// A copy for a copy of the contacts that were laid out, and of their colouring.
  virtual std::unique_ptr<PileLanes> copy(std::span<Contact> contacts, const Colouring& colouring) const = 0;

  /// Contacts in a batch; the colouring must have been made for this width.
  virtual std::uint32_t at_a_time() const = 0;
  /// `row_of` has the row of each body of the world that has one; `no_row` is the first unused row.
  virtual void lay_out(std::span<Contact> contacts, const BodySet& bodies, const Island& island,
                       const Colouring& colouring, const std::vector<std::uint32_t>& row_of, std::uint32_t no_row) = 0;
  // See ContactPasses.
  virtual void begin_late(const BodyRows& bodies) = 0;
  virtual void kick(const BodyRows& bodies) = 0;
  virtual void press(const BodyRows& bodies, Real h) = 0;
  virtual void relax(const BodyRows& bodies, bool again) = 0;
  virtual void meet(const BodyRows& bodies, Real slow) = 0;
  virtual bool stick_or_slip(const BodyRows& bodies, Real slow_in_web) = 0;
  virtual void settle(bool settling) = 0;
  /// Writes impulses and offsets back to the contacts that were laid out.
  virtual void store() = 0;

 protected:
  PileLanes(const PileLanes&) = default;
};

/// A large island of `accurate` without joints and restitution, solved eight or sixteen contacts at a time: the same
/// sub-step as Accurate's with two differences that cost no accuracy. Contacts are solved by colours, and bodies store
/// the velocity change by their contacts in a sub-step, so that applying half of it again needs no pass over the
/// contacts.
class Pile {
 public:
  /// The row of each body of the world, valid only while a pile is laid out or stepped. Piles that do so one after the
  /// other may share it.
  using RowOf = std::vector<std::uint32_t>;

  explicit Pile(const SolverKernels& by) : kernels_(&by), lanes_(PileLanes::make(by)) {}
  /// Copies what was kept, for a copy of the contacts passed to keep().
  Pile(const Pile& other, std::span<Contact> contacts);

  /// Lays contacts out once for many steps, those of `island.contacts`. Later steps must not include them, but all of
  /// the bodies `island.bodies`. `contacts` must stay valid and in place as long.
  void keep(std::span<Contact> contacts, const BodySet& bodies, const Partition& parts, const Island& island,
            RowOf& row_of);
  /// Writes impulses, totals of the last step and offsets back to the contacts passed to keep().
  void store_kept() { kept_->store(); }

  /// Writes velocities to the bodies, motions to `motion` (for bodies of kept contacts since keep()), impulses and
  /// offsets to the contacts.
  void step(const StepData& data, const Partition& parts, const Island& island,
            const std::vector<Velocity>& acceleration, std::vector<Motion>& motion, RowOf& row_of);

 private:
  void take_bodies(const BodySet& bodies, const Island& island, RowOf& row_of);
  void take_motions(const BodySet& bodies, const std::vector<Velocity>& acceleration);
  void give_row(std::uint32_t body, RowOf& row_of);
  void forget_rows(RowOf& row_of) const;
  /// Calls act for the contacts of this step, then for the kept ones.
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
  std::size_t kept_rows_ = 0;           // of their bodies, and an unused one
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

/// Whether laying an island under constant forces out in lanes pays, and it needs nothing that lanes do not support:
/// small islands in motion need the mid-step updates of Turning, except discs, whose normals rotate in lanes too.
bool is_pile(const StepData& data, const Island& island);

/// Chooses sub-steps and iterations of a pile.
void plan_pile(const StepData& data, const Partition& parts, Island& island, const std::vector<Velocity>& acceleration);
/// Notes whether contacts of the pile have two coefficients of friction, and then what presses them.
void rub(Island& island, const std::vector<Velocity>& acceleration);
/// Whether one of its contacts is hit.
bool is_struck(const StepData& data, const Island& island);
/// Allows extra iterations if one is.
void relax_blows(const StepData& data, Island& island);

/// Steps a pile that was planned.
void step_as_pile(StepData& data, const Partition& parts, const Island& island,
                  const std::vector<Velocity>& acceleration, std::vector<Motion>& motion, Pile& pile,
                  Pile::RowOf& row_of);

}  // namespace impulse::inline IMPULSE_PRECISION
