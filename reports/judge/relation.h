#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reports/report.h"
#include "reports/trace.h"
#include "scenarios/scenario.h"

/// Metamorphic relations (Chen, Cheung, Yiu: Metamorphic Testing, 1998): what an engine's run of a scene says about its
/// run of another one, an image of the scene, whether or not anyone knows how the scene should move. Pure: runs
/// nothing; run/relations.h does.
namespace plumb {

/// How differences grow in a scene: from the scene and from perturbed runs of it, never from the differences that are
/// judged. Moments are those of a run with steps of the engine's dt. Poses are compared in m: the larger of the
/// distance of the centres and the way of the rim.
class Amplification {
 public:
  Amplification() = default;
  Amplification(const Amplification&) = delete;
  Amplification& operator=(const Amplification&) = delete;
  virtual ~Amplification() = default;

  /// m, by which a body may be off at a moment if it, or others, were displaced by up to `size`, m, at any moment
  /// before. Nullopt beyond the horizon of such displacements.
  virtual std::optional<double> of(double size, std::size_t moment, std::size_t body) const = 0;

  /// The same for an engine that steps like this: its own error by then, wherever it was made, as the scene amplifies
  /// it.
  virtual std::optional<double> of_method(const Stepping&, std::size_t moment, std::size_t body) const = 0;

  /// s, from when on this engine's runs from starts displaced by up to `size`, m, are farther apart than that and its
  /// rounding, m by moment, explain: it decided otherwise (touching or not, which feature touches which, sticking or
  /// sliding) in a tie. Infinite if never.
  virtual double undecided_from(double size, std::span<const double> rounding) const = 0;
};

/// A run of a scene, or of an image.
struct RelationRun {
  const Scene& scene;
  const Trace& trace;  // at least two moments
  const Stepping& stepping;
  const Amplification& amplification;
};

/// What to run: another scene, or the same one with another step.
struct Image {
  Scene scene;
  double dt = 0;  // s
};

/// By how much a scene's run and its images' differ from the relation, where that is largest against the tolerance.
struct RelationCheck {
  std::string name;
  std::string why_not;   // why the relation says nothing here; "" if it does. Then nothing below is set.
  InvariantCheck check;  // name, status, value, tolerance, ratio, scale, time, where (the body), detail in words
  double share = 0;      // the largest difference of a body's pose / its scale, up to the horizon
};

struct MetamorphicRelation {
  std::string name;        // "mirror"
  std::string unit;        // of the differences
  std::string definition;  // the image, and what must hold
  /// Why it says nothing about such a scene or an engine that steps like this; "" if it does.
  std::function<std::string(const Scene&, const Stepping&)> excludes;
  /// The images of a scene that ran like this with steps of dt; its run tells where it ends and how far it
  /// reaches.
  std::function<std::vector<Image>(const Scene&, const Trace&, double dt)> images;
  /// Maps the images' runs back and compares. `images` are the runs of what `images` returned, in that order, all to
  /// their ends. Sets neither names nor units.
  std::function<RelationCheck(const RelationRun&, std::span<const RelationRun> images)> compare;
};

}  // namespace plumb
