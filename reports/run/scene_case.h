#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/run/run.h"
#include "scenarios/scene/scene_json.h"

/// Questions from scene files and back.
namespace plumb {

/// Whether a word of the command line means a scene file: it ends in ".json", or is the path of something that exists.
bool means_file(std::string_view word);

/// The question a scene file asks: its truths are what is expected, within their tolerances; a closed form that
/// knows the scene by itself is a witness too. Throws std::invalid_argument for a file that cannot be read.
Case case_of_file(const std::string& path);

/// The closed form that knows this scene's answer, of several the one that holds longest; null if there is none.
const Engine* witness_of(const Scene&);

/// What a case expects, in the words of a scene file, whose tolerances know no engine: each is what a first-order
/// method would be allowed (see `reference_stepping`).
struct StatedTruths {
  std::vector<StatedTruth> truth;
  std::vector<std::string> left_out;  // what cannot be said in a scene file, and why
};
StatedTruths truths_of(const Case&);

/// Symplectic Euler at 60 steps a second in single precision, which sees an impact at the end of its step, with
/// contacts up to a centimetre off and no threshold: what games use, and no engine in particular.
Stepping reference_stepping();

}  // namespace plumb
