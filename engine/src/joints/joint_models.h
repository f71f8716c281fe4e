#pragma once

#include <memory>
#include <optional>

#include "bodies/body_set.h"
#include "impulse/joint.h"
#include "joints/joint_rows.h"

namespace impulse::inline IMPULSE_PRECISION {

/// A body's pose, and its angle (rad) without wrap-around.
struct JointPose {
  Pose pose;
  Real angle = 0;
};

/// One joint between two bodies: stores its anchors and writes its rows for any pair of poses.
class JointModel {
 public:
  JointModel() = default;
  JointModel& operator=(const JointModel&) = delete;
  virtual ~JointModel() = default;

  /// Sets the number of rows and the axis, arms and error of each; keeps the impulses.
  virtual void write(const JointPose& a, const JointPose& b, JointBlock& block) const = 0;

  /// The same joint with another motor or other limits, or none. Throw std::invalid_argument for invalid values, and
  /// for a joint that cannot have them.
  virtual std::unique_ptr<const JointModel> with_motor(const std::optional<Motor>& motor) const;
  virtual std::unique_ptr<const JointModel> with_limits(const std::optional<Limits>& limits) const;

 protected:
  JointModel(const JointModel&) = default;
};

/// Requires that both bodies exist. Throws std::invalid_argument for invalid values.
std::unique_ptr<const JointModel> model_of(const RevoluteJoint&, const BodySet&);
std::unique_ptr<const JointModel> model_of(const DistanceJoint&, const BodySet&);
std::unique_ptr<const JointModel> model_of(const PrismaticJoint&, const BodySet&);
std::unique_ptr<const JointModel> model_of(const WeldJoint&, const BodySet&);

}  // namespace impulse::inline IMPULSE_PRECISION
