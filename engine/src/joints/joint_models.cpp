#include "joints/joint_models.h"

#include <optional>
#include <stdexcept>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// One point on each of two bodies, in the frames of their centres of mass, and the initial angle between the bodies.
struct Anchors {
  Vec2 a, b;
  Real angle = 0;  // rad, of b relative to a

  Anchors(BodyId body_a, BodyId body_b, Vec2 at_a, Vec2 at_b, const BodySet& bodies)
      : a(to_local(bodies.pose[body_a.index], at_a)),
        b(to_local(bodies.pose[body_b.index], at_b)),
        angle(bodies.angle[body_b.index] - bodies.angle[body_a.index]) {
    if (!is_finite(at_a) || !is_finite(at_b)) throw std::invalid_argument("Joint: anchors must be finite");
  }
};

/// The two anchors at given poses: the arms from the centres of mass, and the offset from anchor a to anchor b.
struct AnchorArms {
  Vec2 arm_a, arm_b;
  Vec2 offset;

  AnchorArms(const Anchors& anchors, const JointPose& a, const JointPose& b)
      : arm_a(a.pose.q * anchors.a), arm_b(b.pose.q * anchors.b), offset((b.pose.p - a.pose.p) + (arm_b - arm_a)) {}

  /// Writes a row that measures the offset along a fixed axis.
  void measure(Vec2 axis, JointRow& row) const {
    row.axis = axis;
    row.arm_a = cross(arm_a, axis);
    row.arm_b = cross(arm_b, axis);
    row.error = dot(offset, axis);
  }
  /// Writes a row that measures the offset along an axis that rotates with body a.
  void measure_in_a(Vec2 axis, JointRow& row) const {
    measure(axis, row);
    row.arm_a = cross(arm_a + offset, axis);
  }
};

/// Writes a row that measures the angle of b relative to a.
void measure_angle(const Anchors& anchors, const JointPose& a, const JointPose& b, JointRow& row) {
  row.axis = {};
  row.arm_a = row.arm_b = 1;
  row.error = b.angle - a.angle - anchors.angle;
}

/// Writes the stops of a joint with limits, given the row that measures its coordinate.
void add_stops(const JointRow& measured, const std::optional<Limits>& limits, JointBlock& block) {
  if (!limits) return;
  JointRow& low = block.stop[0];
  JointRow& high = block.stop[1];
  block.stops = 2;
  low = {measured.axis, measured.arm_a, measured.arm_b, measured.error - limits->low, low.impulse, low.half};
  high = {-measured.axis, -measured.arm_a, -measured.arm_b, limits->high - measured.error, high.impulse, high.half};
}

/// Writes the motor row of a joint with a motor, given the row that measures its coordinate.
void add_motor(const JointRow& measured, const std::optional<Motor>& motor, JointBlock& block) {
  if (!motor) return;
  block.driven = true;
  block.motor = {measured.axis, measured.arm_a, measured.arm_b, 0, block.motor.impulse, block.motor.half};
  block.motor_speed = motor->speed;
  block.motor_strength = motor->strength;
}

void check_limits_and_motor(const std::optional<Limits>& limits, const std::optional<Motor>& motor) {
  if (limits && !(is_finite(limits->low) && is_finite(limits->high) && limits->low <= limits->high)) {
    throw std::invalid_argument("Joint: limits must be finite, low at most high");
  }
  if (motor && !(is_finite(motor->speed) && is_finite(motor->strength) && motor->strength >= 0)) {
    throw std::invalid_argument("Joint: motor speed must be finite, strength finite and not negative");
  }
}

/// A joint with one free coordinate, which limits and a motor act on.
template <class Derived>
class DrivenJoint : public JointModel {
 public:
  std::unique_ptr<const JointModel> with_motor(const std::optional<Motor>& motor) const override {
    check_limits_and_motor({}, motor);
    auto changed = std::make_unique<Derived>(static_cast<const Derived&>(*this));
    changed->motor_ = motor;
    return changed;
  }
  std::unique_ptr<const JointModel> with_limits(const std::optional<Limits>& limits) const override {
    check_limits_and_motor(limits, {});
    auto changed = std::make_unique<Derived>(static_cast<const Derived&>(*this));
    changed->limits_ = limits;
    return changed;
  }

 protected:
  DrivenJoint(const std::optional<Limits>& limits, const std::optional<Motor>& motor) : limits_(limits), motor_(motor) {
    check_limits_and_motor(limits_, motor_);
  }
  /// Writes stops and motor, given the row that measures the coordinate.
  void add_limits_and_motor(const JointRow& measured, JointBlock& block) const {
    add_stops(measured, limits_, block);
    add_motor(measured, motor_, block);
  }

 private:
  std::optional<Limits> limits_;
  std::optional<Motor> motor_;
};

class Revolute : public DrivenJoint<Revolute> {
 public:
  Revolute(const RevoluteJoint& joint, const BodySet& bodies)
      : DrivenJoint(joint.limits, joint.motor), anchors_(joint.a, joint.b, joint.anchor, joint.anchor, bodies) {}

  void write(const JointPose& a, const JointPose& b, JointBlock& block) const override {
    const AnchorArms arms(anchors_, a, b);
    block.equations = 2;
    arms.measure({1, 0}, block.equation[0]);
    arms.measure({0, 1}, block.equation[1]);
    JointRow angle;
    measure_angle(anchors_, a, b, angle);
    add_limits_and_motor(angle, block);
  }

 private:
  Anchors anchors_;
};

class RigidDistance : public JointModel {
 public:
  RigidDistance(const DistanceJoint& joint, const BodySet& bodies)
      : anchors_(joint.a, joint.b, joint.anchor_a, joint.anchor_b, bodies), length_(joint.length) {}

  void write(const JointPose& a, const JointPose& b, JointBlock& block) const override {
    const AnchorArms arms(anchors_, a, b);
    const Real distance = length(arms.offset);
    block.equations = 1;
    // Coincident anchors have no direction; any direction pushes them apart.
    arms.measure(distance > 0 ? arms.offset / distance : Vec2{1, 0}, block.equation[0]);
    block.equation[0].error = distance - length_;
  }

 private:
  Anchors anchors_;
  Real length_;
};

/// JointSet adds the spring itself as a force; this joint only keeps the two bodies from colliding.
class SoftDistance : public JointModel {
 public:
  void write(const JointPose&, const JointPose&, JointBlock& block) const override { block.equations = 0; }
};

class Prismatic : public DrivenJoint<Prismatic> {
 public:
  Prismatic(const PrismaticJoint& joint, const BodySet& bodies)
      : DrivenJoint(joint.limits, joint.motor),
        anchors_(joint.a, joint.b, joint.anchor, joint.anchor, bodies),
        axis_(normalized(bodies.pose[joint.a.index].q.inverse() * joint.axis)) {
    if (!is_finite(joint.axis) || axis_ == Vec2{}) {
      throw std::invalid_argument("PrismaticJoint: axis must be finite and not zero");
    }
  }

  void write(const JointPose& a, const JointPose& b, JointBlock& block) const override {
    const AnchorArms arms(anchors_, a, b);
    const Vec2 along = a.pose.q * axis_;
    block.equations = 2;
    arms.measure_in_a(perpendicular(along), block.equation[0]);
    measure_angle(anchors_, a, b, block.equation[1]);
    JointRow position;
    arms.measure_in_a(along, position);
    add_limits_and_motor(position, block);
  }

 private:
  Anchors anchors_;
  Vec2 axis_;  // frame of a
};

class Weld : public JointModel {
 public:
  Weld(const WeldJoint& joint, const BodySet& bodies)
      : anchors_(joint.a, joint.b, joint.anchor, joint.anchor, bodies) {}

  void write(const JointPose& a, const JointPose& b, JointBlock& block) const override {
    const AnchorArms arms(anchors_, a, b);
    block.equations = 3;
    arms.measure({1, 0}, block.equation[0]);
    arms.measure({0, 1}, block.equation[1]);
    measure_angle(anchors_, a, b, block.equation[2]);
  }

 private:
  Anchors anchors_;
};

}  // namespace

std::unique_ptr<const JointModel> JointModel::with_motor(const std::optional<Motor>&) const {
  throw std::invalid_argument("Joint: only revolute and prismatic joints have motors");
}

std::unique_ptr<const JointModel> JointModel::with_limits(const std::optional<Limits>&) const {
  throw std::invalid_argument("Joint: only revolute and prismatic joints have limits");
}

std::unique_ptr<const JointModel> model_of(const RevoluteJoint& joint, const BodySet& bodies) {
  return std::make_unique<Revolute>(joint, bodies);
}

std::unique_ptr<const JointModel> model_of(const DistanceJoint& joint, const BodySet& bodies) {
  if (!(is_finite(joint.length) && joint.length > 0)) {
    throw std::invalid_argument("DistanceJoint: length must be finite and above 0");
  }
  if (!(is_finite(joint.stiffness) && joint.stiffness >= 0 && is_finite(joint.damping) && joint.damping >= 0)) {
    throw std::invalid_argument("DistanceJoint: stiffness and damping must be finite and not negative");
  }
  if (joint.stiffness > 0) return std::make_unique<SoftDistance>();
  return std::make_unique<RigidDistance>(joint, bodies);
}

std::unique_ptr<const JointModel> model_of(const PrismaticJoint& joint, const BodySet& bodies) {
  return std::make_unique<Prismatic>(joint, bodies);
}

std::unique_ptr<const JointModel> model_of(const WeldJoint& joint, const BodySet& bodies) {
  return std::make_unique<Weld>(joint, bodies);
}

}  // namespace impulse::inline IMPULSE_PRECISION
