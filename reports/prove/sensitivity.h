#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/faults/altered_engine.h"
#include "reports/prove/detection.h"
#include "reports/run/experiment.h"

/// How small an error in a parameter of our engine the harness notices: its own specification.
namespace plumb {

/// What an engine states about itself, by which runs of ours are judged: how fine the harness can be for that engine.
struct EngineStatement {
  std::string engine;
  EngineConfig config;              // only what it states is used; it runs nothing
  std::optional<double> goal = {};  // the error that must be seen in every parameter
};

/// Our engine's own, Box2D's and, where it was built, Chipmunk's, with their default settings.
std::vector<EngineStatement> engine_statements();

/// The smallest error that some case calls wrong.
struct Sighting {
  double error = 0;  // in the parameter's unit, with its sign
  Detection detection;
};

struct Sensitivity {
  Perturbation parameter;
  std::size_t cases = 0;                         // that have the parameter
  std::vector<std::optional<Sighting>> sighted;  // by statement; nullopt: no case sees an error of `largest_error`

  /// Whether the error that a statement sees is within its goal; true if it has none.
  bool reaches(std::size_t statement, const EngineStatement&) const;
};

/// The search for errors starts here: a larger one is no slight mistake.
constexpr double largest_error = 0.1;
/// The search ends here.
constexpr double smallest_error = 1e-12;
/// An error of this size stands for round-off. Where a motion is chaotic it may break a check, as any other may.
constexpr double round_off_error = 1e-15;
/// The error found is at most this factor above one that nothing notices.
constexpr double error_precision = 1.05;

/// The parameters of the catalog, in the order in which they are shown: by name.
std::vector<Perturbation> all_perturbations();

/// What a search over all parameters found.
struct Sensitivities {
  std::vector<Sensitivity> parameters;
  /// The cases in which an error of round-off size breaks a check by our own statement, each with the check: a false
  /// alarm in waiting.
  std::vector<std::string> unstable;
};

/// Bisects the error of each parameter, of either sign, in the cases that have it: our engine runs the perturbed scene
/// with its default settings and is judged by the truth of the case as it is. Only checks count that our engine passes
/// as it is and with errors of round-off size. The result does not depend on `jobs`.
Sensitivities sensitivities(const std::vector<Perturbation>&, const std::vector<Case>&,
                            const std::vector<EngineStatement>&, CaseTruths&, int jobs, const Progress&);

}  // namespace plumb
