#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "broad_phase/broad_phase.h"
#include "broad_phase/neighbours.h"
#include "broad_phase/pair_order.h"
#include "contacts/contact.h"
#include "impulse/contact.h"
#include "impulse/settings.h"
#include "joints/joint_set.h"
#include "narrow_phase/narrow_phase.h"
#include "narrow_phase/shape_table.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The order of contacts, (body_a, body_b, part_a, part_b), as two numbers.
struct ContactOrder {
  std::uint64_t bodies;
  std::uint32_t parts;

  explicit ContactOrder(const Contact& c) : ContactOrder(c.body_a, c.body_b, c.part_a, c.part_b) {}
  ContactOrder(const Proxy& a, const Proxy& b) : ContactOrder(a.body, b.body, a.part, b.part) {}
  ContactOrder(std::uint32_t a, std::uint32_t b, std::uint16_t part_a, std::uint16_t part_b)
      : bodies(std::uint64_t{a} << 32U | b), parts(std::uint32_t{part_a} << 16U | part_b) {}
  bool operator<(const ContactOrder& other) const {
    return bodies != other.bodies ? bodies < other.bodies : parts < other.parts;
  }
  bool operator==(const ContactOrder&) const = default;
};
inline bool comes_before(const Contact& left, const Contact& right) { return ContactOrder(left) < ContactOrder(right); }

/// The input of a search for contacts (see ContactSet::find).
struct SearchInput {
  const BodySet& bodies;
  BroadPhase& broad_phase;
  const Settings& settings;
  const Margin& margin;
  bool persistence;
  const JointSet& joints;
  const PartFilter& filter;
};

/// Finds the pairs of parts that touch or are within the speculative margin, and their contact points.
class ContactSearch {
 public:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  /// `last` are the contacts as they are since the last search; the span must stay valid while results are read. Those
  /// that persist are brought up to date. `undisturbed`: none was removed or added since that search.
  void search(const SearchInput& input, std::span<Contact> last, bool undisturbed);

  /// Indices of the pairs that have points, in the order of contacts.
  std::span<const std::uint32_t> touching() const { return touching_; }
  /// Piles at rest with a body that is hit, ascending: the search did not look for what that body hits next.
  std::span<const std::uint32_t> hit_piles() const { return hit_piles_; }
  /// Whether these are exactly the contacts of `last`.
  bool found_the_same() const { return found_the_same_; }
  const Proxy& first(std::uint32_t pair) const { return shapes_.proxies()[pairs_[pair].first]; }
  const Proxy& second(std::uint32_t pair) const { return shapes_.proxies()[pairs_[pair].second]; }
  const Part& first_part(std::uint32_t pair) const { return shapes_.part(pairs_[pair].first); }
  const Part& second_part(std::uint32_t pair) const { return shapes_.part(pairs_[pair].second); }
  /// The index of the pair's contact in `last`, or none.
  std::uint32_t last_of(std::uint32_t pair) const { return last_of_[pair]; }
  /// Whether that contact persists with its points; then points() is not defined.
  bool persists(std::uint32_t pair) const { return counts_[pair] == persistent; }
  const PairPoints& points(std::uint32_t pair) const { return found_[pair]; }

 private:
  static constexpr std::int8_t persistent = -1;  // instead of a count of points

  void put_in_order(const SearchInput& input, std::vector<Pair>& pairs);
  void match(bool undisturbed);
  std::uint32_t find_last(const ContactOrder& wanted, std::uint32_t& place) const;
  void find_points(const SearchInput& input, std::span<const std::uint32_t> of_pairs);
  void persist_points(const SearchInput& input, std::span<const std::uint32_t> of_pairs);
  void note_motion(const SearchInput& input, bool undisturbed);
  bool predict_impacts(const SearchInput& input);
  /// That a body is hit by another, and by how much its velocity may change, m/s.
  struct Change {
    std::size_t body, by;
    Real any_way;  // in any direction
    Vec2 thrust;   // in this one
  };
  bool change_velocity(const SearchInput& input, const Change& hit);
  void pass_along_joints(const SearchInput& input);
  void pass_by_levers(const SearchInput& input);
  void count_bearing();
  Real gap_between(std::uint32_t pair) const;
  bool stay_apart(const Margin& margin, const Pair& pair, const PairPoints& found) const;
  void pass_impacts_on(const SearchInput& input);
  void remove_apart(const SearchInput& input, std::vector<Pair>& pairs);
  void search_farther(const SearchInput& input);
  bool may_gain_points(std::uint32_t pair) const;
  void list_touching(std::span<const std::uint32_t> in_order);
  bool touching_are_last() const;
  ContactOrder order_of(const Pair& pair) const {
    return {shapes_.proxies()[pair.first], shapes_.proxies()[pair.second]};
  }

  /// The order of contacts. Proxies are sorted by (body, part) themselves, so this differs from the order of pairs only
  /// if the first body has several parts.
  bool before(const Pair& left, const Pair& right) const {
    const auto body = [this](std::uint32_t i) { return shapes_.proxies()[i].body; };
    const bool same_order =
        !shapes_.several_parts() || left.first == right.first || body(left.first) != body(right.first);
    return same_order ? left < right : order_of(left) < order_of(right);
  }

  ShapeTable shapes_;
  NarrowPhase narrow_phase_;
  std::span<Contact> last_;
  Neighbours neighbours_;
  PairOrder pair_order_;
  std::vector<Pair> pairs_;              // in the order of contacts, except for late ones
  std::vector<Pair> last_pairs_;         // of the last search
  std::vector<std::uint32_t> numbers_;   // 0, 1, 2, ...: all pairs, in the order of contacts until late ones are added
  std::vector<std::uint32_t> in_order_;  // all pairs with late ones
  std::vector<std::uint32_t> last_of_;   // of each pair
  std::vector<std::int8_t> counts_;      // of the points of each pair, or `persistent`
  std::vector<PairPoints> found_;        // of each pair that was collided in this search
  bool found_the_same_ = false;
  std::vector<Pose> poses_;                        // of each body in the last search
  std::vector<Real> moved_;                        // m, of each proxy: bound of its body's motion since
  std::vector<std::uint8_t> collided_;             // of each contact of `last_`: whether that search collided it
  std::vector<std::uint32_t> undecided_;           // pairs that have no points yet or may get more
  std::vector<std::uint32_t> to_collide_;          // pairs whose contacts do not persist
  std::vector<std::uint32_t> may_persist_;         // pairs whose contacts may
  std::vector<std::uint32_t> candidate_contacts_;  // their contacts
  std::vector<std::uint8_t> kept_;                 // and whether they do
  std::vector<std::uint32_t> fast_;                // touching pairs that may hit each other within the step
  std::vector<Change> passed_on_;
  std::vector<std::uint8_t> changed_;    // of each body, in this round of pass_impacts_on()
  std::vector<std::uint32_t> to_pass_;   // bodies whose changes joints have not passed on yet
  std::vector<Change> levered_;          // what partners of bodies that are hit may change by
  std::vector<Pair> near_hit_;           // found in it
  std::vector<PairPoints> near_points_;  // of these
  std::vector<std::uint32_t> hit_by_;    // of each body, see change_velocity()
  std::vector<std::uint32_t> bearing_;   // of each body: how many are so near that they may bear it
  std::vector<Real> any_way_;            // m/s, of each body: what impacts within the step may change of its velocity,
  std::vector<Vec2> thrusts_;            // the same, in one direction,
  std::vector<Real> impact_changes_;     // and the greater of both
  std::vector<std::uint8_t> hit_;        // of each proxy: whether its body has such a change
  std::vector<Pair> farther_pairs_;      // of those proxies
  std::vector<std::uint32_t> touching_;
  std::vector<std::uint32_t> hit_piles_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
