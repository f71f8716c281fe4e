#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "scenarios/scene/json_parse.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/scene_json.h"
#include "scenarios/scene/scene_limits.h"
#include "scenarios/scene/scene_words.h"
#include "scenarios/scene/shape_reader.h"

namespace plumb {
namespace {

using namespace scene_words;

// The bodies read so far, by name.
class Names {
 public:
  void add(const JsonReader& in, const std::string& name) {
    if (!places_.emplace(name, places_.size()).second) in.refuse("the name \"" + printable(name) + "\" is given twice");
  }

  std::size_t find(const JsonReader& in) const {
    const auto place = places_.find(in.text(1, limits::name));
    if (place != places_.end()) return place->second;
    std::vector<std::string> names;
    for (const auto& [name, index] : places_) names.push_back(printable(name));
    in.unknown_word(names, "body");
  }

 private:
  std::map<std::string, std::size_t> places_;
};

void must_not_move(const JsonReader& in, const Body& body) {
  if (body.velocity != Vec{}) in["velocity"].refuse("a static body has none");
  if (body.angular_velocity != 0) in["angularVelocity"].refuse("a static body has none");
}

// Enough for single precision to hold it, and one over it.
void must_have_mass(const JsonReader& in, const Body& body) {
  constexpr double least = 1e-30;  // kg, and kg m^2
  const Mass mass = mass_of(body);
  if (mass.mass >= least && (body.fixed_rotation || mass.inertia >= least)) return;
  in.refuse("a dynamic body needs mass: a circle, box, polygon or capsule with a density above 0");
}

Body read_body(const JsonReader& in, Names& names) {
  in.object({"name", "type", "position", "shapes"},
            {"angle", "velocity", "angularVelocity", "gravityScale", "fixedRotation", "bullet", "layers",
             "linearDamping", "angularDamping"});
  Body body{.name = in["name"].text(1, limits::name),
            .type = in["type"].one_of<BodyType>(body_types),
            .position = in["position"].vector(limits::coordinate),
            .angle = in.number("angle", 0, limits::angle),
            .velocity = in.vector("velocity", {}, limits::speed),
            .angular_velocity = in.number("angularVelocity", 0, limits::spin),
            .gravity_scale = in.number("gravityScale", 1, limits::factor),
            .fixed_rotation = in.boolean("fixedRotation", false),
            .bullet = in.boolean("bullet", false),
            .linear_damping = in.number("linearDamping", 0, limits::damping),
            .angular_damping = in.number("angularDamping", 0, limits::damping)};
  names.add(in["name"], body.name);
  if (in.has("layers")) {
    const double mask = in["layers"].number(limits::layers);
    if (mask != std::floor(mask)) in["layers"].expected("a whole number, one bit a layer");
    body.layers = static_cast<std::uint32_t>(mask);
  }
  const JsonReader shapes = in["shapes"];
  for (std::size_t i = 0; i < shapes.list(); ++i) body.shapes.push_back(read_shape(shapes[i]));
  if (body.type == BodyType::fixed) must_not_move(in, body);
  if (body.type == BodyType::dynamic) must_have_mass(in, body);
  return body;
}

struct Context {
  const Scene& scene;
  const Names& names;

  std::pair<std::size_t, std::size_t> two(const JsonReader& in) const {
    if (in.list() != 2) in.expected("a list of two bodies");
    const std::size_t a = names.find(in[std::size_t{0}]);
    const std::size_t b = names.find(in[std::size_t{1}]);
    if (a == b) in.refuse("is one body twice");
    if (!dynamic(a) && !dynamic(b)) in.refuse("expected a dynamic body among the two");
    return {a, b};
  }

  std::size_t one_dynamic(const JsonReader& in) const {
    const std::size_t body = names.find(in);
    if (!dynamic(body)) in.expected("a dynamic body");
    return body;
  }

  bool dynamic(std::size_t body) const { return scene.bodies[body].type == BodyType::dynamic; }
};

std::pair<Vec, Vec> read_anchors(const JsonReader& in) {
  if (in.list() != 2) in.expected("a list of two points");
  return {in[std::size_t{0}].vector(limits::coordinate), in[std::size_t{1}].vector(limits::coordinate)};
}

Joint revolute(const JsonReader& in, const Context& of) {
  in.object({"type", "bodies", "anchor"});
  const auto [a, b] = of.two(in["bodies"]);
  return Revolute{a, b, in["anchor"].vector(limits::coordinate)};
}

Joint distance(const JsonReader& in, const Context& of) {
  in.object({"type", "bodies", "anchors", "length"}, {"stiffness", "damping"});
  const auto [a, b] = of.two(in["bodies"]);
  const auto [on_a, on_b] = read_anchors(in["anchors"]);
  return Distance{.a = a,
                  .b = b,
                  .anchor_a = on_a,
                  .anchor_b = on_b,
                  .length = in["length"].number(limits::size),
                  .stiffness = in.number("stiffness", 0, limits::stiffness),
                  .damping = in.number("damping", 0, limits::resistance)};
}

Joint prismatic(const JsonReader& in, const Context& of) {
  in.object({"type", "bodies", "anchor", "axis"});
  const auto [a, b] = of.two(in["bodies"]);
  const Prismatic joint{a, b, in["anchor"].vector(limits::coordinate), in["axis"].vector(limits::factor)};
  if (std::hypot(joint.axis.x, joint.axis.y) < limits::size.least) in["axis"].refuse("points nowhere");
  return joint;
}

Joint weld(const JsonReader& in, const Context& of) {
  in.object({"type", "bodies", "anchor"});
  const auto [a, b] = of.two(in["bodies"]);
  return Weld{a, b, in["anchor"].vector(limits::coordinate)};
}

using ReadJoint = Joint (*)(const JsonReader&, const Context&);
constexpr Word<ReadJoint> joint_kinds[] = {
    {"revolute", revolute}, {"distance", distance}, {"prismatic", prismatic}, {"weld", weld}};

Force attraction(const JsonReader& in, const Context& of) {
  in.object({"type", "from", "strength"}, {"exponent", "mutual"});
  return Attraction{.from = of.names.find(in["from"]),
                    .strength = in["strength"].number(limits::strength),
                    .exponent = in.number("exponent", 2, limits::exponent),
                    .mutual = in.boolean("mutual", false)};
}

// Between two bodies, or between a point of the world and a body.
Force spring(const JsonReader& in, const Context& of) {
  Spring spring;
  if (in.has("bodies")) {
    in.object({"type", "bodies", "anchors", "stiffness", "length"}, {"damping"});
    std::tie(spring.a, spring.b) = of.two(in["bodies"]);
    std::tie(spring.anchor_a, spring.anchor_b) = read_anchors(in["anchors"]);
  } else {
    in.object({"type", "body", "anchor", "stiffness", "length"}, {"bodyAnchor", "damping"});
    spring.b = of.one_dynamic(in["body"]);
    spring.anchor_a = in["anchor"].vector(limits::coordinate);
    spring.anchor_b = in.vector("bodyAnchor", {}, limits::coordinate);
  }
  spring.stiffness = in["stiffness"].number(limits::stiffness);
  spring.length = in["length"].number(limits::length);
  spring.damping = in.number("damping", 0, limits::resistance);
  return spring;
}

Force constant(const JsonReader& in, const Context& of) {
  in.object({"type", "body", "force"}, {"torque"});
  return Constant{.body = of.one_dynamic(in["body"]),
                  .force = in["force"].vector(limits::force),
                  .torque = in.number("torque", 0, limits::torque)};
}

using ReadForce = Force (*)(const JsonReader&, const Context&);
constexpr Word<ReadForce> force_kinds[] = {{"attraction", attraction}, {"spring", spring}, {"constant", constant}};

Mixing read_mixing(const JsonReader& in) {
  in.object({}, {"friction", "restitution"});
  Mixing mixing;
  if (in.has("friction")) mixing.friction = in["friction"].one_of<FrictionMixing>(friction_rules);
  if (in.has("restitution")) mixing.restitution = in["restitution"].one_of<RestitutionMixing>(restitution_rules);
  return mixing;
}

StatedTruth read_truth(const JsonReader& in, const Context& of) {
  in.object({"quantity", "time", "value", "tolerance", "source"}, {"body"});
  StatedTruth truth{.quantity = in["quantity"].one_of<Quantity>(quantities),
                    .value = in["value"].number(limits::reading),
                    .tolerance = in["tolerance"].number(limits::tolerance),
                    .source = in["source"].text(1, limits::text)};
  const JsonReader time = in["time"];
  if (time.value() != "end") {
    if (!time.value().is_number()) time.expected("a time in s, or \"end\"");
    truth.time = time.number({0, of.scene.duration, "s"});
  }
  if (of_whole_scene(truth.quantity)) {
    if (in.has("body"))
      in["body"].refuse("belongs to no body: " + std::string(name_of(truth.quantity)) + " is that of the whole scene");
  } else {
    if (!in.has("body"))
      in.refuse("the key \"body\" is missing: " + std::string(name_of(truth.quantity)) + " of what?");
    truth.body = of.scene.bodies[of.names.find(in["body"])].name;
  }
  return truth;
}

template <class T, class Read>
void read_list(const JsonReader& in, const char* key, std::vector<T>& into, Read read) {
  if (!in.has(key)) return;
  const JsonReader list = in[key];
  const std::size_t size = list.list();
  for (std::size_t i = 0; i < size; ++i) into.push_back(read(list[i]));
}

// Told before anything else: the keys of another version may be others.
void must_be_ours(const JsonReader& in) {
  in.must_have("plumb");
  const JsonReader version = in["plumb"];
  if (version.value() != format) version.expected("1, the version of the format that this Plumb knows");
}

}  // namespace

SceneFile read_scene(std::string_view text, std::string_view file) {
  if (text.size() > largest_scene_file) JsonReader({}, file).refuse("the file is larger than 16 MiB");
  const nlohmann::json json = parse_json(text, file);
  const JsonReader in(json, file);
  must_be_ours(in);
  in.object({"plumb", "name", "gravity", "duration", "bodies"}, {"about", "mixing", "joints", "forces", "truth"});
  SceneFile read;
  Scene& scene = read.scene;
  scene.name = in["name"].text(1, limits::name);
  if (in.has("about")) scene.about = in["about"].text(0, limits::text);
  scene.gravity = in["gravity"].vector(limits::acceleration);
  scene.duration = in["duration"].number(limits::duration);
  if (in.has("mixing")) scene.mixing = read_mixing(in["mixing"]);

  Names names;
  const Context context{scene, names};
  read_list(in, "bodies", scene.bodies, [&](const JsonReader& body) { return read_body(body, names); });
  if (scene.bodies.empty()) in["bodies"].refuse("expected a body, found none");
  read_list(in, "joints", scene.joints,
            [&](const JsonReader& joint) { return joint.kind<ReadJoint>(joint_kinds)(joint, context); });
  read_list(in, "forces", scene.forces,
            [&](const JsonReader& force) { return force.kind<ReadForce>(force_kinds)(force, context); });
  read_list(in, "truth", read.truth, [&](const JsonReader& truth) { return read_truth(truth, context); });
  return read;
}

}  // namespace plumb
