#include "reports/find/finding.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "reports/system/hash.h"
#include "scenarios/scene/scene_json.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

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

// A scene file that says nothing of where it comes from but this.
std::string unnamed(Scene scene, const std::optional<Origin>& origin = std::nullopt) {
  scene.name = "scene";
  scene.about.clear();
  return write_scene({.scene = std::move(scene), .truth = {}, .origin = origin});
}

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
  for (const auto& [a, b] : run.touching) {
    const std::string one = body_kind(scene.bodies[a]);
    const std::string other = body_kind(scene.bodies[b]);
    parts.insert(std::min(one, other) + " on " + std::max(one, other));
  }
  for (const Joint& joint : scene.joints) parts.insert(joints[joint.index()]);
  for (const Force& force : scene.forces) parts.insert(forces[force.index()]);
  return engine + ": " + complaint.reason() + ": " + joined(parts);
}

std::string Finding::name() const {
  return fmt::format("{}-{}-{}", file_word(engine), file_word(complaint.what),
                     sha256(engine + complaint.reason() + unnamed(scene)).substr(0, 8));
}

std::string Finding::file(std::uint64_t seed) const {
  Scene named = scene;
  named.name = name();
  named.about = fmt::format("{}: {}. Cut down from scene {} of plumb find --seed {}, which has {} bodies.{}", engine,
                            complaint.words(), from, seed, drawn_bodies, judged_by(posed));
  return write_scene({.scene = std::move(named), .truth = {}, .origin = Origin{engine, posed}});
}

std::string Finding::image_file() const {
  if (!run.image) return "";
  Scene named = run.image->scene;
  named.name = name() + ".image";
  named.about = fmt::format("The image of {} by the relation {}, run with steps of {:.6g} s.", name(), complaint.what,
                            run.image->dt);
  return write_scene({.scene = std::move(named), .truth = {}});
}

Json as_json(const Finding& of) {
  return {{"engine", of.engine},
          {"complaint", as_json(of.complaint)},
          {"from", of.from},
          {"drawn_bodies", of.drawn_bodies},
          {"moving_bodies", of.moving_bodies()},
          {"runs", of.runs},
          {"scene", Json::parse(unnamed(of.scene, Origin{of.engine, of.posed}))},
          {"run", as_json(of.run)}};
}

Finding finding_of(const Json& json) {
  const SceneFile file = read_scene(json.at("scene").dump(), "a finding");
  const Origin origin = file.origin.value_or(Origin{});
  return {.engine = origin.engine,
          .complaint = complaint_of(json.at("complaint")),
          .from = json.at("from"),
          .posed = origin.posed,
          .scene = file.scene,
          .drawn_bodies = json.at("drawn_bodies"),
          .runs = json.at("runs"),
          .run = failing_run_of(json.at("run"))};
}

}  // namespace plumb
