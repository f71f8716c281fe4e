#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "broad_phase/broad_phase.h"
#include "broad_phase/neighbours.h"
#include "broad_phase/pair_order.h"
#include "broad_phase/shape_table.h"
#include "contacts/contact.h"
#include "contacts/contact_order.h"
#include "impulse/settings.h"
#include "joints/joint_set.h"
#include "narrow_phase/narrow_phase.h"
#include "solver/lanes/kernels.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

/// What a search for contacts is given (see ContactSet::find).
struct SearchInput {
  const BodySet& bodies;
  BroadPhase& broad_phase;
  const Settings& settings;
  const Margin& margin;
  bool recycle;
  const JointSet& joints;
};

/// Finds the pairs of parts that touch, or will within the margin, and their points.
class ContactSearch {
 public:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  /// `last` are the contacts that the last search ended in; the span must hold while results are read. Those that keep
  /// their points are brought up to date. `undisturbed`: none was taken out or put in since.
  void search(const SearchInput& input, std::span<Contact> last, bool undisturbed);

  /// Numbers of the pairs that have points, in order of contacts.
  std::span<const std::uint32_t> touching() const { return touching_; }
  /// Piles at rest of which a body is struck: whom it then meets was not looked for. Ascending.
  std::span<const std::uint32_t> struck_piles() const { return struck_piles_; }
  /// Whether these are the contacts of `last`, no more and no less.
  bool found_the_same() const { return found_the_same_; }
  const Proxy& first(std::uint32_t pair) const { return shapes_.proxies()[pairs_[pair].first]; }
  const Proxy& second(std::uint32_t pair) const { return shapes_.proxies()[pairs_[pair].second]; }
  const Part& first_part(std::uint32_t pair) const { return shapes_.part(pairs_[pair].first); }
  const Part& second_part(std::uint32_t pair) const { return shapes_.part(pairs_[pair].second); }
  /// The place of the pair's contact in `last`, or none.
  std::uint32_t last_of(std::uint32_t pair) const { return last_of_[pair]; }
  /// Whether that contact's points stay; then points() says nothing.
  bool keeps(std::uint32_t pair) const { return counts_[pair] == kept; }
  const PairPoints& points(std::uint32_t pair) const { return found_[pair]; }

 private:
  static constexpr std::int8_t kept = -1;  // instead of a count of points

  void put_in_order(const SearchInput& input, std::vector<Pair>& pairs);
  void match(bool undisturbed);
  std::uint32_t find_last(const ContactOrder& wanted, std::uint32_t& place) const;
  void find_points(const SearchInput& input, std::span<const std::uint32_t> of_pairs);
  void keep_points(const SearchInput& input, std::span<const std::uint32_t> of_pairs);
  void note_motion(const SearchInput& input, bool undisturbed);
  bool foresee_knocks(const SearchInput& input);
  void reach_farther(const SearchInput& input);
  bool may_gain_points(std::uint32_t pair) const;
  void list_touching(std::span<const std::uint32_t> in_order);
  bool touching_are_last() const;
  ContactOrder order_of(const Pair& pair) const {
    return {shapes_.proxies()[pair.first], shapes_.proxies()[pair.second]};
  }

  /// In order of contacts. Proxies are in order of (body, part) themselves, so that only the parts of one first body
  /// make a difference.
  bool before(const Pair& left, const Pair& right) const {
    const auto body = [this](std::uint32_t i) { return shapes_.proxies()[i].body; };
    const bool plain = !shapes_.several_parts() || left.first == right.first || body(left.first) != body(right.first);
    return plain ? left < right : order_of(left) < order_of(right);
  }

  ShapeTable shapes_;
  NarrowPhase narrow_phase_;
  std::span<Contact> last_;
  Neighbours neighbours_;
  PairOrder pair_order_;
  std::vector<Pair> pairs_;              // in order of contacts, but for those that come late
  std::vector<Pair> last_pairs_;         // of the search before
  std::vector<std::uint32_t> numbers_;   // 0, 1, 2, ... : all pairs, in order of contacts until some come late
  std::vector<std::uint32_t> in_order_;  // the same with those
  std::vector<std::uint32_t> last_of_;   // of each pair
  std::vector<std::int8_t> counts_;      // of the points of each pair, or kept
  std::vector<PairPoints> found_;        // of each pair that was collided
  bool found_the_same_ = false;
  std::vector<Pose> poses_;                // of each body in the last search
  std::vector<Real> moved_;                // m, by which no point of each proxy's body moved farther since
  std::vector<std::uint8_t> fresh_;        // of each contact of `last_`: whether that search found its points
  std::vector<std::uint32_t> undecided_;   // pairs that have no points yet, or may have more
  std::vector<std::uint32_t> to_collide_;  // those of them that do not keep what they had
  std::vector<std::uint32_t> to_keep_;     // and those that may
  std::vector<std::uint32_t> may_keep_;    // their contacts
  std::vector<std::uint8_t> kept_;         // and whether they do
  std::vector<std::uint32_t> fast_;        // touching pairs that may meet with a knock
  std::vector<Real> knocks_;  // m/s, by which each body's velocity may change within the step when it is struck
  std::vector<std::uint8_t> knocked_;  // whether each proxy's body has such a knock
  std::vector<Pair> farther_pairs_;    // of those proxies
  std::vector<std::uint32_t> touching_;
  std::vector<std::uint32_t> struck_piles_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
