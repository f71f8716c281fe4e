#include "reports/find/finding.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <nlohmann/json.hpp>
#include <set>
#include <type_traits>
#include <variant>

#include "reports/system/hash.h"
#include "scenarios/scene/scene_json.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr Posed all_posed[] = {Posed::well, Posed::ambiguous, Posed::impossible, Posed::overlapping};

// What a scene file says of a scene that is not well posed.
std::string judged_by(Posed posed) {
  if (posed == Posed::ambiguous) return " Several motions are right here: judged by laws alone.";
  if (posed == Posed::impossible) return " Rigidity and friction contradict each other here: judged by energy alone.";
  if (posed == Posed::overlapping) return " Bodies start in each other: judged by the run's end alone.";
  return "";
}

std::string shape_name(const Geometry& geometry) {
  constexpr std::array names{"circle", "box", "polygon", "capsule", "segment", "half-space"};
  static_assert(std::variant_size_v<Geometry> == names.size());
  return names[geometry.index()];
}

std::string body_kind(const Body& body) {
  std::set<std::string> shapes;
  for (const Shape& shape : body.shapes) shapes.insert(shape_name(shape.geometry));
  std::string text = body.type == BodyType::fixed ? "fixed" : body.type == BodyType::kinematic ? "driven" : "moving";
  for (const std::string& shape : shapes) text += " " + shape;
  return text;
}

std::string joined(const std::set<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : ", ") + text;
  return all;
}

// Letters, digits and dashes.
std::string file_word(const std::string& text) {
  std::string word;
  for (const char letter : text) {
    const bool plain = std::isalnum(static_cast<unsigned char>(letter)) != 0;
    if (plain) word += letter;
    if (!plain && !word.empty() && word.back() != '-') word += '-';
  }
  return word;
}

std::string plain_text(const Scene& scene) { return write_scene({.scene = scene, .truth = {}}); }

}  // namespace

int Finding::moving_bodies() const {
  return static_cast<int>(
      std::ranges::count_if(scene.bodies, [](const Body& one) { return one.type == BodyType::dynamic; }));
}

std::string Finding::signature() const {
  constexpr std::array joints{"hinge", "rod", "rail", "weld"};
  constexpr std::array forces{"attraction", "spring", "constant force"};
  static_assert(std::variant_size_v<Joint> == joints.size() && std::variant_size_v<Force> == forces.size());
  std::set<std::string> parts;
  for (const Body& body : scene.bodies) parts.insert(body_kind(body));
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    for (std::size_t k = i + 1; k < scene.bodies.size(); ++k) {
      const Body& a = scene.bodies[i];
      const Body& b = scene.bodies[k];
      const bool may_touch = (a.layers & b.layers) != 0 && (a.type == BodyType::dynamic || b.type == BodyType::dynamic);
      if (!may_touch) continue;
      const std::string one = body_kind(a);
      const std::string other = body_kind(b);
      parts.insert(std::min(one, other) + " on " + std::max(one, other));
    }
  }
  for (const Joint& joint : scene.joints) parts.insert(joints[joint.index()]);
  for (const Force& force : scene.forces) parts.insert(forces[force.index()]);
  return engine + ": " + complaint.reason() + ": " + joined(parts);
}

std::string Finding::name() const {
  Scene content = scene;
  content.name = "scene";
  content.about.clear();
  return fmt::format("{}-{}-{}", file_word(engine), file_word(complaint.what),
                     sha256(engine + complaint.reason() + plain_text(content)).substr(0, 8));
}

std::string Finding::file(std::uint64_t seed) const {
  Scene named = scene;
  named.name = name();
  named.about = fmt::format("{}: {}. Cut down from scene {} of plumb find --seed {}, which has {} bodies.{}", engine,
                            complaint.words(), from, seed, drawn_bodies, judged_by(posed));
  return plain_text(named);
}

Json as_json(const Finding& of) {
  Scene named = of.scene;
  named.name = "scene";
  named.about.clear();
  return {{"engine", of.engine},
          {"complaint", as_json(of.complaint)},
          {"from", of.from},
          {"posed", name_of(of.posed)},
          {"drawn_bodies", of.drawn_bodies},
          {"moving_bodies", of.moving_bodies()},
          {"runs", of.runs},
          {"scene", Json::parse(plain_text(named))}};
}

Finding finding_of(const Json& json) {
  Finding of{.engine = json.at("engine"),
             .complaint = complaint_of(json.at("complaint")),
             .from = json.at("from"),
             .scene = read_scene(json.at("scene").dump(), "a finding").scene,
             .drawn_bodies = json.at("drawn_bodies"),
             .runs = json.at("runs")};
  for (const Posed posed : all_posed) {
    if (json.at("posed") == name_of(posed)) of.posed = posed;
  }
  return of;
}

Origin origin_of(const Scene& scene) {
  Origin origin;
  if (scene.about.find(" of plumb find --seed ") == std::string::npos) return origin;
  origin.engine = scene.about.substr(0, scene.about.find(": "));
  for (const Posed posed : all_posed) {
    if (posed != Posed::well && scene.about.ends_with(judged_by(posed))) origin.posed = posed;
  }
  return origin;
}

}  // namespace plumb
