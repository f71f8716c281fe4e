#pragma once

#include <cstddef>
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

/// Reads a simulation and checks that its adapter fills the results correctly. The returned spans are valid until the
/// next read.
class Readout {
 public:
  explicit Readout(const Scene& scene) : scene_(scene) {}

  /// One per body. Throws std::runtime_error if `read` leaves a body out or writes past the last one.
  std::span<const BodyState> states(const Simulation&);

  /// Throws std::runtime_error for a contact of bodies that are not in the scene, or one that is not finite.
  std::span<const ContactState> contacts(const Simulation&);

 private:
  const Scene& scene_;
  std::vector<BodyState> states_;
  std::vector<ContactState> contacts_;
};

/// A variant of a scenario, ready to run.
struct Case {
  const Scenario* scenario = nullptr;
  std::string variant;  // label
  Parameters parameters;
  std::shared_ptr<const Scene> scene;
  const Engine* closed_form = nullptr;                  // null if there is none
  double first_step = 1;                                // its length in units of dt, > 0; see case_run.h
  std::shared_ptr<const Scenario> from_file = nullptr;  // owns `scenario` if no catalog does
  std::vector<std::string> doubts = {};                 // about the file's truths
};

/// An engine and its settings.
struct EngineConfig {
  const Engine* engine = nullptr;
  Settings settings;  // complete

  /// "key=value,..." of the settings that differ from the defaults; "" for the defaults.
  std::string method() const;
};

/// What an engine states about how it steps; nullopt, with the reason, if it fails to say.
std::optional<Stepping> stepping_of(const EngineConfig&, double dt, std::string& why_not);

/// How a run ended, before anything is judged.
struct Outcome {
  Status status = Status::ok;
  std::string reason;               // if the status is not ok
  std::shared_ptr<Trace> trace;     // up to where it failed; null if it never started or was only observed
  std::optional<std::size_t> lost;  // the body that diverged
  double time = 0;                  // s of the scene, reached
  double wall = 0;                  // s, for the whole run: build, steps, recording
  double stepping = 0;              // s, inside `step` alone
};

/// Builds, steps to the end of the scene (or of the closed form's validity) and records. The first step lasts
/// first_step dt; if that is less than one, the last step is cut to end with the scene. Never throws for what the
/// engine does: a scene it cannot run is `not_supported`, a run that diverges or throws is `failed`, with the reason.
Outcome run(const Scene&, const EngineConfig&, double dt, double first_step = 1);

/// Called at every moment of a run, including the start; returns whether to go on.
using Observer = std::function<bool(double time, std::span<const BodyState>)>;

/// The same with an observer, which may end the run early; records nothing.
Outcome watch(const Scene&, const EngineConfig&, double dt, double first_step, const Observer&);

/// Body-steps for the converged reference of a scene, or for a run of an ensemble, unless a user says otherwise: less
/// than a second.
inline constexpr std::size_t usual_budget = 200'000;

/// Steps of dt that cover a duration, both in s.
std::size_t steps_in(double duration, double dt);

}  // namespace plumb
