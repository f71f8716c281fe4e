// What Box2D's joints do differently: they are stiff springs. A soft distance joint is tuned by frequency and damping
// ratio. These correspond to a stiffness and a damping only if the effective mass is constant: between centres of mass.

#include "reference/adapters/box2d_v3/joints.h"

#include <cmath>
#include <numbers>
#include <variant>

#include "reference/adapter.h"
#include "reference/adapters/box2d_joints.h"
#include "reference/scene_facts.h"
#include "scenarios/scene/mass.h"

namespace plumb::box2d_v3 {
namespace {

double inverse_mass(const Body& body) {
  const double mass = mass_of(body).mass;
  return mass > 0 ? 1 / mass : 0;
}

class Joiner {
 public:
  Joiner(b2WorldId world, const Scene& scene, std::span<const b2BodyId> bodies)
      : world_(world), scene_(scene), bodies_(bodies) {}

  void operator()(const Revolute& joint) const {
    auto def = between(b2DefaultRevoluteJointDef(), joint.a, joint.b, joint.anchor, joint.anchor);
    set_limits(def, def.lowerAngle, def.upperAngle, joint.limits);
    set_motor(def, def.maxMotorTorque, joint.motor);
    b2CreateRevoluteJoint(world_, &def);
  }

  // k = m w^2 and d = 2 z m w for the effective mass m along the line between the centres of mass.
  void operator()(const Distance& joint) const {
    auto def = between(b2DefaultDistanceJointDef(), joint.a, joint.b, joint.anchor_a, joint.anchor_b);
    def.length = static_cast<float>(joint.length);
    if (joint.stiffness > 0) {
      const double inverse = inverse_mass(scene_.bodies[joint.a]) + inverse_mass(scene_.bodies[joint.b]);
      const double w = std::sqrt(joint.stiffness * inverse);
      def.enableSpring = true;
      def.hertz = static_cast<float>(w / (2 * std::numbers::pi));
      def.dampingRatio = static_cast<float>(joint.damping * inverse / (2 * w));
    }
    b2CreateDistanceJoint(world_, &def);
  }

  void operator()(const Prismatic& joint) const {
    auto def = between(b2DefaultPrismaticJointDef(), joint.a, joint.b, joint.anchor, joint.anchor,
                       std::atan2(joint.axis.y, joint.axis.x));
    set_limits(def, def.lowerTranslation, def.upperTranslation, joint.limits);
    set_motor(def, def.maxMotorForce, joint.motor);
    b2CreatePrismaticJoint(world_, &def);
  }

  void operator()(const Weld& joint) const {
    const auto def = between(b2DefaultWeldJointDef(), joint.a, joint.b, joint.anchor, joint.anchor);
    b2CreateWeldJoint(world_, &def);
  }

 private:
  // Fills in the two bodies of a joint, its anchors and the angle of its axis (rad, world frame).
  template <class Def>
  Def between(Def def, std::size_t index_a, std::size_t index_b, Vec anchor_a, Vec anchor_b, double axis = 0) const {
    const b2BodyId a = bodies_[index_a];
    const b2BodyId b = bodies_[index_b];
    const b2Vec2 on_a = local(a, anchor_a);
    const b2Vec2 on_b = local(b, anchor_b);
    const b2Rot along = rotation_by(axis);
    const b2Rot axis_a = b2InvMulRot(b2Body_GetRotation(a), along);
    const b2Rot axis_b = b2InvMulRot(b2Body_GetRotation(b), along);
    if constexpr (requires { def.base; }) {
      def.base.bodyIdA = a;
      def.base.bodyIdB = b;
      def.base.localFrameA = {on_a, axis_a};
      def.base.localFrameB = {on_b, axis_b};
    } else {
      def.bodyIdA = a;
      def.bodyIdB = b;
      def.localAnchorA = on_a;
      def.localAnchorB = on_b;
      if constexpr (requires { def.localAxisA; }) def.localAxisA = {axis_a.c, axis_a.s};
      if constexpr (requires { def.referenceAngle; }) {
        const b2Rot turned = b2InvMulRot(axis_b, axis_a);
        def.referenceAngle = std::atan2(turned.s, turned.c);
      }
    }
    return def;
  }

  static b2Vec2 local(b2BodyId body, Vec point) {
    const Vec origin = from_b2(b2Body_GetPosition(body));
    return b2InvRotateVector(b2Body_GetRotation(body), to_b2({point.x - origin.x, point.y - origin.y}));
  }

  b2WorldId world_;
  const Scene& scene_;
  std::span<const b2BodyId> bodies_;
};

bool at_center(const Body& body, Vec anchor) {
  constexpr double same = 1e-6;  // m, round-off of a float position
  const Vec center = centered(body).position;
  return std::hypot(anchor.x - center.x, anchor.y - center.y) < same;
}

}  // namespace

void add_joints(b2WorldId world, const Scene& scene, std::span<const b2BodyId> bodies) {
  for (const Joint& joint : scene.joints) visit_supported(Joiner(world, scene, bodies), joint);
}

std::string eccentric_spring_refusal(const Scene& scene) {
  const auto eccentric = [&](std::size_t i, Vec anchor) {
    return scene.bodies[i].type == BodyType::dynamic && !at_center(scene.bodies[i], anchor);
  };
  for (const Joint& joint : scene.joints) {
    const auto* distance = std::get_if<Distance>(&joint);
    if (distance == nullptr || distance->stiffness == 0) continue;
    if (eccentric(distance->a, distance->anchor_a) || eccentric(distance->b, distance->anchor_b)) {
      return "tunes springs by frequency, so it supports soft distance joints between centres of mass only";
    }
  }
  return "";
}

}  // namespace plumb::box2d_v3
