#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "reports/report.h"
#include "reports/run/run.h"

namespace plumb {

/// An experiment: cases, engines and how to run them.
struct Plan {
  std::vector<Case> cases;
  std::vector<EngineConfig> configs;
  double dt = 1.0 / 60;    // s
  int jobs = 1;            // cases that run at once; the results do not depend on it
  std::size_t refine = 0;  // body-steps of each engine of a converged reference where there is no closed form; 0: none
  bool timed = true;       // measure the cost of a step after everything else
  bool relations = false;  // check the metamorphic relations, which takes a run of every engine for each image
  bool explain = false;    // run what is wrong again with more of the iterations that an engine states
  int ensemble = 0;        // runs of each engine to compare beyond a scene's horizon; 0: do not look for horizons
};

/// Called before each run with what comes next ("bounce e=0.5: box2d"), how many are done, and of how many; never
/// concurrently.
using Progress = std::function<void(const std::string& what, std::size_t done, std::size_t of)>;

/// Counts what begins, and reports it from several threads, one at a time.
class ProgressCounter {
 public:
  /// `progress` must outlive it.
  ProgressCounter(const Progress& progress, std::size_t all) : progress_(progress), all_(all) {}
  void begin(const std::string& what) {
    const std::lock_guard alone(reporting_);
    progress_(what, done_++, all_);
  }

 private:
  const Progress& progress_;
  std::size_t all_, done_ = 0;
  std::mutex reporting_;
};

/// "bounce e=0.5"
inline std::string label_of(const Case& one) { return one.scenario->name + " " + one.variant; }

/// Runs every case with its closed form and all configs, measures, judges and compares; then, with nothing else
/// running, times the configs that ran. The caller fills in `title`, `command` and `environment`.
Report run_experiment(const Plan&, const Progress&);

/// What an engine states about how it steps, in words, as far as it concerns what one sees: how far contacts rest from
/// touching, which impacts do not bounce, how often it iterates. "first order; overlaps of up to 5 mm are left alone".
std::string statement(const Stepping&);

// What an iterative solver leaves unsolved is cured by more iterations; nothing else is.

/// How many times the iterations of a run a second one gets.
inline constexpr int more_times = 32;

/// An engine with more iterations.
struct MoreIterations {
  EngineConfig config;
  std::string before, after;  // the counts: "8/3", "256/96"
};

/// The options that the engine's own statement calls iterations: those that change the counts it states, and neither
/// its step nor its sub-step. They are multiplied by `more_times`, at most to their maximum. nullopt if there is none.
std::optional<MoreIterations> with_more_iterations(const EngineConfig&, double dt);

}  // namespace plumb
