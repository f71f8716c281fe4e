#pragma once

#include <span>
#include <vector>

#include "body_set.h"
#include "broad_phase.h"
#include "contact.h"
#include "impulse/settings.h"
#include "joint_set.h"
#include "pair_order.h"
#include "solver.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The contacts of a world from step to step.
class ContactSet {
 public:
  /// Finds what touches, or will within the margin; contacts that were there before keep their impulses and age.
  ///
  /// With `recycle`, a contact whose bodies hardly moved since its points were found keeps normal and arms as they were
  /// and only measures its separations anew. That is stability, not thrift: arms that turn with every tremor make the
  /// stiffness of a stack depend on its lean, and a tall one buckles.
  void find(const BodySet& bodies, BroadPhase& broad_phase, const Settings& settings, const Margin& margin,
            bool recycle, const JointSet& joints);

  /// Forgets the contacts of a body.
  void forget(std::size_t body);

  /// Of bodies that are awake. Sorted by (body_a, body_b, part_a, part_b).
  std::vector<Contact>& rows() { return rows_; }
  const std::vector<Contact>& rows() const { return rows_; }

  /// Of bodies asleep, as their last step left them; sorted likewise. Solvers don't see them.
  std::span<const Contact> resting() const { return resting_; }
  /// Lays aside the contacts of bodies that have fallen asleep.
  void lay_to_rest(const BodySet& bodies);
  /// Takes up again those of bodies that have woken, so that the next search finds them known.
  void take_back(const BodySet& bodies);

  /// Both kinds in one order.
  std::vector<const Contact*> all() const;

 private:
  void search(const BodySet& bodies, BroadPhase& broad_phase, const Settings& settings, const Margin& margin,
              bool recycle, const JointSet& joints);
  bool foresee_knocks(const BodySet& bodies, const Margin& margin);
  void collect_proxies(const BodySet& bodies, const Margin& margin);
  void sort_pairs(std::size_t bodies);
  /// One that has a dynamic body and one that stands still.
  struct OnGround {
    std::uint32_t body;  // the dynamic one
    std::uint16_t part;
    bool dynamic_first;
    std::size_t row;
  };
  void collide_pairs(const BodySet& bodies, const Settings& settings, const Margin& margin, bool recycle,
                     const JointSet& joints);
  void remove_ghosts(const BodySet& bodies, const Margin& margin);
  void remove_ghosts(std::span<const OnGround> of_part, const BodySet& bodies, const Margin& margin);

  std::vector<Proxy> proxies_;
  std::vector<Pair> pairs_;
  bool several_parts_ = false;  // some body has
  PairOrder order_;
  std::vector<Contact> rows_;
  std::vector<Contact> last_rows_;
  std::vector<Real> knocks_;  // m/s, by which each body's velocity may change within the step when it is struck
  std::vector<OnGround> on_ground_;
  std::vector<OnGround> supports_;
  std::vector<Contact> resting_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
