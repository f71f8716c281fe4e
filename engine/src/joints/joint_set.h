#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "bodies/body_set.h"
#include "bodies/force_field.h"
#include "impulse/joint.h"
#include "joints/joint_rows.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Where a body is, its angle as a number that winds up.
struct JointPose {
  Pose pose;
  Real angle = 0;
};

/// One kind of joint between two bodies: knows where its anchors are, and writes its rows for any poses.
class JointModel {
 public:
  JointModel() = default;
  JointModel(const JointModel&) = delete;
  JointModel& operator=(const JointModel&) = delete;
  virtual ~JointModel() = default;

  /// Sets axes, arms and errors of all rows, and how many there are; leaves impulses alone.
  virtual void write(const JointPose& a, const JointPose& b, JointBlock& block) const = 0;
};

/// Each is in a file of its own in joints/. The bodies exist; throws std::invalid_argument for what makes no sense.
std::unique_ptr<const JointModel> model_of(const RevoluteJoint&, const BodySet&);
std::unique_ptr<const JointModel> model_of(const DistanceJoint&, const BodySet&);
std::unique_ptr<const JointModel> model_of(const PrismaticJoint&, const BodySet&);
std::unique_ptr<const JointModel> model_of(const WeldJoint&, const BodySet&);

struct ActiveJoint {
  const JointModel* model = nullptr;
  JointBlock block;
};

/// The joints of a world.
class JointSet {
 public:
  /// A soft joint is a spring among the forces, and a pair that does not collide. Throws std::invalid_argument for
  /// numbers or pairs that make no sense, std::out_of_range for stale bodies.
  JointId add(const Joint& joint, const BodySet& bodies, ForceField& forces);
  bool contains(JointId id) const;
  /// Throws std::out_of_range for a stale id.
  void remove(JointId id, ForceField& forces);
  /// Ends every joint of the body.
  void forget(BodyId body);

  /// The rows of the two bodies that it ties. Throws std::out_of_range for a stale id.
  std::pair<std::uint32_t, std::uint32_t> bodies_of(JointId id) const;

  /// The joints whose bodies are both in the world and not asleep, with rows as the bodies stand and the last step's
  /// impulses. In order of creation slots.
  std::vector<ActiveJoint>& activate(const BodySet& bodies);
  /// Keeps the impulses for the next step.
  void store();

  /// Whether a joint ties these two rows of bodies.
  bool ties(std::uint32_t a, std::uint32_t b) const;

  /// The rows of every two bodies that a joint ties, lower first, sorted.
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& tied() const { return pairs_; }
  /// What the joint gave body b in the last step, along its equations: N s (and N m s); the impulse on `a` is the
  /// opposite. Throws std::out_of_range for a stale id.
  Vec2 impulse(JointId id) const;

 private:
  struct Slot {
    std::uint32_t generation = 0;
    BodyId a, b;
    std::unique_ptr<const JointModel> model;  // none: the slot is free
    JointBlock block;
    std::optional<ForceId> spring;
  };
  void need(JointId id) const;
  void end(std::size_t slot);
  void note_pairs();

  std::vector<Slot> slots_;
  std::vector<std::uint32_t> free_slots_;
  std::vector<ActiveJoint> active_;
  std::vector<std::size_t> active_slot_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
