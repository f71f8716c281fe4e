#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "bodies/body_set.h"
#include "bodies/force_field.h"
#include "impulse/joint.h"
#include "joints/joint_models.h"
#include "joints/joint_rows.h"

namespace impulse::inline IMPULSE_PRECISION {

/// A joint whose bodies are both in the world and awake.
struct ActiveJoint {
  const JointModel* model = nullptr;
  JointBlock block;
};

/// The joints of a world.
class JointSet {
 public:
  /// Adds a joint. A soft joint also adds a spring to the forces. Throws std::invalid_argument for invalid values or
  /// pairs, std::out_of_range for stale bodies.
  JointId add(const Joint& joint, const BodySet& bodies, ForceField& forces);
  bool contains(JointId id) const;
  /// Throws std::out_of_range for a stale id.
  void remove(JointId id, ForceField& forces);
  /// Removes every joint of the body; its springs must be removed with ForceField::forget.
  void forget(BodyId body);

  /// Change or remove the motor or the limits of a joint. A motor keeps its impulse for the next step, limits don't.
  /// Throw std::out_of_range for a stale id, std::invalid_argument for invalid values or a joint that has none of
  /// these.
  void set_motor(JointId id, const std::optional<Motor>& motor);
  void set_limits(JointId id, const std::optional<Limits>& limits);

  /// The rows of the joint's two bodies. Throws std::out_of_range for a stale id.
  std::pair<std::uint32_t, std::uint32_t> bodies_of(JointId id) const;

  /// The joints whose bodies are both in the world and awake, in order of their slots, with rows written for the
  /// bodies' current poses and with the last step's impulses.
  std::vector<ActiveJoint>& activate(const BodySet& bodies);
  /// Writes the impulses of the active joints back, for the next step.
  void store();

  /// Whether a joint connects the bodies in these two rows.
  bool connects(std::uint32_t a, std::uint32_t b) const;
  /// The rows of the bodies that joints connect with the one in this row.
  std::span<const std::uint32_t> partners(std::uint32_t body) const;

  bool empty() const { return slots_.size() == free_slots_.size(); }
  /// Appends the rows of the two bodies of every joint, in order of their slots.
  void append_pairs(std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs) const;

  /// The impulse on body b (N s) in the last sub-step, summed over the joint's rows; that on `a` is the opposite.
  /// Throws std::out_of_range for a stale id.
  Vec2 impulse(JointId id) const;

 private:
  struct Slot {
    std::uint32_t generation = 0;
    BodyId a, b;
    std::shared_ptr<const JointModel> model;  // null if the slot is free; copies of a world share it
    JointBlock block;
    std::optional<ForceId> spring;
  };
  void require(JointId id) const;
  void free_slot(std::size_t slot);

  std::vector<Slot> slots_;
  std::vector<std::uint32_t> free_slots_;
  std::vector<ActiveJoint> active_;
  std::vector<std::size_t> active_slot_;
  std::vector<std::vector<std::uint32_t>> partners_;  // by the row of a body, once for each joint
};

}  // namespace impulse::inline IMPULSE_PRECISION
