#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/simulation.h"

/// How runs fail, and the detectors that notice it.
namespace plumb {

/// How a run under detectors ended, from mild to severe.
enum class FailureMode {
  not_supported,
  holds,
  drifts,
  jitters,
  sinks,
  tunnels,
  topples,
  gains_energy,
  diverges,
  fails  // threw an error
};

struct FailureModeText {
  FailureMode mode;
  char letter;  // unique
  const char* name;
  const char* about;
};

/// All of them, in order.
std::span<const FailureModeText> failure_modes();

char letter_of(FailureMode);
const char* name_of(FailureMode);

/// False for `holds` and `not_supported`.
bool is_failure(FailureMode);

/// What a detector sees of one step.
struct ObservedStep {
  double time = 0;  // s, at its end
  std::span<const BodyState> states;
  bool last = false;
};

struct DetectorFinding {
  FailureMode mode;
  std::optional<std::size_t> body;  // nullopt: the whole scene
};

/// Checks every step of one run for one kind of failure. A detector may keep state, so each run needs its own.
struct Detector {
  std::string criterion;  // what counts as failing, with its numbers
  std::function<std::optional<DetectorFinding>(const ObservedStep&)> check;
};

using SharedScene = std::shared_ptr<const Scene>;

/// Topples: a dynamic body has turned by more than `angle`, rad, or dropped by more than `drop`, m.
Detector topple_detector(const SharedScene&, double angle, double drop);

/// Drifts: the centre of a dynamic body has moved by more than `distance`, m, perpendicular to gravity.
Detector drift_detector(const SharedScene&, double distance);

/// Sinks: two bodies overlap by more than `depth` plus `gap`, m, where `gap` is the gap that the method states for
/// resting contacts. Checks ten times a second.
Detector sink_detector(const SharedScene&, double depth, double gap);

/// Gains energy: the scene has more energy than at the start, by more than `fraction` of its energy range.
Detector energy_detector(const SharedScene&, double fraction);

/// Jitters: over the last second a dynamic body moved along a path longer than `path`, m. Drifts, if its displacement
/// is more than half of that path.
Detector restlessness_detector(const SharedScene&, double path);

/// Sinks: the centres of two bodies that are joined are more than `distance`, m, apart.
Detector separation_detector(const SharedScene&, std::size_t a, std::size_t b, double distance);

/// The detectors for a structure that should stand still. `size`: m, of its bodies. `gap`: m, as in sink_detector.
std::vector<Detector> structure_detectors(const SharedScene&, double size, double gap);

}  // namespace plumb
