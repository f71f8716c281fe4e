#include <optional>

#include "c_api/convert.h"

namespace impulse::c_api {

namespace {

std::optional<Motor> motor_from_c(const impulse_motor* motor) {
  if (motor == nullptr) return std::nullopt;
  return Motor{motor->speed, motor->strength};
}

std::optional<Limits> limits_from_c(const impulse_limits* limits) {
  if (limits == nullptr) return std::nullopt;
  return Limits{limits->low, limits->high};
}

Joint joint_from_c(const impulse_joint& from) {
  const BodyId a = from_c(from.a);
  const BodyId b = from_c(from.b);
  const Vec2 anchor = from_c(from.anchor);
  const std::optional<Limits> limits = limits_from_c(from.has_limits ? &from.limits : nullptr);
  const std::optional<Motor> motor = motor_from_c(from.has_motor ? &from.motor : nullptr);
  switch (from.type) {
    case IMPULSE_REVOLUTE:
      return RevoluteJoint{a, b, anchor, limits, motor};
    case IMPULSE_DISTANCE:
      return DistanceJoint{a, b, anchor, from_c(from.anchor_b), from.length, from.stiffness, from.damping};
    case IMPULSE_PRISMATIC:
      return PrismaticJoint{a, b, anchor, from_c(from.axis), limits, motor};
    case IMPULSE_WELD:
      return WeldJoint{a, b, anchor};
  }
  throw std::invalid_argument("the type of the joint is unknown");
}

}  // namespace

}  // namespace impulse::c_api

using namespace impulse::c_api;

impulse_status impulse_create_joint(impulse_world* world, const impulse_joint* joint, impulse_joint_id* id) {
  return guarded([&] {
    impulse_joint_id& to = given(id, "the place for the handle");
    to = to_c(world_of(world).create_joint(joint_from_c(given(joint, "the joint"))));
  });
}

impulse_status impulse_destroy_joint(impulse_world* world, impulse_joint_id id) {
  return guarded([&] { world_of(world).destroy_joint(from_c(id)); });
}

impulse_status impulse_set_motor(impulse_world* world, impulse_joint_id id, const impulse_motor* motor) {
  return guarded([&] { world_of(world).set_motor(from_c(id), motor_from_c(motor)); });
}

impulse_status impulse_set_limits(impulse_world* world, impulse_joint_id id, const impulse_limits* limits) {
  return guarded([&] { world_of(world).set_limits(from_c(id), limits_from_c(limits)); });
}

impulse_status impulse_joint_impulse(const impulse_world* world, impulse_joint_id id, impulse_vec2* impulse) {
  return guarded(
      [&] { given(impulse, "the place for the impulse") = to_c(world_of(world).joint_impulse(from_c(id))); });
}
