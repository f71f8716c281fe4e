#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reports/find/complaint.h"
#include "reports/find/judge.h"
#include "reports/find/kind.h"
#include "reports/judge/contacts.h"
#include "reports/judge/relation.h"
#include "scenarios/scene/scene.h"

namespace plumb {

/// The failing run of a finding, for readers.
struct FailingRun {
  std::vector<BodyPair> touching;  // up to where it fails; in order
  std::optional<Image> image;      // of the scene by the relation that it breaks
  /// For the page (see writers/replay.h): the run beside the closed form's or another engine's; of a broken relation
  /// the scene's run and the image's, whose times are the scene's.
  nlohmann::ordered_json films = nlohmann::ordered_json::array();
};

nlohmann::ordered_json as_json(const FailingRun&);
/// Throws nlohmann::json::exception or std::invalid_argument for what as_json does not write.
FailingRun failing_run_of(const nlohmann::ordered_json&);

/// Runs the scene again. `others` are engines to be seen beside this one, of which the first that runs the scene is.
FailingRun run_to_show(const Scene&, const Complaint&, const Suspect&, std::span<const Suspect> others);

/// The files of a finding are its name with these.
inline constexpr const char* scene_ending = ".json";
inline constexpr const char* image_ending = ".image.json";

/// A scene in which an engine is wrong, cut down.
struct Finding {
  std::string engine;  // the name of a suspect
  Complaint complaint;
  std::string from;  // the drawn scene, "heap/3"
  Posed posed = Posed::well;
  Scene scene;  // without name and about
  int drawn_bodies = 0;
  int runs = 0;    // that cutting it down took
  FailingRun run;  // of the scene, cut down

  int moving_bodies() const;
  /// What two findings of the same fault have in common: the engine, the reason, and which kinds of bodies, pairs that
  /// touch, joints and forces there are.
  std::string signature() const;
  /// From the content of the scene and the engine: "box2d-energy-1a2b3c4d".
  std::string name() const;
  /// Its scene file, with name, origin, and in words what fails and where it comes from.
  std::string file(std::uint64_t seed) const;
  /// The scene file of the image with which it breaks a relation; "" if it breaks none.
  std::string image_file() const;
};

nlohmann::ordered_json as_json(const Finding&);
/// Throws nlohmann::json::exception or std::invalid_argument for what as_json does not write.
Finding finding_of(const nlohmann::ordered_json&);

}  // namespace plumb
