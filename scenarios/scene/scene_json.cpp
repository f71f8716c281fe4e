#include "scenarios/scene/scene_json.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "scenarios/scene/forces.h"
#include "scenarios/scene/joints.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/scene_fields.h"
#include "scenarios/scene/shapes.h"

namespace plumb {
namespace {

constexpr int format = 1;  // version of scene files; increased when a reader of the old format would misread a new file

constexpr Word<BodyType> body_types[] = {
    {"static", BodyType::fixed}, {"kinematic", BodyType::kinematic}, {"dynamic", BodyType::dynamic}};

constexpr Word<FrictionMixing> friction_rules[] = {{"geometric", FrictionMixing::geometric},
                                                   {"pythagorean", FrictionMixing::pythagorean},
                                                   {"average", FrictionMixing::average},
                                                   {"min", FrictionMixing::min},
                                                   {"max", FrictionMixing::max},
                                                   {"multiply", FrictionMixing::multiply}};

constexpr Word<RestitutionMixing> restitution_rules[] = {{"max", RestitutionMixing::max},
                                                         {"min", RestitutionMixing::min},
                                                         {"average", RestitutionMixing::average},
                                                         {"multiply", RestitutionMixing::multiply}};

const Word<Quantity> quantities[] = {{name_of(Quantity::x), Quantity::x},
                                     {name_of(Quantity::y), Quantity::y},
                                     {name_of(Quantity::angle), Quantity::angle},
                                     {name_of(Quantity::vx), Quantity::vx},
                                     {name_of(Quantity::vy), Quantity::vy},
                                     {name_of(Quantity::speed), Quantity::speed},
                                     {name_of(Quantity::angular_velocity), Quantity::angular_velocity},
                                     {name_of(Quantity::energy), Quantity::energy},
                                     {name_of(Quantity::momentum_x), Quantity::momentum_x},
                                     {name_of(Quantity::momentum_y), Quantity::momentum_y},
                                     {name_of(Quantity::angular_momentum), Quantity::angular_momentum},
                                     {name_of(Quantity::speed_spread), Quantity::speed_spread},
                                     {name_of(Quantity::load), Quantity::load},
                                     {name_of(Quantity::energy_rise), Quantity::energy_rise},
                                     {name_of(Quantity::landing), Quantity::landing},
                                     {name_of(Quantity::apex), Quantity::apex}};

constexpr Word<Posed> posed_words[] = {{"well", Posed::well},
                                       {"ambiguous", Posed::ambiguous},
                                       {"impossible", Posed::impossible},
                                       {"overlapping", Posed::overlapping}};

const Word<Relation> relations[] = {{name_of(Relation::equal), Relation::equal},
                                    {name_of(Relation::at_least), Relation::at_least},
                                    {name_of(Relation::at_most), Relation::at_most}};

bool is_counted(Quantity quantity) { return quantity == Quantity::apex || quantity == Quantity::landing; }

bool has_no_body(Quantity quantity) {
  return of_whole_scene(quantity) || quantity == Quantity::speed_spread || quantity == Quantity::energy_rise;
}

constexpr std::size_t width = 120;  // columns at most, if a line can be broken

void check_static_body(const JsonReader& in, const Body& body) {
  if (body.velocity != Vec{}) in["velocity"].refuse("must be 0 for a static body");
  if (body.angular_velocity != 0) in["angularVelocity"].refuse("must be 0 for a static body");
}

// Large enough for single precision to represent it and its inverse.
void check_mass(const JsonReader& in, const Body& body) {
  constexpr double least = 1e-30;  // kg, and kg m^2
  const Mass mass = mass_of(body);
  if (mass.mass >= least && (body.fixed_rotation || mass.inertia >= least)) return;
  in.refuse("a dynamic body needs mass: a circle, box, polygon or capsule with a density above 0");
}

Path read_path(const JsonReader& in, BodyType type) {
  if (type != BodyType::kinematic) in.refuse("must be absent: only kinematic bodies have paths");
  in.object({"type", "amplitude", "frequency"}, {"phase"});
  if (in["type"].value() != "sinusoidal") in["type"].expected("\"sinusoidal\"");
  return {in["amplitude"].vector(limits::amplitude), in["frequency"].number(limits::frequency),
          in.number("phase", 0, limits::angle)};
}

Body read_body(const JsonReader& in, BodyNames& names) {
  in.object({"name", "type", "shapes"},
            {"position", "angle", "velocity", "angularVelocity", "gravityScale", "fixedRotation", "bullet", "layers",
             "linearDamping", "angularDamping", "path"});
  Body body{.name = in["name"].text(1, limits::name),
            .type = in["type"].one_of<BodyType>(body_types),
            .position = in.vector("position", {}, limits::coordinate),
            .angle = in.number("angle", 0, limits::angle),
            .velocity = in.vector("velocity", {}, limits::speed),
            .angular_velocity = in.number("angularVelocity", 0, limits::spin),
            .gravity_scale = in.number("gravityScale", 1, limits::factor),
            .fixed_rotation = in.boolean("fixedRotation", false),
            .bullet = in.boolean("bullet", false),
            .linear_damping = in.number("linearDamping", 0, limits::damping),
            .angular_damping = in.number("angularDamping", 0, limits::damping)};
  names.add(in["name"], body.name);
  if (in.has("path")) body.path = read_path(in["path"], body.type);
  if (in.has("layers")) {
    const double mask = in["layers"].number(limits::layers);
    if (mask != std::floor(mask)) in["layers"].expected("a whole number, one bit per layer");
    body.layers = static_cast<std::uint32_t>(mask);
  }
  const JsonReader shapes = in["shapes"];
  if (shapes.list() > limits::shapes)
    shapes.expected("at most " + std::to_string(limits::shapes) + " shapes: spread them over several bodies");
  for (std::size_t i = 0; i < shapes.list(); ++i) body.shapes.push_back(read_shape(shapes[i]));
  if (body.type == BodyType::fixed) check_static_body(in, body);
  if (body.type == BodyType::dynamic) check_mass(in, body);
  return body;
}

Mixing read_mixing(const JsonReader& in) {
  in.object({}, {"friction", "restitution"});
  Mixing mixing;
  if (in.has("friction")) mixing.friction = in["friction"].one_of<FrictionMixing>(friction_rules);
  if (in.has("restitution")) mixing.restitution = in["restitution"].one_of<RestitutionMixing>(restitution_rules);
  return mixing;
}

Origin read_origin(const JsonReader& in) {
  in.object({"engine"}, {"posed"});
  Origin origin{.engine = in["engine"].text(1, limits::text)};
  if (in.has("posed")) origin.posed = in["posed"].one_of<Posed>(posed_words);
  return origin;
}

// What only some quantities have: which extremum, an averaging interval, the other body of a contact.
void read_details(const JsonReader& in, const BodyNames& names, const Scene& scene, StatedTruth& truth) {
  const std::string quantity = name_of(truth.quantity);
  if (is_counted(truth.quantity)) {
    in.must_have("index");
    const double index = in["index"].number({1, 1e6, ""});
    if (index != std::floor(index)) in["index"].expected("a whole number, counted from 1");
    truth.index = static_cast<int>(index);
  } else if (in.has("index")) {
    in["index"].refuse("must be absent: there is one " + quantity + " at a time");
  }
  if (in.has("over")) {
    if (is_counted(truth.quantity) || truth.quantity == Quantity::energy_rise)
      in["over"].refuse("must be absent: " + quantity + " has no mean");
    truth.over = in["over"].number({0, scene.duration, "s"});
  }
  if (in.has("with")) {
    if (truth.quantity != Quantity::load) in["with"].refuse("must be absent: " + quantity + " is of one body");
    truth.with = scene.bodies[names.find(in["with"])].name;
  }
  if (in.has("relation")) truth.relation = in["relation"].one_of<Relation>(relations);
}

StatedTruth read_truth(const JsonReader& in, const Scene& scene, const BodyNames& names) {
  in.object({"quantity", "time", "value", "source"},
            {"body", "tolerance", "toleranceOf", "relation", "over", "index", "with"});
  StatedTruth truth{.quantity = in["quantity"].one_of<Quantity>(quantities),
                    .value = in["value"].number(limits::reading),
                    .source = in["source"].text(1, limits::text)};
  if (in.has("toleranceOf")) {
    if (in.has("tolerance")) in["tolerance"].refuse("must be absent: the tolerance is that of \"toleranceOf\"");
    truth.tolerance_of = in["toleranceOf"].text(1, limits::text);
  } else {
    in.must_have("tolerance");
    truth.tolerance = in["tolerance"].number(limits::tolerance);
  }
  const JsonReader time = in["time"];
  if (time.value() != "end") {
    if (!time.value().is_number()) time.expected("a time in s, or \"end\"");
    truth.time = time.number({0, scene.duration, "s"});
  }
  read_details(in, names, scene, truth);
  if (has_no_body(truth.quantity)) {
    if (in.has("body"))
      in["body"].refuse("must be absent: " + std::string(name_of(truth.quantity)) +
                        " is a quantity of the whole scene");
  } else {
    if (!in.has("body"))
      in.refuse("the key \"body\" is missing: " + std::string(name_of(truth.quantity)) + " of what?");
    truth.body = scene.bodies[names.find(in["body"])].name;
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

// Checked first: another version may have other keys.
void check_format(const JsonReader& in) {
  in.must_have("plumb");
  const JsonReader version = in["plumb"];
  if (version.value() != format) version.expected("1, the version of the format that this Plumb reads");
}

OrderedJson body_as_json(const Body& body) {
  OrderedJson json{
      {"name", body.name}, {"type", word_for(body_types, body.type)}, {"position", as_json(body.position)}};
  const Body defaults;
  write_unless(json, "angle", body.angle, defaults.angle);
  write_unless(json, "velocity", body.velocity, defaults.velocity);
  write_unless(json, "angularVelocity", body.angular_velocity, defaults.angular_velocity);
  write_unless(json, "gravityScale", body.gravity_scale, defaults.gravity_scale);
  if (body.fixed_rotation) json["fixedRotation"] = true;
  if (body.bullet) json["bullet"] = true;
  if (body.layers != defaults.layers) json["layers"] = body.layers;
  write_unless(json, "linearDamping", body.linear_damping, defaults.linear_damping);
  write_unless(json, "angularDamping", body.angular_damping, defaults.angular_damping);
  if (body.path) {
    json["path"] = {{"type", "sinusoidal"},
                    {"amplitude", as_json(body.path->amplitude)},
                    {"frequency", body.path->frequency},
                    {"phase", body.path->phase}};
  }
  OrderedJson shapes = OrderedJson::array();
  for (const Shape& shape : body.shapes) shapes.push_back(as_json(shape));
  json["shapes"] = std::move(shapes);
  return json;
}

OrderedJson origin_as_json(const Origin& origin) {
  OrderedJson json{{"engine", origin.engine}};
  if (origin.posed != Posed::well) json["posed"] = name_of(origin.posed);
  return json;
}

OrderedJson truth_as_json(const StatedTruth& truth) {
  OrderedJson json = OrderedJson::object();
  if (!truth.body.empty()) json["body"] = truth.body;
  json["quantity"] = name_of(truth.quantity);
  json["time"] = truth.time ? OrderedJson(*truth.time) : OrderedJson("end");
  if (truth.over != 0) json["over"] = truth.over;
  if (truth.index != 0) json["index"] = truth.index;
  if (!truth.with.empty()) json["with"] = truth.with;
  if (truth.relation != Relation::equal) json["relation"] = name_of(truth.relation);
  json["value"] = truth.value;
  if (truth.tolerance_of.empty()) {
    json["tolerance"] = truth.tolerance;
  } else {
    json["toleranceOf"] = truth.tolerance_of;
  }
  json["source"] = truth.source;
  return json;
}

template <class Items, class ToJson>
void add_list(OrderedJson& into, const char* key, const Items& items, ToJson as_item) {
  if (items.empty()) return;
  OrderedJson& list = into[key] = OrderedJson::array();
  for (const auto& item : items) list.push_back(as_item(item));
}

std::string key_of(const std::string& key) { return OrderedJson(key).dump() + ": "; }

// Appends `json` in one line, or as much of it as `room` columns hold, and tells whether that was all.
bool in_one_line(const OrderedJson& json, std::size_t room, std::string& out) {
  const std::size_t end = out.size() + room;
  if (!json.is_structured()) {
    out += json.dump();
    return out.size() < end;
  }
  out += json.is_object() ? '{' : '[';
  const char* separator = "";
  for (const auto& item : json.items()) {
    out += separator;
    if (json.is_object()) out += key_of(item.key());
    if (out.size() >= end || !in_one_line(item.value(), end - out.size(), out)) return false;
    separator = ", ";
  }
  out += json.is_object() ? '}' : ']';
  return out.size() < end;
}

// On one line if it fits, otherwise one line per element. `taken` is the number of columns already used on this line.
void lay_out(const OrderedJson& json, std::size_t indent, std::size_t taken, std::string& out) {
  const std::size_t before = out.size();
  if (in_one_line(json, taken < width ? width - taken : 0, out) || !json.is_structured() || json.empty()) return;
  out.resize(before);
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

const char* name_of(Posed posed) { return word_for(posed_words, posed); }

SceneFile read_scene(std::string_view text, std::string_view file) {
  if (text.size() > largest_scene_file) JsonReader({}, file).refuse("the file is larger than 16 MiB");
  const nlohmann::json json = parse_json(text, file);
  const JsonReader in(json, file);
  check_format(in);
  in.object({"plumb", "name", "gravity", "duration", "bodies"},
            {"$schema", "about", "source", "origin", "mixing", "joints", "forces", "truth"});
  if (in.has("$schema")) in["$schema"].text(0, limits::text);  // for editors
  SceneFile read;
  Scene& scene = read.scene;
  scene.name = in["name"].text(1, limits::name);
  if (in.has("about")) scene.about = in["about"].text(0, limits::text);
  if (in.has("source")) read.source = in["source"].text(1, limits::text);
  if (in.has("origin")) read.origin = read_origin(in["origin"]);
  scene.gravity = in["gravity"].vector(limits::acceleration);
  scene.duration = in["duration"].number(limits::duration);
  if (in.has("mixing")) scene.mixing = read_mixing(in["mixing"]);

  BodyNames names(scene);
  read_list(in, "bodies", scene.bodies, [&](const JsonReader& body) { return read_body(body, names); });
  if (scene.bodies.size() > limits::bodies)
    in["bodies"].expected("at most " + std::to_string(limits::bodies) + " bodies");
  if (scene.bodies.empty()) in["bodies"].refuse("expected a body, found none");
  read_list(in, "joints", scene.joints, [&](const JsonReader& joint) { return read_joint(joint, names); });
  read_list(in, "forces", scene.forces, [&](const JsonReader& force) { return read_force(force, names); });
  read_list(in, "truth", read.truth, [&](const JsonReader& truth) { return read_truth(truth, scene, names); });
  return read;
}

std::string write_scene(const SceneFile& file) {
  const Scene& scene = file.scene;
  OrderedJson json{{"plumb", format}, {"name", scene.name}};
  if (!scene.about.empty()) json["about"] = scene.about;
  if (!file.source.empty()) json["source"] = file.source;
  if (file.origin) json["origin"] = origin_as_json(*file.origin);
  json["gravity"] = as_json(scene.gravity);
  json["duration"] = scene.duration;
  json["mixing"] = {{"friction", word_for(friction_rules, scene.mixing.friction)},
                    {"restitution", word_for(restitution_rules, scene.mixing.restitution)}};
  add_list(json, "bodies", scene.bodies, body_as_json);
  add_list(json, "joints", scene.joints, [&](const Joint& joint) { return as_json(joint, scene); });
  add_list(json, "forces", scene.forces, [&](const Force& force) { return as_json(force, scene); });
  add_list(json, "truth", file.truth, truth_as_json);

  std::string text;
  try {
    lay_out(json, 0, 0, text);
  } catch (const OrderedJson::type_error&) {
    throw std::invalid_argument(printable(scene.name) + ": top level: it contains a text that is not UTF-8");
  }
  text += '\n';
  // Checks that the reader accepts the text: it refuses, for example, infinite numbers and duplicate names.
  read_scene(text, scene.name);
  return text;
}

}  // namespace plumb
