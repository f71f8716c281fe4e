#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "contacts/contact.h"
#include "solver/island.h"
#include "solver/motion.h"
#include "solver/partition.h"
#include "solver/pile.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

/// A cached static island, the part of a pile that is at rest: for many steps it keeps the contacts among its bodies,
/// and between them and bodies that stand still, laid out in lanes. These are not searched, collided, sorted or
/// coloured in that time, but solved as usual, together with contacts of other bodies that move on the pile. So moving
/// bodies cost in proportion to what they touch, not to what lies around them.
///
/// Its bodies jitter: none may move farther than `tremor` while this lasts, so that normals and arms may stay constant,
/// and bodies without a contact, separated by more than the margin, still have none.
class RestingPile {
 public:
  static constexpr Real tremor = static_cast<Real>(0.002);  // m

  /// Keeps these contacts of `island`, a pile that was planned for this step, and not the others. step() must follow.
  RestingPile(const StepData& data, const Partition& parts, const Island& island, std::vector<Tie> kept,
              std::vector<Tie> others, Pile::RowOf& row_of);

  RestingPile(const RestingPile& other);
  RestingPile& operator=(const RestingPile&) = delete;

  /// Steps the island that it belongs to, with the contacts of that island that it does not keep.
  void step(StepData& data, const Partition& parts, Island island, const std::vector<Velocity>& acceleration,
            std::vector<Motion>& motion, Pile::RowOf& row_of);

  /// The contacts that it did not keep, in the step in which it began.
  std::span<const Tie> others() const { return others_; }
  /// Whether it is still at rest and need not be rebuilt.
  bool rests() const { return rests_; }
  void begin_anew() { rests_ = false; }
  std::size_t size() const { return contacts_.size(); }
  std::span<const std::uint32_t> members() const { return members_; }
  /// Appends the contacts that it keeps, as they are now.
  void append(const BodySet& bodies, std::vector<Contact>& to);

 private:
  std::vector<std::uint32_t> members_;
  std::vector<Contact> contacts_;
  std::vector<Tie> ties_;
  std::vector<Tie> others_;
  std::vector<std::uint32_t> numbers_;    // 0, 1, 2, ... of all contacts
  std::vector<std::uint8_t> persistent_;  // of each contact, written by the kernel
  std::vector<Motion> last_;              // of the members, since all began
  Pile pile_;
  int substeps_;
  Real offset_scale_;
  bool webbed_, heap_, two_frictions_;
  int steps_ = 0;
  bool rests_ = true;
};

/// The piles of a world that are at rest. BodySet::pile is the number of a body's pile, from 1 on.
class RestingPiles {
 public:
  bool empty() const { return count_ == 0; }
  /// Takes over the piles of the world that a copy was made of.
  void copy(const RestingPiles& from);

  /// Before the contact search of a step: invalidates the piles that are no longer at rest, and appends their contacts.
  void rouse(BodySet& bodies, std::vector<Contact>& to);
  /// Invalidates one pile, or all, and appends their contacts.
  void let_go(std::uint32_t pile, BodySet& bodies, std::vector<Contact>& to);
  void let_go(BodySet& bodies, std::vector<Contact>& to);
  /// Appends the contacts of all piles.
  void append(const BodySet& bodies, std::vector<Contact>& to) const;

  /// At the beginning of a step: records which bodies hardly move.
  void watch(const StepData& data);
  /// Invalidates the piles of islands that lanes no longer support, because of forces or new contacts, and adds their
  /// contacts to those of the step. Returns whether there were any.
  bool let_go_hindered(StepData& data, const Partition& parts);
  /// The pile in an island, or null.
  RestingPile* of(const BodySet& bodies, std::span<const std::uint32_t> island) const;
  /// Makes a pile at rest from the part of a planned pile that has hardly moved for long enough; null if it does not
  /// pay. May be called for different islands concurrently.
  std::unique_ptr<RestingPile> part_at_rest(const StepData& data, const Partition& parts, const Island& island,
                                            Pile::RowOf& row_of);
  /// Whether much more of an island hardly moves now than its pile keeps.
  bool may_grow(const StepData& data, const Island& island, const RestingPile& pile) const;
  /// Adds a pile made in this step.
  void add(std::unique_ptr<RestingPile> pile, BodySet& bodies);

 private:
  bool calm(const BodySet& bodies, const Tie& tie) const;

  std::vector<std::unique_ptr<RestingPile>> piles_;  // by number, from 1 on; null if invalidated
  std::size_t count_ = 0;
  int steps_ = 0;
  bool due_ = false;
  std::vector<Pose> seen_;          // of each body, at the last look
  std::vector<std::uint8_t> calm_;  // number of consecutive looks at which each body had hardly moved
};

}  // namespace impulse::inline IMPULSE_PRECISION
