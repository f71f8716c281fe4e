#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "contacts/contact.h"
#include "contacts/contact_search.h"
#include "impulse/settings.h"
#include "narrow_phase/margin.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The contacts of a world from step to step.
class ContactSet {
 public:
  ContactSet() = default;
  /// Copies the contacts, not the search: it begins anew, and finds the same.
  ContactSet(const ContactSet& other)
      : rows_(other.rows_), mixed_by_(other.mixed_by_), changes_(other.changes_), resting_(other.resting_) {}
  ContactSet& operator=(const ContactSet&) = delete;

  /// Finds the contacts of shapes that touch or are within the margin; known contacts keep their impulses and age.
  ///
  /// With `persistence`, a contact whose bodies hardly moved since its points were found keeps its normal and arms, and
  /// only its separations are measured again. The reason is stability, not speed: if arms turned with every jitter, the
  /// stiffness of a stack would depend on how it leans, and a tall one would buckle.
  void find(const SearchInput& input);

  /// Shows each contact to the callback, after find(); those that it disables are removed, until the next search. What
  /// it sets holds until then, too. Throws std::invalid_argument for coefficients out of their ranges.
  void pre_solve(const BodySet& bodies, const PreSolve& callback);
  /// Whether the callback disabled the contact of two parts in this step.
  bool disabled(const Proxy& a, const Proxy& b) const;

  /// Removes the contacts that the last search added, so that another search before the step adds them again.
  void forget_new();
  /// See ContactSearch.
  std::span<const std::uint32_t> hit_piles() const { return search_.hit_piles(); }

  /// Removes the contacts of a body.
  void forget(std::size_t body);

  /// The contacts of bodies that are awake, sorted by (body_a, body_b, part_a, part_b).
  std::vector<Contact>& rows() { return rows_; }
  const std::vector<Contact>& rows() const { return rows_; }

  /// Never 0; changes whenever a contact is added or removed, or its number of points or its material changes.
  std::uint64_t changes() const { return changes_; }

  /// The contacts of bodies asleep, as their last step left them, in the same order. Solvers don't see them.
  std::span<const Contact> resting() const { return resting_; }
  /// Scales the impulses of the contacts of bodies asleep, when the length of the step changes by this factor.
  void stretch_rest(Real times);
  /// Moves the contacts of bodies that have fallen asleep to resting().
  void lay_to_rest(const BodySet& bodies);
  /// Moves the contacts of bodies that have woken back to rows(), so that the next search knows them.
  void take_back(const BodySet& bodies);

  /// Removes the contacts that piles at rest now keep: those among their bodies, and between them and bodies that
  /// cannot be pushed.
  void leave_to_piles(const BodySet& bodies);
  /// Adds contacts that piles at rest have kept, so that the next search knows them.
  void put_in(std::span<const Contact> contacts);

  /// Lists the contacts of rows(), of resting() and these, sorted.
  void all(std::span<const Contact> more, std::vector<const Contact*>& merged) const;

 private:
  void disturb() {
    disturbed_ = true;
    ++changes_;
  }
  void write_rows(const SearchInput& input);
  void mix_again(const BodySet& bodies, const Settings& settings);

  /// A contact of a dynamic body with a fixed or kinematic one.
  struct OnGround {
    std::uint32_t body;  // the dynamic one
    std::uint16_t part;
    bool dynamic_first;
    std::uint32_t ground;  // the other one
    std::size_t row;
  };
  bool goes_on(const OnGround& one, std::span<const OnGround> of_part, const BodySet& bodies) const;
  bool is_in_corner(const OnGround& one, std::span<const OnGround> of_part, const BodySet& bodies) const;
  void remove_ghosts(const BodySet& bodies, const Margin& margin);
  /// For the contacts of one part; returns whether some contact lost all its points.
  bool remove_ghosts(std::span<const OnGround> of_part, const BodySet& bodies, const Margin& margin);

  /// The mixing rules of the last search.
  struct Mixing {
    FrictionMixing friction;
    RestitutionMixing restitution;
  };

  ContactSearch search_;
  std::vector<Contact> rows_;
  std::vector<Contact> last_rows_;
  std::optional<Mixing> mixed_by_;
  std::uint64_t changes_ = 1;
  std::vector<ContactOrder> disabled_;  // by the last pre_solve(), in order
  bool disturbed_ = true;               // whether contacts were removed or added since the last search
  std::vector<OnGround> on_ground_;
  std::vector<OnGround> supports_;
  std::vector<Contact> resting_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
