#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reference/faults/altered_engine.h"
#include "reports/prove/detection.h"
#include "reports/run/experiment.h"

/// Tests the harness itself: it must tell our engine with a fault from the right one, and must not fault the right one.
namespace plumb {

/// Those of some cases that are small enough to be run for every fault, canonical scenarios first.
std::vector<Case> cases_to_prove_by(std::vector<Case>, double dt);

/// What was found of one fault.
struct FaultResult {
  Fault fault;
  std::vector<Detection> detections;  // in the order of the cases

  /// Whether something other than changed bits was detected.
  bool caught() const;
  /// Whether a truth or an invariant detected it.
  bool caught_by_physics() const;
  /// The detection with the largest ratio, the first of several; null if the fault was not caught.
  const Detection* best() const;
  /// The scenarios that caught it, each once.
  std::vector<std::string> scenarios() const;
};

/// Runs every case with every fault and with the right engines. The result does not depend on `jobs`.
std::vector<FaultResult> prove(const std::vector<Fault>&, const std::vector<Case>&, CaseTruths&, int jobs,
                               const Progress&);

/// A small set of scenarios that together catch every fault that is caught. Found greedily: each round takes the
/// scenario that catches most of the remaining faults, the first by name of several.
std::vector<std::string> fewest_scenarios(const std::vector<FaultResult>&);

/// Changes to a run of the right engine that must not change any verdict: precision, threads, lanes, broad phase, and
/// the seed of random scenes. Seed 0 changes nothing.
struct Variation {
  std::uint64_t seed = 0;
  Settings settings;  // of our engine

  /// The case with this seed if its scene is random, else the case as it is.
  Case of(const Case&) const;
  /// "seed 3: broad-phase=grid, precision=float, workers=4", "default settings"
  std::string text() const;
};

Variation variation_of(std::uint64_t seed);

/// A run of the right engine over all cases.
struct CleanRun {
  std::uint64_t seed = 0;  // 0: our engine as it is
  std::string settings;    // the text of the variation
  std::vector<Detection> false_alarms;
  std::vector<LooseTruth> loose = {};  // with the default settings alone: others may state larger errors
};

/// Our engine with its default settings in these cases as they are. Whatever it fails is a false alarm, and each truth
/// that it cannot fail is told.
CleanRun default_run(const std::vector<Case>&, CaseTruths&, int jobs, const Progress&);

/// Clean runs with the seeds 1 ... count. Whatever they fail is a false alarm, whether or not the default fails it too.
std::vector<CleanRun> clean_runs(int count, const std::vector<Case>&, CaseTruths&, int jobs, const Progress&);

}  // namespace plumb
