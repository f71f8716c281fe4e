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

/// What of a pile is at rest: for many steps it keeps the contacts among its bodies, and between them and what stands
/// still, laid out in lanes. Nobody looks for these meanwhile, nor collides, sorts or colours them; they are solved as
/// ever, together with contacts of other bodies that move on the pile. So what moves costs what it touches, and not
/// what lies around it. (The quiet path of fast engines; here of a part of a pile.)
///
/// Its bodies tremble: none may come farther than `tremor` while this lasts, so that normals and arms may stay, and
/// whoever had no contact, with a gap greater than the margin of contacts, still has none.
class RestingPile {
 public:
  static constexpr Real tremor = static_cast<Real>(0.002);  // m

  /// Of `island`, a pile that was planned for this step, those ties, and not the others. The step must follow.
  RestingPile(const StepData& data, const Partition& parts, const Island& island, std::vector<Tie> kept,
              std::vector<Tie> others, Pile::RowOf& row_of);

  /// Carries an island that it belongs to over a step, with the contacts of that island that it does not keep.
  void step(StepData& data, const Partition& parts, Island island, const std::vector<Velocity>& acceleration,
            std::vector<Motion>& motion, Pile::RowOf& row_of);

  /// Those that it did not keep in the step in which it began.
  std::span<const Tie> others() const { return others_; }
  /// Whether it still is at rest, and is not to begin anew.
  bool rests() const { return rests_; }
  void begin_anew() { rests_ = false; }
  std::size_t size() const { return contacts_.size(); }
  std::span<const std::uint32_t> members() const { return members_; }
  /// The contacts that it keeps, as they are now.
  std::vector<Contact> contacts(const BodySet& bodies);

 private:
  std::vector<std::uint32_t> members_;
  std::vector<Contact> contacts_;
  std::vector<Tie> ties_;
  std::vector<Tie> others_;
  std::vector<Motion> last_;  // of the members, since all began
  Pile pile_;
  int substeps_;
  Real offset_scale_;
  bool webbed_, heap_;
  int steps_ = 0;
  bool rests_ = true;
};

/// The piles of a world that are at rest. BodySet::pile tells of which a body is, from 1 on.
class RestingPiles {
 public:
  bool empty() const { return count_ == 0; }

  /// Before the search of a step: lets go of those that do not rest any more, and appends their contacts.
  void rouse(BodySet& bodies, std::vector<Contact>& to);
  /// Lets go of one, of all.
  void let_go(std::uint32_t pile, BodySet& bodies, std::vector<Contact>& to);
  void let_go(BodySet& bodies, std::vector<Contact>& to);
  /// Appends the contacts that all keep.
  void append(const BodySet& bodies, std::vector<Contact>& to) const;

  /// At the beginning of a step: takes note of what is calm.
  void watch(const StepData& data, bool forces_vary);
  /// Of islands that lanes cannot carry any more, by forces or by what has come to them since, lets go; and puts the
  /// contacts among those of the step. Whether there were any.
  bool let_go_hindered(StepData& data, const Partition& parts, bool forces_vary);
  /// The pile that an island holds, or nothing.
  RestingPile* of(const BodySet& bodies, std::span<const std::uint32_t> island) const;
  /// Of a pile that was planned for this step, what has been calm for long enough and is worth it; or nothing.
  /// Different islands may ask at once.
  std::unique_ptr<RestingPile> part_at_rest(const StepData& data, const Partition& parts, const Island& island,
                                            Pile::RowOf& row_of);
  /// Whether much more of an island is calm by now than its pile keeps.
  bool may_grow(const StepData& data, const Island& island, const RestingPile& pile) const;
  /// Those that began in this step.
  void add(std::unique_ptr<RestingPile> pile, BodySet& bodies);

 private:
  bool calm(const BodySet& bodies, const Tie& tie) const;

  std::vector<std::unique_ptr<RestingPile>> piles_;  // by number, from 1 on; nothing where it was let go
  std::size_t count_ = 0;
  int steps_ = 0;
  bool due_ = false;
  std::vector<Pose> seen_;          // of each body, when it was last looked at
  std::vector<std::uint8_t> calm_;  // how often in turn each had hardly moved since
};

}  // namespace impulse::inline IMPULSE_PRECISION
