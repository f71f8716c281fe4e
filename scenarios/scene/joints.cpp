#include "scenarios/scene/joints.h"

#include <cmath>

#include "scenarios/scene/scene_fields.h"
#include "scenarios/scene/shapes.h"

namespace plumb {
namespace {

template <class Kind>
OrderedJson joined_names(const Kind& joint, const Scene& scene) {
  return {scene.bodies.at(joint.a).name, scene.bodies.at(joint.b).name};
}

// What a motor exerts is a force in N; that of a hinge a torque in N m.
std::optional<Motor> read_motor(const JsonReader& in, const NumberRange& speed, const NumberRange& strength) {
  if (!in.has("motor")) return std::nullopt;
  const JsonReader motor = in["motor"];
  motor.object({"speed", "strength"});
  return Motor{motor["speed"].number(speed), motor["strength"].number(strength)};
}

void write_motor(OrderedJson& into, const std::optional<Motor>& motor) {
  if (motor) into["motor"] = {{"speed", motor->speed}, {"strength", motor->strength}};
}

std::optional<Limits> read_limits(const JsonReader& in, const NumberRange& within, const char* of_what) {
  if (!in.has("limits")) return std::nullopt;
  const Vec range = in["limits"].vector(within);
  if (range.x > range.y) in["limits"].refuse("must be two " + std::string(of_what) + ", the lower one first");
  return Limits{range.x, range.y};
}

void write_limits(OrderedJson& into, const std::optional<Limits>& limits) {
  if (limits) into["limits"] = {limits->low, limits->high};
}

// Revolute

// A torque is a force at an arm, and a force is a mass times a length: masses and times stay.
Joint scaled_kind(Revolute joint, double factor) {
  joint.anchor = scaled(joint.anchor, factor);
  if (joint.motor) joint.motor->strength *= factor * factor;
  return joint;
}

Joint read_revolute(const JsonReader& in, const BodyNames& names) {
  in.object({"type", "bodies", "anchor"}, {"limits", "motor"});
  const auto [a, b] = names.find_two(in["bodies"]);
  Revolute joint{a, b, in["anchor"].vector(limits::coordinate)};
  joint.limits = read_limits(in, limits::angle, "angles");
  joint.motor = read_motor(in, limits::spin, limits::motor_torque);
  return joint;
}

OrderedJson kind_as_json(const Revolute& joint, const Scene& scene) {
  OrderedJson json{{"type", "revolute"}, {"bodies", joined_names(joint, scene)}, {"anchor", as_json(joint.anchor)}};
  write_limits(json, joint.limits);
  write_motor(json, joint.motor);
  return json;
}

// Distance

Joint scaled_kind(Distance joint, double factor) {
  joint.anchor_a = scaled(joint.anchor_a, factor);
  joint.anchor_b = scaled(joint.anchor_b, factor);
  joint.length *= factor;
  return joint;
}

Joint read_distance(const JsonReader& in, const BodyNames& names) {
  refuse_as_foreign(in, {"limits"}, "rope");
  in.object({"type", "bodies", "anchors", "length"}, {"stiffness", "damping"});
  const auto [a, b] = names.find_two(in["bodies"]);
  const auto [on_a, on_b] = read_anchors(in["anchors"]);
  return Distance{.a = a,
                  .b = b,
                  .anchor_a = on_a,
                  .anchor_b = on_b,
                  .length = in["length"].number(limits::size),
                  .stiffness = in.number("stiffness", 0, limits::stiffness),
                  .damping = in.number("damping", 0, limits::resistance)};
}

OrderedJson kind_as_json(const Distance& joint, const Scene& scene) {
  OrderedJson json{{"type", "distance"},
                   {"bodies", joined_names(joint, scene)},
                   {"anchors", {as_json(joint.anchor_a), as_json(joint.anchor_b)}},
                   {"length", joint.length}};
  write_unless(json, "stiffness", joint.stiffness, 0.0);
  write_unless(json, "damping", joint.damping, 0.0);
  return json;
}

// Prismatic

Joint scaled_kind(Prismatic joint, double factor) {
  joint.anchor = scaled(joint.anchor, factor);
  if (joint.limits) joint.limits = Limits{joint.limits->low * factor, joint.limits->high * factor};
  if (joint.motor) joint.motor = Motor{joint.motor->speed * factor, joint.motor->strength * factor};
  return joint;
}

Joint read_prismatic(const JsonReader& in, const BodyNames& names) {
  in.object({"type", "bodies", "anchor", "axis"}, {"limits", "motor"});
  const auto [a, b] = names.find_two(in["bodies"]);
  const Prismatic joint{a,
                        b,
                        in["anchor"].vector(limits::coordinate),
                        in["axis"].vector(limits::factor),
                        read_limits(in, limits::coordinate, "lengths"),
                        read_motor(in, limits::speed, limits::motor_force)};
  if (std::hypot(joint.axis.x, joint.axis.y) < limits::size.least) in["axis"].refuse("has no length");
  return joint;
}

OrderedJson kind_as_json(const Prismatic& joint, const Scene& scene) {
  OrderedJson json{{"type", "prismatic"},
                   {"bodies", joined_names(joint, scene)},
                   {"anchor", as_json(joint.anchor)},
                   {"axis", as_json(joint.axis)}};
  write_limits(json, joint.limits);
  write_motor(json, joint.motor);
  return json;
}

// Weld

Joint scaled_kind(Weld joint, double factor) {
  joint.anchor = scaled(joint.anchor, factor);
  return joint;
}

Joint read_weld(const JsonReader& in, const BodyNames& names) {
  in.object({"type", "bodies", "anchor"});
  const auto [a, b] = names.find_two(in["bodies"]);
  return Weld{a, b, in["anchor"].vector(limits::coordinate)};
}

OrderedJson kind_as_json(const Weld& joint, const Scene& scene) {
  return {{"type", "weld"}, {"bodies", joined_names(joint, scene)}, {"anchor", as_json(joint.anchor)}};
}

using ReadJoint = Joint (*)(const JsonReader&, const BodyNames&);
constexpr Word<ReadJoint> joint_kinds[] = {
    {"revolute", read_revolute}, {"distance", read_distance}, {"prismatic", read_prismatic}, {"weld", read_weld}};

}  // namespace

Joint scaled(const Joint& joint, double factor) {
  return std::visit([factor](const auto& kind) { return scaled_kind(kind, factor); }, joint);
}

const Limits* limits_of(const Joint& joint) {
  const auto pointer = [](const std::optional<Limits>& limits) { return limits ? &*limits : nullptr; };
  if (const auto* hinge = std::get_if<Revolute>(&joint)) return pointer(hinge->limits);
  if (const auto* slider = std::get_if<Prismatic>(&joint)) return pointer(slider->limits);
  return nullptr;
}

const Motor* motor_of(const Joint& joint) {
  const auto pointer = [](const std::optional<Motor>& motor) { return motor ? &*motor : nullptr; };
  if (const auto* hinge = std::get_if<Revolute>(&joint)) return pointer(hinge->motor);
  if (const auto* slider = std::get_if<Prismatic>(&joint)) return pointer(slider->motor);
  return nullptr;
}

Joint read_joint(const JsonReader& in, const BodyNames& names) { return in.kind<ReadJoint>(joint_kinds)(in, names); }

nlohmann::ordered_json as_json(const Joint& joint, const Scene& scene) {
  return std::visit([&scene](const auto& kind) { return kind_as_json(kind, scene); }, joint);
}

}  // namespace plumb
