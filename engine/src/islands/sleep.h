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

/// Puts resting islands to sleep: they are not searched for contacts, integrated or solved until something wakes them.
///
/// Contacts that may close within a step, joints, springs and attractions connect bodies into islands. Bodies that are
/// not dynamic connect nothing, but a connection to a moving one keeps an island awake, and so does a body in the air
/// that a force will move, however slowly: an attraction if no joint holds it, or a spring, unless friction may hold
/// it, until it stands still. Solvers don't know about sleep: to them a sleeping body is fixed and has no contacts or
/// joints. No sleeping body ever meets a moving one, because wake_before_step wakes the bodies that could.
class Sleep {
 public:
  Sleep(BodySet& bodies, ContactSet& contacts, const JointSet& joints, const ForceField& forces,
        const PartFilter& filter)
      : bodies_(bodies), contacts_(contacts), joints_(joints), forces_(forces), filter_(filter) {}
  /// Takes over which bodies sleep and for how long others have been at rest, in a copy of the world.
  void copy(const Sleep& from) {
    rest_ = from.rest_;
    tree_ = from.tree_;
    woken_ = from.woken_;
  }

  /// Call before a step: wakes the islands that are connected to something that moves, and restores the contacts of all
  /// that woke. Returns false if every body is asleep or immovable, so that the step has nothing to do.
  bool wake_before_step(const Margin& margin);
  /// Call after a step: updates the sleep timers, and puts islands to sleep that have been at rest long enough.
  void update_after_step(const Settings& settings, const Margin& margin);

  /// Puts a body and its island to sleep, even if they move.
  void put_to_sleep(std::size_t i, const Margin& margin);
  /// Wakes a body and its island. If the body is awake, restarts its sleep timer.
  void wake(std::size_t i);
  void wake_all();
  /// Call when a body was changed: wakes a dynamic body, or everything that touches any other body, is connected to it
  /// or overlaps its bounds.
  void disturb(std::size_t i);

 private:
  using BodyPair = std::pair<std::uint32_t, std::uint32_t>;

  bool within_reach(std::size_t a, std::size_t b, Vec2 normal, Real separation, const Margin& margin) const;
  bool may_meet(std::size_t mover, std::size_t sleeper, const Margin& margin) const;
  void wake_around(std::uint32_t mover, const Margin& margin);
  void list_connections();
  void keep_pulled_awake(const Margin& margin);
  bool stands_still(std::size_t i) const;
  void build_islands(const Margin& margin);
  bool update_timer(std::size_t i, const Settings& settings);
  void put_island_to_sleep(std::span<const std::uint32_t> island);

  BodySet& bodies_;
  ContactSet& contacts_;
  const JointSet& joints_;
  const ForceField& forces_;
  const PartFilter& filter_;

  /// The sleep state of a body.
  struct Rest {
    Real time = moving;  // s, for which it has stayed near `at`
    Pose at;
    Real angle = 0;
    Real moved = 0;          // m, at most, from there
    std::uint32_t next = 0;  // if asleep: the next body of its island, in a ring
    std::uint32_t leaf = 0;  // if asleep: in the tree
  };
  static constexpr Real moving = -1;

  std::vector<Rest> rest_;  // of each body
  AabbTree tree_;           // of all sleeping bodies
  bool woken_ = false;      // whether a body woke since contacts were last restored
  Islands islands_;
  std::vector<BodyPair> connections_;   // by joints and forces
  std::vector<std::uint8_t> restless_;  // of each body: whether it or something connected to it moves
  std::vector<std::uint8_t> held_;      // of each body: what holds it, 0 if nothing
  static constexpr std::uint8_t touched = 1, by_friction = 2;
  std::vector<std::uint32_t> sprung_;  // rows of the bodies that springs pull
  std::vector<std::uint32_t> movers_;  // all that a step may move
  std::vector<std::uint32_t> neighbors_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
