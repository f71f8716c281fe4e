#include "scenarios/scene/forces.h"

#include <cmath>
#include <tuple>

#include "scenarios/scene/scene_fields.h"

namespace plumb {
namespace {

using Index = std::function<std::size_t(std::size_t)>;

OrderedJson body_name(std::size_t body, const Scene& scene) { return scene.bodies.at(body).name; }

// Attraction

Force mapped_kind(const Attraction& force, const Congruence&) { return force; }

// m^(1 + exponent)/s^2
Force in_units_kind(Attraction force, const Units& units) {
  force.strength *= std::pow(units.length, force.exponent) * units.acceleration();
  return force;
}

Force renumbered_kind(Attraction force, const Index& index) {
  force.from = index(force.from);
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

Force mapped_kind(Spring force, const Congruence& map) {
  const FrameMap frame{.mirrored = map.mirrored};
  force.anchor_a = force.a ? frame.of_point(force.anchor_a) : map.of_point(force.anchor_a);
  force.anchor_b = frame.of_point(force.anchor_b);
  return force;
}

Force in_units_kind(Spring force, const Units& units) {
  force.anchor_a = units.length * force.anchor_a;
  force.anchor_b = units.length * force.anchor_b;
  force.length *= units.length;
  force.stiffness *= units.stiffness();
  force.damping *= units.damping();
  return force;
}

Force renumbered_kind(Spring force, const Index& index) {
  if (force.a) force.a = index(*force.a);
  force.b = index(force.b);
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

Force mapped_kind(Constant force, const Congruence& map) {
  force.force = map.of_vector(force.force);
  force.torque = map.of_spin(force.torque);
  return force;
}

Force in_units_kind(Constant force, const Units& units) {
  force.force = units.force() * force.force;
  force.torque *= units.torque();
  return force;
}

Force renumbered_kind(Constant force, const Index& index) {
  force.body = index(force.body);
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

Force mapped(const Force& force, const Congruence& map) {
  return std::visit([&map](const auto& kind) { return mapped_kind(kind, map); }, force);
}

Force in_units(const Force& force, const Units& units) {
  return std::visit([&units](const auto& kind) { return in_units_kind(kind, units); }, force);
}

Force renumbered(const Force& force, const Index& index) {
  return std::visit([&index](const auto& kind) { return renumbered_kind(kind, index); }, force);
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
