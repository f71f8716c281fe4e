#include "scenarios/scene/joints.h"

#include "scenarios/scene/scene_fields.h"

namespace plumb {
namespace {

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

template <class Part>
const Part* pointer(const std::optional<Part>& part) {
  return part ? &*part : nullptr;
}

void write_limits(OrderedJson& into, const std::optional<Limits>& limits) {
  if (limits) into["limits"] = {limits->low, limits->high};
}

// Revolute

JointFacts facts_of_kind(const Revolute& joint) {
  return {.keeps = JointFacts::Keeps::point,
          .a = joint.a,
          .b = joint.b,
          .anchor_a = joint.anchor,
          .anchor_b = joint.anchor,
          .limits = pointer(joint.limits),
          .motor = pointer(joint.motor)};
}

Joint mapped_kind(Revolute joint, const JointMap& map) {
  joint.anchor = map.point(joint.a, joint.anchor);
  if (joint.limits && map.mirrored) joint.limits = Limits{-joint.limits->high, -joint.limits->low};
  if (joint.motor) {
    const double speed = map.mirrored ? -joint.motor->speed : joint.motor->speed;
    joint.motor = Motor{speed / map.units.time, joint.motor->strength * map.units.torque()};
  }
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

OrderedJson kind_as_json(const Revolute& joint) {
  OrderedJson json{{"anchor", as_json(joint.anchor)}};
  write_limits(json, joint.limits);
  write_motor(json, joint.motor);
  return json;
}

// Distance

JointFacts facts_of_kind(const Distance& joint) {
  return {.keeps = joint.stiffness > 0 ? JointFacts::Keeps::spring : JointFacts::Keeps::rod,
          .a = joint.a,
          .b = joint.b,
          .anchor_a = joint.anchor_a,
          .anchor_b = joint.anchor_b,
          .length = joint.length,
          .stiffness = joint.stiffness,
          .damping = joint.damping};
}

Joint mapped_kind(Distance joint, const JointMap& map) {
  joint.anchor_a = map.point(joint.a, joint.anchor_a);
  joint.anchor_b = map.point(joint.b, joint.anchor_b);
  joint.length *= map.units.length;
  joint.stiffness *= map.units.stiffness();
  joint.damping *= map.units.damping();
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

OrderedJson kind_as_json(const Distance& joint) {
  OrderedJson json{{"anchors", {as_json(joint.anchor_a), as_json(joint.anchor_b)}}, {"length", joint.length}};
  write_unless(json, "stiffness", joint.stiffness, 0.0);
  write_unless(json, "damping", joint.damping, 0.0);
  return json;
}

// Prismatic

JointFacts facts_of_kind(const Prismatic& joint) {
  return {.keeps = JointFacts::Keeps::line,
          .a = joint.a,
          .b = joint.b,
          .anchor_a = joint.anchor,
          .anchor_b = joint.anchor,
          .axis = joint.axis,
          .limits = pointer(joint.limits),
          .motor = pointer(joint.motor)};
}

Joint mapped_kind(Prismatic joint, const JointMap& map) {
  const Units& units = map.units;
  joint.anchor = map.point(joint.a, joint.anchor);
  joint.axis = map.direction(joint.a, joint.axis);
  if (joint.limits) joint.limits = Limits{joint.limits->low * units.length, joint.limits->high * units.length};
  if (joint.motor) joint.motor = Motor{joint.motor->speed * units.speed(), joint.motor->strength * units.force()};
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
  if (length(joint.axis) < limits::size.least) in["axis"].refuse("has no length");
  return joint;
}

OrderedJson kind_as_json(const Prismatic& joint) {
  OrderedJson json{{"anchor", as_json(joint.anchor)}, {"axis", as_json(joint.axis)}};
  write_limits(json, joint.limits);
  write_motor(json, joint.motor);
  return json;
}

// Weld

JointFacts facts_of_kind(const Weld& joint) {
  return {
      .keeps = JointFacts::Keeps::pose, .a = joint.a, .b = joint.b, .anchor_a = joint.anchor, .anchor_b = joint.anchor};
}

Joint mapped_kind(Weld joint, const JointMap& map) {
  joint.anchor = map.point(joint.a, joint.anchor);
  return joint;
}

Joint read_weld(const JsonReader& in, const BodyNames& names) {
  in.object({"type", "bodies", "anchor"});
  const auto [a, b] = names.find_two(in["bodies"]);
  return Weld{a, b, in["anchor"].vector(limits::coordinate)};
}

OrderedJson kind_as_json(const Weld& joint) { return {{"anchor", as_json(joint.anchor)}}; }

// In the order of Joint.
using ReadJoint = Joint (*)(const JsonReader&, const BodyNames&);
constexpr Word<ReadJoint> joint_kinds[] = {
    {"revolute", read_revolute}, {"distance", read_distance}, {"prismatic", read_prismatic}, {"weld", read_weld}};
static_assert(std::size(joint_kinds) == std::variant_size_v<Joint>);

}  // namespace

const char* kind_name(const Joint& joint) { return joint_kinds[joint.index()].word; }

JointFacts facts_of(const Joint& joint) {
  return std::visit([](const auto& kind) { return facts_of_kind(kind); }, joint);
}

Joint mapped(const Joint& joint, const JointMap& map) {
  return std::visit([&map](const auto& kind) { return mapped_kind(kind, map); }, joint);
}

Joint mapped(const Joint& joint, const Congruence& map) {
  return mapped(joint, JointMap{.point = [&map](std::size_t, Vec p) { return map.of_point(p); },
                                .direction = [&map](std::size_t, Vec v) { return map.of_vector(v); },
                                .mirrored = map.mirrored});
}

Joint in_units(const Joint& joint, const Units& units) {
  return mapped(joint, JointMap{.point = [&units](std::size_t, Vec p) { return units.length * p; },
                                .direction = [](std::size_t, Vec v) { return v; },
                                .units = units});
}

Joint read_joint(const JsonReader& in, const BodyNames& names) { return in.kind<ReadJoint>(joint_kinds)(in, names); }

nlohmann::ordered_json as_json(const Joint& joint, const Scene& scene) {
  const JointFacts facts = facts_of(joint);
  OrderedJson json{{"type", kind_name(joint)},
                   {"bodies", {scene.bodies.at(facts.a).name, scene.bodies.at(facts.b).name}}};
  json.update(std::visit([](const auto& kind) { return kind_as_json(kind); }, joint));
  return json;
}

}  // namespace plumb
