#include "reports/find/films.h"

#include <limits>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "reports/find/judge.h"
#include "reports/judge/neighbours.h"
#include "reports/run/relations.h"
#include "reports/run/run.h"
#include "reports/run/scene_file.h"
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
std::optional<RunRecord> beside(const Scene& scene, const Suspect& suspect, std::span<const Suspect> others) {
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
  } else if (auto other = beside(scene, suspect, others)) {
    report.runs.push_back(std::move(*other));
  }
  made.films = replays_of(run_curves(report));
  return made;
}

}  // namespace plumb
