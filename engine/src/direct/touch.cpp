#include "direct/touch.h"

#include <cmath>

namespace impulse::inline IMPULSE_PRECISION {

Touch::Touch(const Contact& contact, NormalOf normal_of)
    : normal_of_(normal_of),
      count_(contact.count),
      normal_(contact.normal),
      radius_a_(contact.radius_a),
      radius_b_(contact.radius_b) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
    const PointArms arms = arms_of(contact, i);
    arm_a_[i] = {arms.turn_a, -arms.cross_a};
    arm_b_[i] = {arms.turn_b, -arms.cross_b};
    separation_[i] = contact.found_separation[i];
  }
}

Touch::Touch(const Contact& contact, NormalOf normal_of, const Motion& a, const Motion& b) : Touch(contact, normal_of) {
  found_a_ = back(a);
  found_b_ = back(b);
}

Touch::Touch(const Contact& contact, NormalOf normal_of, const Pose& start_a, const Pose& start_b)
    : Touch(contact, normal_of) {
  found_a_ = between_poses(contact.found_a, start_a);
  found_b_ = between_poses(contact.found_b, start_b);
}

/// The inverse of a motion's rotation, and of its translation.
Touch::Displacement Touch::back(const Motion& found) { return {-found.d, -found.sine, found.drop}; }

Touch::Displacement Touch::between_poses(const Pose& then, const Pose& now) {
  if (then.q == now.q) return {now.p - then.p};
  const Rotation by = now.q * then.q.inverse();
  return {now.p - then.p, by.s, by.c - 1};
}

Touch::Displacement Touch::since(const Displacement& found, const Motion& now) {
  // cos - 1 of a sum of angles, without cancellation.
  return {found.d + now.d, now.sine * (1 + found.drop) + (1 + now.drop) * found.sine,
          now.drop + found.drop + now.drop * found.drop - now.sine * found.sine};
}

/// From the core of a to that of b, without their rounding radii.
Vec2 Touch::cores(std::size_t point, const Displacement& a, const Displacement& b) const {
  const Vec2 apart = b.d - a.d;
  const Vec2 moved{dot(normal_, apart), dot(perpendicular(normal_), apart)};
  return Vec2{radius_a_ + radius_b_ + separation_[point], 0} + moved + (b.change(arm_b_[point]) - a.change(arm_a_[point]));
}

/// The normal, in the frame of the one as found.
Vec2 Touch::direction(Vec2 cores, const Displacement& a, const Displacement& b) const {
  if (normal_of_ == NormalOf::a) return {1 + a.drop, a.sine};
  if (normal_of_ == NormalOf::b) return {1 + b.drop, b.sine};
  if (radius_a_ + radius_b_ == 0 || !(cores.x > std::abs(cores.y))) return {1, 0};
  return normalized(cores);
}

TouchFrame Touch::at(const Motion& motion_a, const Motion& motion_b) const {
  const Displacement a = since(found_a_, motion_a);
  const Displacement b = since(found_b_, motion_b);
  TouchFrame frame;
  const Vec2 n = direction(cores(0, a, b), a, b);
  const Vec2 t = perpendicular(n);
  frame.normal = n.x * normal_ + n.y * perpendicular(normal_);
  for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
    const Vec2 apart = cores(i, a, b);
    Vec2 to_a = arm_a_[i] + a.change(arm_a_[i]);
    Vec2 to_b = arm_b_[i] + b.change(arm_b_[i]);
    const Real along = dot(t, apart);
    const Real share = normal_of_ == NormalOf::a ? Real{1} : normal_of_ == NormalOf::b ? Real{0} : Real{1} / 2;
    to_a += share * along * t;
    to_b -= (1 - share) * along * t;
    PointArms& p = frame.points[i];
    p.separation = dot(n, apart) - (radius_a_ + radius_b_);
    p.turn_a = dot(n, to_a);
    p.turn_b = dot(n, to_b);
    p.cross_a = -dot(t, to_a);
    p.cross_b = -dot(t, to_b);
    p.dot_a = p.turn_a + radius_a_ + p.separation / 2;
    p.dot_b = p.turn_b - radius_b_ - p.separation / 2;
  }
  return frame;
}

Real Touch::gap(std::size_t point, const Motion& motion_a, const Motion& motion_b) const {
  const Displacement a = since(found_a_, motion_a);
  const Displacement b = since(found_b_, motion_b);
  return dot(direction(cores(0, a, b), a, b), cores(point, a, b)) - (radius_a_ + radius_b_);
}

Real Touch::moved(const Motion& motion_a, const Motion& motion_b, Real radius_a, Real radius_b) const {
  const Displacement a = since(found_a_, motion_a);
  const Displacement b = since(found_b_, motion_b);
  const auto turned = [](const Displacement& by) { return std::abs(by.sine) - by.drop; };
  return length(b.d - a.d) + turned(a) * radius_a + turned(b) * radius_b;
}

}  // namespace impulse::inline IMPULSE_PRECISION
