#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reports/judge/verdict.h"
#include "reports/run/case_run.h"

namespace plumb {

/// The outcome of a case that was run and judged.
struct JudgedRun {
  Status status = Status::ok;
  std::string reason;      // why not ok
  Judgement judgement;     // of the worst phase if the scenario has several
  std::uint64_t bits = 0;  // hash of every state and contact of the first run
  bool repeatable = true;  // a second run, if there was one, had the same bits
};

/// Judges a case that was run, with its phases, by its truths and invariants, as `plumb run` does. `stated` is the
/// engine whose stepping the tolerances are those of; it need not be the one that ran.
JudgedRun judge_run(const Case&, const EngineConfig& stated, double dt, const CaseRun&, const CaseTruth&);

/// Runs a case twice, and in all its phases, and judges it by its truths and invariants.
JudgedRun judge_two_runs(const Case&, const EngineConfig&, double dt, const CaseTruth&);

/// What shows a fault. The first three need no earlier result; `bits` says only that something changed.
enum class DetectionKind { truth, invariant, repeat, bits };

/// "truth", "invariant", "repeat", "bits".
const char* name_of(DetectionKind);

/// A check that an engine fails.
struct Detection {
  std::string scenario;
  std::string variant;
  DetectionKind kind = DetectionKind::truth;
  std::string metric;  // "box y", "energy"
  std::string unit;
  double error = 0, tolerance = 0;
  double ratio = 0;  // error / tolerance; infinite if the tolerance is 0 or the run did not reach its end
};

/// The checks that `suspect` fails and `right` passes; none if the right engine cannot run the case. Includes `bits`
/// only if there is nothing else.
std::vector<Detection> detections(const Case&, const JudgedRun& right, const JudgedRun& suspect);

/// The same by truths and invariants alone, for runs that may have other bits.
std::vector<Detection> physics_detections(const Case&, const JudgedRun& right, const JudgedRun& suspect);

/// Everything that a run of the right engine fails; each is a false alarm. Includes `repeat`.
std::vector<Detection> false_alarms(const Case&, const JudgedRun&);

/// A truth of a run that no engine could fail.
struct LooseTruth {
  std::string scenario;
  std::string variant;
  NotATest check;
};
std::vector<LooseTruth> loose_truths(const Case&, const JudgedRun&);

}  // namespace plumb
