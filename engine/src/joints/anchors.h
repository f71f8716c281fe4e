#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "core/finite.h"
#include "joints/joint_set.h"

namespace impulse::inline IMPULSE_PRECISION {

/// One point on each of two bodies, in the frames of their centres of mass; and their angle as it was.
struct Anchors {
  Vec2 a, b;
  Real angle = 0;  // of b against a

  Anchors(BodyId body_a, BodyId body_b, Vec2 at_a, Vec2 at_b, const BodySet& bodies)
      : a(to_local(bodies.pose[body_a.index], at_a)),
        b(to_local(bodies.pose[body_b.index], at_b)),
        angle(bodies.angle[body_b.index] - bodies.angle[body_a.index]) {
    if (!finite(at_a) || !finite(at_b)) throw std::invalid_argument("Joint: anchors must be finite");
  }
};

/// The two anchors as the bodies stand: arms from the centres, and from anchor a to anchor b.
struct Reach {
  Vec2 arm_a, arm_b;
  Vec2 apart;

  Reach(const Anchors& anchors, const JointPose& a, const JointPose& b)
      : arm_a(a.pose.q * anchors.a), arm_b(b.pose.q * anchors.b), apart((b.pose.p - a.pose.p) + (arm_b - arm_a)) {}

  /// The row that measures `apart` along an axis that stands still.
  void measure(Vec2 axis, JointRow& row) const {
    row.axis = axis;
    row.arm_a = cross(arm_a, axis);
    row.arm_b = cross(arm_b, axis);
    row.error = dot(apart, axis);
  }
  /// The same along an axis that turns with body a.
  void measure_in_a(Vec2 axis, JointRow& row) const {
    measure(axis, row);
    row.arm_a = cross(arm_a + apart, axis);
  }
};

/// The row that measures the angle of b against a.
inline void measure_angle(const Anchors& anchors, const JointPose& a, const JointPose& b, JointRow& row) {
  row.axis = {};
  row.arm_a = row.arm_b = 1;
  row.error = b.angle - a.angle - anchors.angle;
}

/// Stops and motor along a row that measures where b is; nothing changes where a joint has neither.
inline void add_stops(const JointRow& measured, const std::optional<Limits>& limits, JointBlock& block) {
  if (!limits) return;
  JointRow& low = block.stop[0];
  JointRow& high = block.stop[1];
  block.stops = 2;
  low = {measured.axis, measured.arm_a, measured.arm_b, measured.error - limits->low, low.impulse, low.half};
  high = {-measured.axis, -measured.arm_a, -measured.arm_b, limits->high - measured.error, high.impulse, high.half};
}
inline void add_motor(const JointRow& measured, const std::optional<Motor>& motor, JointBlock& block) {
  if (!motor) return;
  block.driven = true;
  block.motor = {measured.axis, measured.arm_a, measured.arm_b, 0, block.motor.impulse, block.motor.half};
  block.motor_speed = motor->speed;
  block.motor_strength = motor->strength;
}

inline void check(const std::optional<Limits>& limits, const std::optional<Motor>& motor) {
  if (limits && !(finite(limits->low) && finite(limits->high) && limits->low <= limits->high)) {
    throw std::invalid_argument("Joint: limits must be finite, low at most high");
  }
  if (motor && !(finite(motor->speed) && finite(motor->strength) && motor->strength >= 0)) {
    throw std::invalid_argument("Joint: motor speed must be finite, strength finite and not negative");
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
