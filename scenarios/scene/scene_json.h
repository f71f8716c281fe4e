#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/scene/quantity.h"
#include "scenarios/scene/scene.h"

/// Scene files: each is an engine-neutral JSON file that describes one scene. scenarios/scene.schema.json defines the
/// format, with units and limits.
namespace plumb {

/// A known value that a scene file states about the result.
struct StatedTruth {
  std::string body;  // "" for quantities of the whole scene
  Quantity quantity = Quantity::x;
  std::optional<double> time;  // s; nullopt means the end
  double value = 0;            // in the quantity's unit
  double tolerance = 0;        // absolute, in the same unit
  /// A case of the catalogue, "bounce:e=0.5": the tolerance is what an engine is allowed there for the same question,
  /// by how it steps, and `tolerance` counts for nothing. "": it is `tolerance`.
  std::string tolerance_of = "";
  std::string source;  // in words: a formula, a measurement
  Relation relation = Relation::equal;
  double over = 0;        // s, averaging interval up to that time; 0: the value at that moment
  int index = 0;          // apex, landing: which one, counted from 1
  std::string with = "";  // load: of contacts with this body only; "": of all
  friend bool operator==(const StatedTruth&, const StatedTruth&) = default;
};

/// What rigid-body mechanics says of a scene, which decides by what it may be judged.
enum class Posed {
  well,        // one motion follows from the start: everything may judge
  ambiguous,   // several motions are right, as after impacts at the same moment: laws judge, places and images don't
  impossible,  // rigidity and Coulomb's friction contradict each other: only energy and finite numbers judge
  overlapping  // bodies start in each other, which rigid ones cannot: a run must end, with finite numbers
};

/// "well", "ambiguous", "impossible", "overlapping".
const char* name_of(Posed);

/// Of a scene that a search found: what it takes to run it again.
struct Origin {
  std::string engine;  // which failed in it, by the search's name for it: "box2d:velocity=2", "fault:normal-flipped"
  Posed posed = Posed::well;
};

struct SceneFile {
  Scene scene;
  std::vector<StatedTruth> truth;
  std::string source = "";  // where the question comes from, such as the link of a report; "" if nothing is stated
  std::optional<Origin> origin = std::nullopt;
};

constexpr std::size_t largest_scene_file = 16 * 1024 * 1024;  // bytes; 5,000 bodies take 1 MiB

/// Reads a whole scene file. `file` is the name used in messages. Throws std::invalid_argument if anything is wrong:
/// "file: JSON path: what was expected, what was found", or line and column if the text is not JSON.
SceneFile read_scene(std::string_view text, std::string_view file);

/// The text of a scene file. Reading it gives the same scene to the bit, and writing that scene the same text. Surfaces
/// are written as numbers and defaults are left out. Throws std::invalid_argument if read_scene() would refuse the
/// text.
std::string write_scene(const SceneFile&);

}  // namespace plumb
