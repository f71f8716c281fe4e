#pragma once

#include <span>
#include <string>
#include <vector>

#include "benchmark_scene.h"
#include "reports/run/run.h"
#include "reports/timing/clock.h"

namespace plumb::benchmarks {

constexpr double dt = 1.0 / 60;  // s, of every step

/// The times of one engine.
struct EngineTimes {
  std::string no_result;        // why there are none: it cannot run the scene, or the scene collapsed; "" if there are
  std::vector<Elapsed> rounds;  // of the whole window; CPU time is that of the thread that steps
  OverlapDepth overlap;         // at the end of the window, the largest of all rounds
};

/// Times the window of a scene in every engine, in the order of the configs. In each round all engines build the scene
/// anew, make the steps before the window, and then alternate: the window is split into ten slices. Only steps are
/// timed. An engine that takes more than `patience` seconds for the steps of a round has no result.
std::vector<EngineTimes> time_window(const SceneSetup&, StepWindow, std::span<const EngineConfig>, int rounds,
                                     double patience);

}  // namespace plumb::benchmarks
