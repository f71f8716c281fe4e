#pragma once

#include <functional>
#include <memory>
#include <string>

#include "reference/simulation.h"

/// Our own engine with one parameter slightly off. The smallest error that the harness notices is its sensitivity to
/// that parameter.
namespace plumb {

/// A parameter and how to put an error into it.
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
