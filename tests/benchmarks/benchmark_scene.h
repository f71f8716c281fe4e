#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/scene.h"

/// Times the steps of every engine on scenes that engines are commonly timed on.
namespace plumb::benchmarks {

/// Steps `from` ... `to` - 1 of a run, counted from its start.
struct StepWindow {
  int from = 0, to = 0;
  int steps() const { return to - from; }
};

/// A body that was placed on another one, by index.
struct Support {
  std::size_t above = 0, below = 0;
};

/// A scene to be timed, and what it must still satisfy afterwards: times of a scene that has collapsed mean nothing.
struct SceneSetup {
  Scene scene;
  double size = 0;                                         // m, across the smallest body
  std::vector<Support> supports;                           // which must still hold
  Vec center;                                              // of the circle that no dynamic body may leave
  double reach = std::numeric_limits<double>::infinity();  // m, its radius
};

/// Adds boxes of 1 m in rows, side by side without gaps, each box on two of the row below. `middle` is the middle of
/// the lowest row's lower edge.
void add_pyramid(SceneSetup&, int base, Vec middle);

/// A kind of scene, with the parts of its run that are worth timing.
struct BenchmarkScene {
  std::string name;
  std::string about;   // one line
  StepWindow settled;  // while the bodies are at rest; empty if they never are
  StepWindow moving;   // while they move, fall or collide; empty if they never do
  std::function<SceneSetup()> setup;
};

/// How deep bodies overlap, m; zeros if they do not.
struct OverlapDepth {
  double mean = 0;  // over all overlaps
  double most = 0;
};

struct SceneCheck {
  std::string broken;  // how the scene collapsed, so that its time is no result; "" if it did not
  OverlapDepth overlap;
};

/// Checks the states of the scene's bodies, in their order. A scene has collapsed if a number is not finite, a dynamic
/// body has left its circle, a body has come off its support, a hinge is open by the width of the smallest body, or
/// overlaps have a mean depth of a quarter of it. (A single pair may overlap more, during an impact.)
SceneCheck check_scene(const SceneSetup&, std::span<const BodyState> states);

}  // namespace plumb::benchmarks
