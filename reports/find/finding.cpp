#include "reports/find/finding.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include "reports/find/judge.h"
#include "reports/judge/neighbours.h"
#include "reports/run/relations.h"
#include "reports/run/run.h"
#include "reports/run/scene_file.h"
#include "reports/system/hash.h"
#include "reports/writers/replay.h"
#include "scenarios/scene/scene_json.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

// As the engine reports, or from the shapes alone if it reports nothing.
std::vector<BodyPair> touching_in(const Scene& scene, const Trace& trace, const Stepping& stepping, double until) {
  std::set<BodyPair> pairs;
  const Neighbours neighbours(scene, trace, stepping);
  for (std::size_t moment = 1; moment < trace.size() && trace.time(moment - 1) < until; ++moment) {
    if (trace.has_contacts()) {
      for (const auto& [pair, contacts] : contacts_by_pair(trace.contacts(moment))) {
        if (contacts.acts(stepping.contact_gap())) pairs.insert(pair);
      }
    } else {
      for (const BodyGap& one : neighbours.in_step(moment)) pairs.insert({one.a, one.b});
    }
  }
  return {pairs.begin(), pairs.end()};
}

// The run of an image as long as the scene's, whatever its unit of time.
std::shared_ptr<const Trace> in_time_of(const Scene& scene, const Image& image, const Trace& trace) {
  auto timed = std::make_shared<Trace>(trace.bodies());
  for (std::size_t moment = 0; moment < trace.size(); ++moment) {
    timed->record(trace.time(moment) * scene.duration / image.scene.duration, trace.states(moment),
                  trace.contacts(moment));
  }
  return timed;
}

RunRecord film_of(const std::string& variant, const std::string& engine, const Scene& scene,
                  std::shared_ptr<const Trace> trace) {
  return {.scenario = scene.name,
          .variant = variant,
          .engine = engine,
          .scene = std::make_shared<const Scene>(scene),
          .trace = std::move(trace)};
}

// What the scene is seen beside in its own frame; nullopt if nothing else runs it to the end.
std::optional<RunRecord> run_beside(const Scene& scene, const Suspect& suspect, std::span<const Suspect> others) {
  std::vector<Suspect> engines;
  if (const Engine* one = find_closed_form(scene))
    engines.push_back(parse_suspects("closed-form:" + one->name).front());
  if (suspect.right) engines.push_back({.name = ours, .config = *suspect.right});
  engines.insert(engines.end(), others.begin(), others.end());
  for (const Suspect& other : engines) {
    if (other.name == suspect.name) continue;
    const Outcome outcome = run(scene, other.config, search_step);
    if (outcome.status == Status::ok) return film_of("scene", other.name, scene, outcome.trace);
  }
  return std::nullopt;
}

// A scene file that says nothing of where the scene comes from.
Json bare(Scene scene) {
  scene.name = "scene";
  scene.about.clear();
  return Json::parse(write_scene({.scene = std::move(scene), .truth = {}}));
}

}  // namespace

Json as_json(const FailingRun& of) {
  Json json{{"touching", of.touching}, {"films", of.films}};
  if (of.image) json["image"] = {{"dt", of.image->dt}, {"scene", bare(of.image->scene)}};
  return json;
}

FailingRun failing_run_of(const Json& json) {
  FailingRun of{.touching = json.at("touching"), .image = std::nullopt, .films = json.at("films")};
  if (json.contains("image")) {
    const Json& image = json.at("image");
    of.image = Image{read_scene(image.at("scene").dump(), "an image").scene, image.at("dt")};
  }
  return of;
}

FailingRun run_to_show(const Scene& scene, const Complaint& complaint, const Suspect& suspect,
                       std::span<const Suspect> others) {
  FailingRun made;
  const Outcome outcome = run(scene, suspect.config, search_step);
  if (outcome.trace == nullptr || outcome.trace->size() == 0) return made;
  const Stepping stepping = suspect.config.engine->stepping(suspect.config.settings, search_step);
  const double until = complaint.time > 0 ? complaint.time : std::numeric_limits<double>::infinity();
  made.touching = touching_in(scene, *outcome.trace, stepping, until);

  Report report;
  report.runs.push_back(film_of("scene", suspect.name, scene, outcome.trace));
  if (complaint.judge == "relation") {
    made.image = images_of(complaint.what, scene, *outcome.trace, search_step).back();
    const Outcome of_image = run(made.image->scene, suspect.config, made.image->dt);
    if (of_image.trace) {
      report.runs.push_back(film_of("image: " + complaint.what, suspect.name, made.image->scene,
                                    in_time_of(scene, *made.image, *of_image.trace)));
    }
  } else if (auto other = run_beside(scene, suspect, others)) {
    report.runs.push_back(std::move(*other));
  }
  made.films = replays_of(run_curves(report));
  return made;
}

namespace {

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
