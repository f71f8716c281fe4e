#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/scenario.h"
#include "scenarios/scene/scene.h"

/// Scene files: one neutral JSON file describes one question. scene.schema.json beside this file says what is in it,
/// with units and limits.
namespace plumb {

/// What a scene file knows of the answer.
struct StatedTruth {
  std::string body;  // "" for quantities of the whole scene
  Quantity quantity = Quantity::x;
  std::optional<double> time;  // s; nothing means the end
  double value = 0;            // in the quantity's unit
  double tolerance = 0;        // the same; absolute
  std::string source;          // in words
  friend bool operator==(const StatedTruth&, const StatedTruth&) = default;
};

struct SceneFile {
  Scene scene;
  std::vector<StatedTruth> truth;
};

constexpr std::size_t largest_scene_file = 16 * 1024 * 1024;  // bytes; 5,000 bodies take one

/// Reads the text of a scene file whole or not at all. `file` is what messages call it. Throws std::invalid_argument:
/// "file: JSON path: what was expected, what was found", or line and column where the text is no JSON.
SceneFile read_scene(std::string_view text, std::string_view file);

/// The text of a scene file. Reading it gives the same bits, and writing those the same text. Surfaces are written as
/// numbers, defaults left out. Throws std::invalid_argument, as the reader would, for what no scene file may hold.
std::string write_scene(const SceneFile&);

}  // namespace plumb
