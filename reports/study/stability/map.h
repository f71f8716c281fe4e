#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "reports/run/run.h"
#include "reports/study/stability/detectors.h"
#include "scenarios/catalog.h"

/// What a stability map consists of: axes, the trials of a cell, and boundaries.
namespace plumb {

/// One of the two parameters of a map.
struct Axis {
  std::string name;  // "dt"
  std::string unit;  // "" if dimensionless
  double from = 0;   // of x: a value at which methods should hold
  double to = 0;     // of x: a value at which they should fail
  bool logarithmic = false;
  bool whole = false;  // integers only

  /// n evenly spaced values including both ends; fewer if integers coincide.
  std::vector<double> values(int n) const;

  /// Half-way between two values; the first if they are neighbouring integers.
  double between(double a, double b) const;
};

/// The value of x beyond which a method no longer holds.
struct Boundary {
  std::string name;  // "stands"
  std::vector<FailureMode>
      failing;            // the modes that count as failing, as runs without a result do; empty: all failures
  double resolution = 0;  // final width of the bracket; relative on a logarithmic axis; 1 on an integer axis
  /// The theoretical boundary of a method at a y; nullopt if theory gives none. 0 means it always fails, infinity that
  /// it always holds.
  std::function<std::optional<double>(const EngineConfig&, double y)> theory = nullptr;
  std::string source = {};  // of the theory
  /// Largest difference between measured and theoretical boundary that counts as agreement; relative on a logarithmic
  /// axis.
  double agreement = 0;
  /// The boundary is that of the physics: to hold beyond it is as wrong as to fail before it. Otherwise it is the
  /// method's own, and farther is better.
  bool natural = false;

  bool fails(FailureMode) const;
};

/// One run that may fail.
struct Trial {
  std::shared_ptr<const Scene> scene;
  double dt = 0;                    // s
  double first_step = 1;            // its length in dt
  std::vector<Detector> detectors;  // the first finding ends the run
};

/// How a trial ended: the first failure, when, and at which body.
struct TrialOutcome {
  FailureMode mode = FailureMode::holds;
  double time = 0;   // s, of the failure; if it holds, of the end
  std::string body;  // of the failure; "" for the whole scene
  std::string why;   // reason if it is not supported or threw
};

TrialOutcome run_trial(const Trial&, const EngineConfig&);

/// A scene of the catalog, with the scenario's parameters changed. Throws std::logic_error if there is no such
/// scenario.
Scene catalog_scene(const char* scenario, const Parameters& changes);

/// Where methods fail, over two parameters. Each map joins Catalog<StabilityMap> from a file in
/// reports/study/stability/maps/.
struct StabilityMap {
  std::string name;
  std::string question;
  Axis x;
  /// Nullopt: the option that makes a method work harder (WorkLadder), or nothing for a method without one.
  std::optional<Axis> y;
  double typical = 0;  // the y at which methods are compared over all maps; without y, it is the method's default
  /// The trials of a cell. Its outcome is the worst of theirs.
  std::function<std::vector<Trial>(double x, double y, const EngineConfig&)> trials;
  std::vector<Boundary> boundaries;  // methods are compared by the first
  /// The variants of a method that the map tries; null for the method as it is.
  std::function<std::vector<EngineConfig>(const EngineConfig&)> variants = nullptr;
};

/// m, the gap that the method states for resting contacts.
double stated_gap(const EngineConfig&, double dt);

constexpr double usual_dt = 1.0 / 60;  // s, of maps that do not vary it

/// The axes with their values, the criteria of the detectors ("metrics"), and the boundaries with their theories.
nlohmann::ordered_json description_of(const StabilityMap&, int cells);

}  // namespace plumb
