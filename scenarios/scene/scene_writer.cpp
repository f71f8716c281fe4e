#include <bit>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <variant>

#include "scenarios/scene/json_parse.h"
#include "scenarios/scene/scene_json.h"
#include "scenarios/scene/scene_words.h"

namespace plumb {
namespace {

using namespace scene_words;
using OrderedJson = nlohmann::ordered_json;

constexpr std::size_t width = 120;  // columns at most, where a line can be broken

// By their bits: -0 is not left out where 0 is the default.
bool same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }
bool same(Vec a, Vec b) { return same(a.x, b.x) && same(a.y, b.y); }
template <class T>
bool same(T a, T b) {
  return a == b;
}

OrderedJson of(Vec v) { return {v.x, v.y}; }
template <class T>
OrderedJson of(T value) {
  return value;
}

// Leaves out what a reader supplies.
template <class T>
void add(OrderedJson& into, const char* key, T value, T otherwise) {
  if (!same(value, otherwise)) into[key] = of(value);
}

struct GeometryToJson {
  OrderedJson operator()(const Circle& circle) const {
    OrderedJson json{{"type", "circle"}, {"radius", circle.radius}};
    add(json, "center", circle.center, {});
    return json;
  }
  OrderedJson operator()(const Box& box) const {
    OrderedJson json{{"type", "box"}, {"size", of(box.size)}};
    add(json, "center", box.center, {});
    add(json, "angle", box.angle, 0.0);
    return json;
  }
  OrderedJson operator()(const Polygon& polygon) const {
    OrderedJson vertices = OrderedJson::array();
    for (const Vec& vertex : polygon.vertices) vertices.push_back(of(vertex));
    return {{"type", "polygon"}, {"vertices", std::move(vertices)}};
  }
  OrderedJson operator()(const Capsule& capsule) const {
    return {{"type", "capsule"}, {"from", of(capsule.from)}, {"to", of(capsule.to)}, {"radius", capsule.radius}};
  }
  OrderedJson operator()(const Segment& segment) const {
    return {{"type", "segment"}, {"from", of(segment.from)}, {"to", of(segment.to)}};
  }
  OrderedJson operator()(const HalfSpace& half_space) const {
    return {{"type", "halfspace"}, {"normal", of(half_space.normal)}, {"offset", half_space.offset}};
  }
};

OrderedJson of(const Shape& shape) {
  const Surface& surface = shape.surface;
  OrderedJson json = std::visit(GeometryToJson{}, shape.geometry);
  json["density"] = surface.density;
  if (same(surface.static_friction, surface.dynamic_friction)) {
    json["friction"] = surface.static_friction;
  } else {
    json["friction"] = {{"static", surface.static_friction}, {"dynamic", surface.dynamic_friction}};
  }
  json["restitution"] = surface.restitution;
  return json;
}

OrderedJson of(const Body& body) {
  OrderedJson json{{"name", body.name}, {"type", word_for(body_types, body.type)}, {"position", of(body.position)}};
  const Body plain;
  add(json, "angle", body.angle, plain.angle);
  add(json, "velocity", body.velocity, plain.velocity);
  add(json, "angularVelocity", body.angular_velocity, plain.angular_velocity);
  add(json, "gravityScale", body.gravity_scale, plain.gravity_scale);
  add(json, "fixedRotation", body.fixed_rotation, plain.fixed_rotation);
  add(json, "bullet", body.bullet, plain.bullet);
  add(json, "layers", body.layers, plain.layers);
  add(json, "linearDamping", body.linear_damping, plain.linear_damping);
  add(json, "angularDamping", body.angular_damping, plain.angular_damping);
  OrderedJson shapes = OrderedJson::array();
  for (const Shape& shape : body.shapes) shapes.push_back(of(shape));
  json["shapes"] = std::move(shapes);
  return json;
}

// Joints and forces, whose bodies are called by name.
struct LinkToJson {
  const Scene& scene;

  OrderedJson name(std::size_t body) const { return scene.bodies.at(body).name; }
  OrderedJson names(std::size_t a, std::size_t b) const { return {name(a), name(b)}; }

  OrderedJson operator()(const Revolute& joint) const {
    return {{"type", "revolute"}, {"bodies", names(joint.a, joint.b)}, {"anchor", of(joint.anchor)}};
  }
  OrderedJson operator()(const Distance& joint) const {
    OrderedJson json{{"type", "distance"},
                     {"bodies", names(joint.a, joint.b)},
                     {"anchors", {of(joint.anchor_a), of(joint.anchor_b)}},
                     {"length", joint.length}};
    add(json, "stiffness", joint.stiffness, 0.0);
    add(json, "damping", joint.damping, 0.0);
    return json;
  }
  OrderedJson operator()(const Prismatic& joint) const {
    return {{"type", "prismatic"},
            {"bodies", names(joint.a, joint.b)},
            {"anchor", of(joint.anchor)},
            {"axis", of(joint.axis)}};
  }
  OrderedJson operator()(const Weld& joint) const {
    return {{"type", "weld"}, {"bodies", names(joint.a, joint.b)}, {"anchor", of(joint.anchor)}};
  }
  OrderedJson operator()(const Attraction& force) const {
    OrderedJson json{{"type", "attraction"}, {"from", name(force.from)}, {"strength", force.strength}};
    json["exponent"] = force.exponent;
    add(json, "mutual", force.mutual, false);
    return json;
  }
  OrderedJson operator()(const Spring& force) const {
    OrderedJson json{{"type", "spring"}};
    if (force.a) {
      json["bodies"] = names(*force.a, force.b);
      json["anchors"] = {of(force.anchor_a), of(force.anchor_b)};
    } else {
      json["body"] = name(force.b);
      json["anchor"] = of(force.anchor_a);
      add(json, "bodyAnchor", force.anchor_b, {});
    }
    json["stiffness"] = force.stiffness;
    json["length"] = force.length;
    add(json, "damping", force.damping, 0.0);
    return json;
  }
  OrderedJson operator()(const Constant& force) const {
    OrderedJson json{{"type", "constant"}, {"body", name(force.body)}, {"force", of(force.force)}};
    add(json, "torque", force.torque, 0.0);
    return json;
  }
};

OrderedJson of(const StatedTruth& truth) {
  OrderedJson json = OrderedJson::object();
  if (!truth.body.empty()) json["body"] = truth.body;
  json["quantity"] = name_of(truth.quantity);
  json["time"] = truth.time ? OrderedJson(*truth.time) : OrderedJson("end");
  json["value"] = truth.value;
  json["tolerance"] = truth.tolerance;
  json["source"] = truth.source;
  return json;
}

template <class Items, class ToJson>
void add_list(OrderedJson& into, const char* key, const Items& items, ToJson to) {
  if (items.empty()) return;
  OrderedJson& list = into[key] = OrderedJson::array();
  for (const auto& item : items) list.push_back(to(item));
}

std::string key_of(const std::string& key) { return OrderedJson(key).dump() + ": "; }

std::string in_one_line(const OrderedJson& json) {
  if (!json.is_structured()) return json.dump();
  std::string out;
  for (const auto& item : json.items()) {
    out += out.empty() ? "" : ", ";
    if (json.is_object()) out += key_of(item.key());
    out += in_one_line(item.value());
  }
  return json.is_object() ? "{" + out + "}" : "[" + out + "]";
}

// On one line where that fits, else a line for each of its parts. `taken` counts the columns before it.
void lay_out(const OrderedJson& json, std::size_t indent, std::size_t taken, std::string& out) {
  const std::string line = in_one_line(json);
  if (!json.is_structured() || json.empty() || taken + line.size() < width) {
    out += line;
    return;
  }
  const std::string margin(indent + 2, ' ');
  const char* separator = "\n";
  out += json.is_object() ? '{' : '[';
  for (const auto& item : json.items()) {
    const std::string key = json.is_object() ? key_of(item.key()) : "";
    out.append(separator).append(margin).append(key);
    lay_out(item.value(), indent + 2, margin.size() + key.size(), out);
    separator = ",\n";
  }
  out.append("\n").append(indent, ' ') += json.is_object() ? '}' : ']';
}

}  // namespace

std::string write_scene(const SceneFile& file) {
  const Scene& scene = file.scene;
  OrderedJson json{{"plumb", format}, {"name", scene.name}};
  if (!scene.about.empty()) json["about"] = scene.about;
  json["gravity"] = of(scene.gravity);
  json["duration"] = scene.duration;
  json["mixing"] = {{"friction", word_for(friction_rules, scene.mixing.friction)},
                    {"restitution", word_for(restitution_rules, scene.mixing.restitution)}};
  const LinkToJson link{scene};
  const auto visit = [&](const auto& kind) { return std::visit(link, kind); };
  add_list(json, "bodies", scene.bodies, [](const Body& body) { return of(body); });
  add_list(json, "joints", scene.joints, visit);
  add_list(json, "forces", scene.forces, visit);
  add_list(json, "truth", file.truth, [](const StatedTruth& truth) { return of(truth); });

  std::string text;
  try {
    lay_out(json, 0, 0, text);
  } catch (const OrderedJson::type_error&) {
    throw std::invalid_argument(printable(scene.name) + ": top level: a text in it is not UTF-8");
  }
  text += '\n';
  // Nothing is handed out that could not be taken back: a number that is not finite, a name that is there twice.
  read_scene(text, scene.name);
  return text;
}

}  // namespace plumb
