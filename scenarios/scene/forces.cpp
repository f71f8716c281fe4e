#include "scenarios/scene/forces.h"

#include <cmath>
#include <tuple>

#include "scenarios/scene/scene_fields.h"
#include "scenarios/scene/shapes.h"

namespace plumb {
namespace {

OrderedJson body_name(std::size_t body, const Scene& scene) { return scene.bodies.at(body).name; }

// Attraction

Force scaled_kind(Attraction force, double factor) {
  force.strength *= std::pow(factor, 1 + force.exponent);
  return force;
}

Force read_attraction(const JsonReader& in, const BodyNames& names) {
  in.object({"type", "from", "strength"}, {"exponent", "mutual"});
  return Attraction{.from = names.find(in["from"]),
                    .strength = in["strength"].number(limits::strength),
                    .exponent = in.number("exponent", 2, limits::exponent),
                    .mutual = in.boolean("mutual", false)};
}

OrderedJson kind_as_json(const Attraction& force, const Scene& scene) {
  OrderedJson json{{"type", "attraction"}, {"from", body_name(force.from, scene)}, {"strength", force.strength}};
  json["exponent"] = force.exponent;
  if (force.mutual) json["mutual"] = true;
  return json;
}

// Spring

Force scaled_kind(Spring force, double factor) {
  force.anchor_a = scaled(force.anchor_a, factor);
  force.anchor_b = scaled(force.anchor_b, factor);
  force.length *= factor;
  return force;
}

// Between two bodies, or between a fixed point of the world and a body.
Force read_spring(const JsonReader& in, const BodyNames& names) {
  Spring spring;
  if (in.has("bodies")) {
    in.object({"type", "bodies", "anchors", "stiffness", "length"}, {"damping"});
    std::tie(spring.a, spring.b) = names.find_two(in["bodies"]);
    std::tie(spring.anchor_a, spring.anchor_b) = read_anchors(in["anchors"]);
  } else {
    in.object({"type", "body", "anchor", "stiffness", "length"}, {"bodyAnchor", "damping"});
    spring.b = names.find_dynamic(in["body"]);
    spring.anchor_a = in["anchor"].vector(limits::coordinate);
    spring.anchor_b = in.vector("bodyAnchor", {}, limits::coordinate);
  }
  spring.stiffness = in["stiffness"].number(limits::stiffness);
  spring.length = in["length"].number(limits::length);
  spring.damping = in.number("damping", 0, limits::resistance);
  return spring;
}

OrderedJson kind_as_json(const Spring& force, const Scene& scene) {
  OrderedJson json{{"type", "spring"}};
  if (force.a) {
    json["bodies"] = {body_name(*force.a, scene), body_name(force.b, scene)};
    json["anchors"] = {as_json(force.anchor_a), as_json(force.anchor_b)};
  } else {
    json["body"] = body_name(force.b, scene);
    json["anchor"] = as_json(force.anchor_a);
    write_unless(json, "bodyAnchor", force.anchor_b, {});
  }
  json["stiffness"] = force.stiffness;
  json["length"] = force.length;
  write_unless(json, "damping", force.damping, 0.0);
  return json;
}

// Constant

Force scaled_kind(Constant force, double factor) {
  force.force = scaled(force.force, factor);
  force.torque *= factor * factor;
  return force;
}

Force read_constant(const JsonReader& in, const BodyNames& names) {
  in.object({"type", "body", "force"}, {"torque"});
  return Constant{.body = names.find_dynamic(in["body"]),
                  .force = in["force"].vector(limits::force),
                  .torque = in.number("torque", 0, limits::torque)};
}

OrderedJson kind_as_json(const Constant& force, const Scene& scene) {
  OrderedJson json{{"type", "constant"}, {"body", body_name(force.body, scene)}, {"force", as_json(force.force)}};
  write_unless(json, "torque", force.torque, 0.0);
  return json;
}

using ReadForce = Force (*)(const JsonReader&, const BodyNames&);
constexpr Word<ReadForce> force_kinds[] = {
    {"attraction", read_attraction}, {"spring", read_spring}, {"constant", read_constant}};

}  // namespace

Force scaled(const Force& force, double factor) {
  return std::visit([factor](const auto& kind) { return scaled_kind(kind, factor); }, force);
}

Force read_force(const JsonReader& in, const BodyNames& names) {
  refuse_as_foreign(in,
                    {"time", "times", "at", "start", "begin", "end", "duration", "frequency", "amplitude", "period",
                     "phase", "path", "keyframes", "table", "function"},
                    "periodic");
  return in.kind<ReadForce>(force_kinds)(in, names);
}

nlohmann::ordered_json as_json(const Force& force, const Scene& scene) {
  return std::visit([&scene](const auto& kind) { return kind_as_json(kind, scene); }, force);
}

}  // namespace plumb
