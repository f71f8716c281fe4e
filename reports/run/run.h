#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/simulation.h"
#include "reports/report.h"
#include "scenarios/scenario.h"

/// The only time loop.
namespace plumb {

/// One question, ready to be put.
struct Case {
  const Scenario* scenario = nullptr;
  std::string variant;  // label
  Parameters parameters;
  std::shared_ptr<const Scene> scene;
  const Engine* closed_form = nullptr;                  // null where physics has none
  double first_step = 1;                                // its length in dt, above 0; see phases.h
  std::shared_ptr<const Scenario> from_file = nullptr;  // what `scenario` points to, where no catalog keeps it
};

/// One who is asked it.
struct EngineConfig {
  const Engine* engine = nullptr;
  Settings settings;  // complete

  /// "key=value,..." of what differs from the defaults; "" for the defaults.
  std::string method() const;
};

/// How a run went, before anything is judged.
struct Outcome {
  Status status = Status::ok;
  std::string reason;               // why not ok
  std::shared_ptr<Trace> trace;     // up to where it went wrong; null if it never began, or was only watched
  std::optional<std::size_t> lost;  // the body that diverged
  double time = 0;                  // s of the scene, that it came to
  double wall = 0;                  // s, all of the run: build, steps, recording
  double stepping = 0;              // s, inside `step` alone
};

/// Builds, steps to the scene's end (or to where the answer ends) and records. Never throws for what the engine
/// does: what it cannot run is `not_supported`, what diverges or throws is `failed`, with the reason.
/// The first step lasts first_step dt; if that is less than one, the last is cut to end with the scene.
Outcome run(const Scene&, const EngineConfig&, double dt, double first_step = 1);

/// Told of every moment of a run, the start among them; says whether it shall go on.
using Observer = std::function<bool(double time, std::span<const BodyState>)>;

/// The same for an observer, who may end it early; nothing is recorded.
Outcome watch(const Scene&, const EngineConfig&, double dt, double first_step, const Observer&);

/// Steps of dt that cover a duration, both in s.
std::size_t steps_in(double duration, double dt);

}  // namespace plumb
