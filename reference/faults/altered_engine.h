#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "reference/simulation.h"

/// Our own engine, altered to be wrong: with a mistake, without a law of mechanics, or with a parameter slightly off.
/// They are no engines to choose from. The harness proves itself by telling them from the right engine.
namespace plumb {

using BuildSimulation = std::function<std::unique_ptr<Simulation>(const Scene&, const Settings&)>;

/// Our engine as it is, in double precision.
std::unique_ptr<Simulation> build_ours(const Scene&, const Settings&);

/// A deliberate mistake.
struct Fault {
  std::string name;
  std::string about;   // one line: what is wrong
  std::string source;  // the part of the article that invites the mistake; "" if it comes from elsewhere
  Settings method;     // settings of our engine that select the mutated method; empty for the default
  BuildSimulation build;
  BuildSimulation right = nullptr;  // what it is compared with; null for our engine as it is
};

/// All faults, sorted by name.
std::vector<Fault> all_faults();

/// The complete settings of the right method.
Settings settings_of(const Fault&);

/// Two engines that differ only by the fault. Both state the errors of the right method.
Engine right_engine(const Fault&);
Engine faulty_engine(const Fault&);

/// Adds many faults to the catalog at once.
struct FaultSource {
  std::string name;
  std::vector<Fault> (*faults)();
};

/// A null engine: it lacks a whole law of mechanics, or only shows what another one did. No harness may call one right
/// where that law matters; `plumb prove --controls` measures by them which verdicts mean something.
struct Control {
  std::string name;
  std::string about;      // one line: what it does instead of mechanics
  BuildSimulation build;  // given the complete settings of our engine
};

/// The engine that runs a control. It has our engine's settings, and states the same errors.
Engine engine_of(const Control&);

/// Our engine in a scene that was altered first.
Control in_altered_scene(std::string name, std::string about, void (*alter)(Scene&));

/// A class of its own, made from the scene and the settings of our engine.
template <class Made>
Control simulated_by(const std::string& name, const std::string& about) {
  return {.name = name, .about = about, .build = [](const Scene& scene, const Settings& settings) {
            return std::make_unique<Made>(scene, settings);
          }};
}

/// A parameter and how to put an error into it. The smallest error that the harness notices is its sensitivity to that
/// parameter.
struct Perturbation {
  std::string name;   // of the parameter: "gravity"
  std::string about;  // what has the error, and what it is relative to
  std::string unit;   // of the error: "" for a relative one
  /// Whether the scene has the parameter: without it, no error changes the motion.
  std::function<bool(const Scene&)> applies;
  /// Our engine with the error, which may be negative. The settings must be complete. Throws std::invalid_argument if
  /// the engine refuses the value, a restitution above 1 for example.
  std::function<std::unique_ptr<Simulation>(const Scene&, const Settings&, double error)> build;
};

/// Our engine with the error as an engine of its own. A value that it refuses makes a scene not supported.
Engine perturbed_engine(const Perturbation&, double error);

}  // namespace plumb
