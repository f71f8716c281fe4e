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

template <class OneAnchor>
Joint scaled_kind(OneAnchor joint, double factor) {
  joint.anchor = scaled(joint.anchor, factor);
  return joint;
}

// Revolute

Joint read_revolute(const JsonReader& in, const BodyNames& names) {
  in.object({"type", "bodies", "anchor"}, {"limits"});
  const auto [a, b] = names.find_two(in["bodies"]);
  Revolute joint{a, b, in["anchor"].vector(limits::coordinate)};
  if (in.has("limits")) {
    const Vec range = in["limits"].vector(limits::angle);
    if (range.x > range.y) in["limits"].refuse("must be two angles, the lower one first");
    joint.limits = AngleLimits{range.x, range.y};
  }
  return joint;
}

OrderedJson kind_as_json(const Revolute& joint, const Scene& scene) {
  OrderedJson json{{"type", "revolute"}, {"bodies", joined_names(joint, scene)}, {"anchor", as_json(joint.anchor)}};
  if (joint.limits) json["limits"] = {joint.limits->low, joint.limits->high};
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

Joint read_prismatic(const JsonReader& in, const BodyNames& names) {
  in.object({"type", "bodies", "anchor", "axis"});
  const auto [a, b] = names.find_two(in["bodies"]);
  const Prismatic joint{a, b, in["anchor"].vector(limits::coordinate), in["axis"].vector(limits::factor)};
  if (std::hypot(joint.axis.x, joint.axis.y) < limits::size.least) in["axis"].refuse("has no length");
  return joint;
}

OrderedJson kind_as_json(const Prismatic& joint, const Scene& scene) {
  return {{"type", "prismatic"},
          {"bodies", joined_names(joint, scene)},
          {"anchor", as_json(joint.anchor)},
          {"axis", as_json(joint.axis)}};
}

// Weld

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

Joint read_joint(const JsonReader& in, const BodyNames& names) { return in.kind<ReadJoint>(joint_kinds)(in, names); }

nlohmann::ordered_json as_json(const Joint& joint, const Scene& scene) {
  return std::visit([&scene](const auto& kind) { return kind_as_json(kind, scene); }, joint);
}

}  // namespace plumb
