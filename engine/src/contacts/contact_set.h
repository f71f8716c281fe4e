#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "contacts/contact.h"
#include "contacts/contact_search.h"
#include "impulse/settings.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The contacts of a world from step to step.
class ContactSet {
 public:
  /// Finds what touches, or will within the margin; contacts that were there before keep their impulses and age.
  ///
  /// With `recycle`, a contact whose bodies hardly moved since its points were found keeps normal and arms as they were
  /// and only measures its separations anew. That is stability, not thrift: arms that turn with every tremor make the
  /// stiffness of a stack depend on its lean, and a tall one buckles.
  void find(const SearchInput& input);

  /// Forgets what the last search found for the first time, so that another before the step finds it new again.
  void forget_new();
  /// See ContactSearch.
  std::span<const std::uint32_t> struck_piles() const { return search_.struck_piles(); }

  /// Forgets the contacts of a body.
  void forget(std::size_t body);

  /// Of bodies that are awake. Sorted by (body_a, body_b, part_a, part_b).
  std::vector<Contact>& rows() { return rows_; }
  const std::vector<Contact>& rows() const { return rows_; }

  /// Not 0, and another number whenever rows came or went or have other numbers of points or other materials.
  std::uint64_t changes() const { return changes_; }

  /// Of bodies asleep, as their last step left them; sorted likewise. Solvers don't see them.
  std::span<const Contact> resting() const { return resting_; }
  /// Steps last so many times as long from now on: what carries the sleepers in one of them does, too.
  void stretch_rest(Real times);
  /// Lays aside the contacts of bodies that have fallen asleep.
  void lay_to_rest(const BodySet& bodies);
  /// Takes up again those of bodies that have woken, so that the next search finds them known.
  void take_back(const BodySet& bodies);

  /// Leaves out those that piles at rest keep now.
  void leave_to_piles(const BodySet& bodies);
  /// Takes up those that they have kept, so that the next search finds them known.
  void put_in(std::span<const Contact> contacts);

  /// Those of rows() and resting() and these in one order.
  std::vector<const Contact*> all(std::span<const Contact> more) const;

 private:
  void disturb() {
    disturbed_ = true;
    ++changes_;
  }
  void write_rows(const SearchInput& input);
  void mix_again(const BodySet& bodies, const Settings& settings);

  /// One that has a dynamic body and one that is not.
  struct OnGround {
    std::uint32_t body;  // the dynamic one
    std::uint16_t part;
    bool dynamic_first;
    std::uint32_t ground;  // the other one
    std::size_t row;
  };
  void remove_ghosts(const BodySet& bodies, const Margin& margin);
  /// Whether some contact lost all its points.
  bool remove_ghosts(std::span<const OnGround> of_part, const BodySet& bodies, const Margin& margin);

  /// The rules by which materials were mixed last.
  struct Mixing {
    FrictionMixing friction;
    RestitutionMixing restitution;
  };

  ContactSearch search_;
  std::vector<Contact> rows_;
  std::vector<Contact> last_rows_;
  std::optional<Mixing> mixed_by_;
  std::uint64_t changes_ = 1;
  bool disturbed_ = true;  // whether rows were taken out or put in since they were written
  std::vector<OnGround> on_ground_;
  std::vector<OnGround> supports_;
  std::vector<Contact> resting_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
