#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "reference/faults/fault.h"
#include "reports/prove/alarm.h"

/// The harness put to the test: does it tell our engine with a mistake in it from the right one, and does it leave the
/// right one alone?
namespace plumb {

/// Cases that are small enough to be run for every fault: bodies times steps. Of all scenarios, canonical ones first.
std::vector<Case> cases_to_prove_by(double dt);

/// What became of one fault.
struct Proof {
  Fault fault;
  std::vector<Alarm> alarms;  // in order of cases

  /// Whether something tells but that bits are other ones than before.
  bool caught() const;
  /// Whether a truth or an invariant does.
  bool caught_by_physics() const;
  /// Of those that tell, the one that is farthest off; of several the first. Null if there is none.
  const Alarm* best() const;
  /// Names of the scenarios that tell, each once.
  std::vector<std::string> scenarios() const;
};

/// Told before each piece of work: what, the how-manieth, of how many.
using ProveProgress = std::function<void(const std::string&, std::size_t, std::size_t)>;

std::vector<Proof> prove(const std::vector<Fault>&, const std::vector<Case>&, double dt, int jobs,
                         const ProveProgress&);

/// The fewest scenarios that together catch all that is caught, found greedily: in each round that which catches most
/// of what is left, of several the first by name.
std::vector<std::string> fewest_scenarios(const std::vector<Proof>&);

/// A run of the right engine over all cases, varied as nothing may notice (see variation.h).
struct CleanRun {
  std::uint64_t seed = 0;
  std::string settings;  // what was varied, in words
  std::vector<Alarm> alarms;
};

/// Runs with the seeds 1 ... count, each held against the default method in the same scene: only what holds there can
/// be missed.
std::vector<CleanRun> clean_runs(int count, const std::vector<Case>&, double dt, int jobs, const ProveProgress&);

}  // namespace plumb
