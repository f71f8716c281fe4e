#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/simulation.h"
#include "reports/find/complaint.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/scene.h"

/// Makes a scene that fails smaller and simpler as long as it fails for the same reason (delta debugging: A. Zeller and
/// R. Hildebrandt, Simplifying and Isolating Failure-Inducing Input, 2002).
namespace plumb {

/// How a scene starts against the rules: nothing that an engine should be blamed for.
struct Contradictions {
  double overlap = 0;      // m, the deepest of bodies that may touch
  double joint_speed = 0;  // m/s, at which what joints hold together moves apart
  double joint_gap = 0;    // m, by which a rigid distance joint has another length than its anchors
};

Contradictions contradictions(const Scene&);

Contradictions operator+(const Contradictions&, const Contradictions&);
/// The larger of each.
Contradictions larger(const Contradictions&, const Contradictions&);
/// What an engine states that its runs may leave of them: contacts and joints within their gaps, which a step closes.
Contradictions stated_by(const Stepping&);

/// Whether a scene starts no more against the rules than another, but for round-off.
bool no_worse(const Scene&, const Contradictions& than);

// What cuts are made of.

/// The scene without the bodies begin ... end - 1, their joints and forces.
Scene without_bodies(const Scene&, std::size_t begin, std::size_t end);

/// The scene with its numbers, or those of one body, rounded to so many digits, 1 to 5; directions stay, and rigid rods
/// are as long as their anchors are apart. Nullopt if that is no scene: rounding can make a polygon concave.
std::optional<Scene> with_digits(const Scene&, int digits, std::optional<std::size_t> body = std::nullopt);

/// The scene from a time on, s, at which its run has reached these states.
Scene started_at(const Scene&, std::span<const BodyState>, double time);

/// How a scene fails.
struct Failure {
  Complaint complaint;
  /// The states that its run reaches at a time, s; empty if it does not get there.
  std::function<std::vector<BodyState>(double time)> states;
};

/// One way to make a scene simpler. Joins Catalog<Cut> from its own file in reports/find/cuts/.
struct Cut {
  std::string name;
  int order = 0;  // small: tried first, as it removes most
  /// Scenes that are simpler in one respect each, the boldest first.
  std::function<std::vector<Scene>(const Scene&, const Failure&)> simpler;
  bool from_run = false;  // they start where the run was: in contacts and joints as exactly as the engine states
};

/// An engine, and the reason for which scenes fail in it.
struct CutTrial {
  /// Runs a scene and returns by what it fails for the reason; nullopt if it does not.
  std::function<std::optional<Complaint>(const Scene&)> fails;
  /// The states that the run of a scene reaches at a time, s; empty if it does not get there.
  std::function<std::vector<BodyState>(const Scene&, double time)> states = [](const Scene&, double) {
    return std::vector<BodyState>{};
  };
  Contradictions stated = {};  // in which the engine states that its runs may be
};

struct Shrunk {
  Scene scene;
  Complaint complaint;
  int runs = 0;
};

/// The smallest scene that at most `budget` runs find. It never starts with bodies deeper in each other, or with joints
/// moving further apart, than the given one, but for what the engine states where it starts from a state of a run, and
/// stays clearly wrong: off by twice what is allowed if it was, and by a hundredth of what it was.
Shrunk shrink(const Scene&, const Complaint&, const CutTrial&, int budget);

}  // namespace plumb
