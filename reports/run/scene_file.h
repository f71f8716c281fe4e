#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/run/run.h"
#include "scenarios/scene/scene.h"
#include "scenarios/scene/scene_json.h"

/// Cases from scene files, and the expectations of cases in the words of a scene file.
namespace plumb {

/// Whether a word of the command line means a scene file: it ends in ".json", or is the path of something that exists.
bool is_scene_file(std::string_view word);

/// The case of a scene file: its truths are the expectations, with their tolerances, and a closed form that recognises
/// the scene is its closed form. Throws std::invalid_argument for a file that cannot be read, or that takes a tolerance
/// of a case of the catalogue that does not ask the same.
Case case_of_file(const std::string& path);

/// The contents of a scene file, or of "tracker:NAME", as they are: with the truths and the source that it states.
/// Throws std::invalid_argument for any other word, and for a file that cannot be read.
SceneFile scene_file_of(const std::string& word);

/// The word that selects all scenes of scenarios/tracker; "tracker:NAME" selects one.
inline constexpr std::string_view tracker = "tracker";

/// The cases of scenarios/tracker, each a scenario of its own with this variant. Its question ends with the link of the
/// report.
std::vector<Case> reported_cases();

/// The closed form that recognises this scene, and of several the one that is valid longest; null if there is none.
const Engine* find_closed_form(const Scene&);

/// What a case of the catalogue expects, as truths of a scene file. Their tolerances are those of the case, by how each
/// engine steps; see StatedTruth::tolerance_of.
struct StatedTruths {
  std::vector<StatedTruth> truth;
  std::vector<std::string> left_out;  // what a scene file cannot state, and why
};
StatedTruths truths_of(const Case&);

/// What is allowed in a scene file but rarely meant, each with its place: "bodies[3]: starts 0.2 m inside bodies[0]".
/// Bodies that start in each other, angles above a full turn, densities per volume, rigid joints that start stretched,
/// and what takes minutes to run.
std::vector<std::string> warnings_about(const Scene&);

}  // namespace plumb
