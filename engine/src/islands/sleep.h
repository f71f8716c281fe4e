#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "bodies/body_set.h"
#include "bodies/force_field.h"
#include "broad_phase/aabb_tree.h"
#include "contacts/contact_set.h"
#include "islands/islands.h"
#include "joints/joint_set.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Islands at rest sleep: no step searches, integrates or solves them until something disturbs them.
///
/// An island is what ties bind: contacts within reach of a step, joints, springs and attractions. Bodies that are not
/// dynamic bind nothing together; but a tie to one on its way keeps awake. Solvers know nothing of all this: to them a
/// body asleep is a fixed one, without contacts and joints. Nor does any of these ever meet something that moves: what
/// could, is woken before the step (`rouse`).
class Sleep {
 public:
  Sleep(BodySet& bodies, ContactSet& contacts, const JointSet& joints, const ForceField& forces)
      : bodies_(bodies), contacts_(contacts), joints_(joints), forces_(forces) {}

  /// Before a step: wakes what is tied to something that moves, and takes up the contacts of all that woke. False if
  /// all is asleep or immovable, so that the step has nothing to do.
  bool rouse(const Margin& margin);
  /// After a step: takes note of what rests, and puts to sleep the islands that have rested long enough.
  void settle(const Settings& settings, const Margin& margin);

  /// Puts a body and its island to sleep, whatever they do.
  void put_to_sleep(std::size_t i, const Margin& margin);
  /// Wakes a body and its island; of one that is awake, the time to fall asleep starts over.
  void wake(std::size_t i);
  void wake_all();
  /// Something was done to a body: a dynamic one wakes, of any other what touches it, hangs on it or is in its place.
  void disturb(std::size_t i);

 private:
  using Tie = std::pair<std::uint32_t, std::uint32_t>;

  bool within_reach(std::size_t a, std::size_t b, Vec2 normal, Real separation, const Margin& margin) const;
  bool may_meet(std::size_t mover, std::size_t sleeper, const Margin& margin) const;
  void rouse_around(std::uint32_t mover, const Margin& margin);
  void note_ties();
  void tie_islands(const Margin& margin);
  bool rests(std::size_t i, const Settings& settings);
  void lay_down(std::span<const std::uint32_t> island);

  BodySet& bodies_;
  ContactSet& contacts_;
  const JointSet& joints_;
  const ForceField& forces_;

  /// What is known of a body while it is slow, and while it sleeps.
  struct Rest {
    Real time = moving;  // s, for which it has stayed near `at`
    Pose at;
    Real angle = 0;
    std::uint32_t next = 0;  // asleep: the next one of its island, in a ring
    std::uint32_t leaf = 0;  // asleep: in the tree
  };
  static constexpr Real moving = -1;

  std::vector<Rest> rest_;  // of each body
  AabbTree tree_;           // of all asleep
  bool woken_ = false;      // some since contacts were last taken up
  Islands islands_;
  std::vector<Tie> ties_;               // by joints and forces
  std::vector<std::uint8_t> restless_;  // of each body: it, or what it is tied to, moves
  std::vector<std::uint32_t> movers_;   // all that a step may move
  std::vector<std::uint32_t> neighbors_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
