#pragma once

#include <optional>
#include <span>
#include <vector>

#include "body_set.h"
#include "broad_phase.h"
#include "contact.h"
#include "impulse/settings.h"
#include "joint_set.h"
#include "kernels.h"
#include "narrow_phase.h"
#include "pair_order.h"
#include "shape_table.h"
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
  /// What a search is given.
  struct Step {
    const BodySet& bodies;
    BroadPhase& broad_phase;
    const Settings& settings;
    const Margin& margin;
    bool recycle;
    const JointSet& joints;
  };
  void search(const Step& step);
  void sort_pairs(std::size_t bodies);
  void leave_out_tied(const JointSet& joints);
  void match();
  void keep_points_of_resting(const Step& step);
  bool foresee_knocks(const Step& step);
  void write_rows(const Step& step);
  void mix_again(const BodySet& bodies, const Settings& settings);

  /// One that has a dynamic body and one that stands still.
  struct OnGround {
    std::uint32_t body;  // the dynamic one
    std::uint16_t part;
    bool dynamic_first;
    std::size_t row;
  };
  void remove_ghosts(const BodySet& bodies, const Margin& margin);
  void remove_ghosts(std::span<const OnGround> of_part, const BodySet& bodies, const Margin& margin);

  /// The rules by which materials were mixed last.
  struct Mixing {
    FrictionMixing friction;
    RestitutionMixing restitution;
  };
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  ShapeTable shapes_;
  std::vector<Pair> pairs_;
  PairOrder order_;
  std::vector<std::uint32_t> last_of_;     // row of each pair in the last step, or none
  std::vector<std::uint32_t> to_keep_;     // pairs whose points may stay
  std::vector<std::uint32_t> again_of_;    // their rows
  std::vector<PointsAgain> again_;         // and points
  std::vector<std::uint32_t> to_collide_;  // other pairs
  NarrowPhase narrow_phase_;
  std::vector<PairPoints> found_;  // of each pair
  std::vector<Contact> rows_;
  std::vector<Contact> last_rows_;
  std::optional<Mixing> mixed_by_;
  std::vector<Real> knocks_;  // m/s, by which each body's velocity may change within the step when it is struck
  std::vector<OnGround> on_ground_;
  std::vector<OnGround> supports_;
  std::vector<Contact> resting_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
