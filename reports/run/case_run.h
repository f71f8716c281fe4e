#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reports/judge/metric.h"
#include "reports/judge/verdict.h"
#include "reports/report.h"
#include "reports/run/converged_checks.h"
#include "reports/run/run.h"

/// Runs a case with one engine, in several phases if its scenario asks for them, and then judges the runs.
///
/// An impact falls somewhere between two steps, and the error depends on where. The phases of a case sample that: they
/// shift the steps, not the scene, so that the expected values and their times stay the same.
namespace plumb {

/// The case itself and n - 1 copies with a first step shorter than dt: by the fractional parts of multiples of the
/// golden ratio, which fill 0 ... 1 evenly for any n. The last step is cut so that all end with the scene.
std::vector<Case> phases(const Case&, int n);

/// The number of phases that a phased scenario is judged by.
constexpr int judged_phases = 8;

struct CaseRun {
  Outcome outcome;               // of the case itself
  std::vector<Outcome> shifted;  // of its other phases; empty unless the scenario is phased and the outcome is ok
};

/// Runs a case, and its other phases if its scenario is phased.
CaseRun run_case(const Case&, const EngineConfig&, double dt);

/// Only the other phases of a case; none unless its scenario is phased.
std::vector<Outcome> run_shifted(const Case&, const EngineConfig&, double dt);

/// What a case asks, as far as it has an answer. Parameters may lead to a motion that the case's closed form does not
/// handle, or only up to a time before that of a question.
struct Questions {
  std::vector<Expectation> answered;  // with a stated value, or one of the closed form
  std::vector<TruthCheck> open;       // the quantities of the others, as checks that nothing is reported for
  std::string reason;                 // why these are open; "" if none is
  bool known = false;                 // whether a converged reference knows what the scene is for

  /// That of the checks of what is answered (see `verdict_of`): right only if they ask about every open quantity, too.
  /// Where it is known how the scene goes on, an engine is not plausible for want of checks that could tell its errors
  /// from a wrong motion: there is no evidence.
  Verdict verdict(std::span<const TruthCheck>, std::span<const InvariantCheck>) const;
};

/// The reference solution of a case; all are null if there is none.
struct ReferenceRun {
  const Truth* truth = nullptr;
  std::shared_ptr<const Trace> trace = nullptr;  // with the steps of the runs that are compared with it
  const ConvergedChecks* converged = nullptr;    // of a converged reference

  MetricContext context(const Scene&, const Trace&) const;
};

/// Its truth may be null: then the closed form does not handle the scene.
Questions questions_of(const Case&, const ReferenceRun&);

/// Judges a case by its trace and by its other phases (see `judge_phases`), as far as its questions are answered, and
/// by its converged reference. Runs nothing; looks at no trace of the reference.
Judgement judge_case(const Case&, const EngineConfig&, double dt, const Trace&, std::span<const Outcome> shifted,
                     const ReferenceRun&);

/// The record of a run before it is measured: what ran and how it ended.
RunRecord record_of(const Case&, const EngineConfig&, double dt, const Outcome&);

/// The record of a case, measured and judged. The case may start next to the one that the reference belongs to: the
/// expected values are still the reference's.
RunRecord judged_record(const Case&, const EngineConfig&, double dt, const CaseRun&, const ReferenceRun&);

/// Adds a reason to those that a record has.
void add_reason(RunRecord&, const std::string&);

/// What judges the runs of a case: its closed form or, where it has none, a converged reference.
class CaseTruth {
 public:
  /// `budget`: body-steps of a converged reference (see converged_reference); 0: none.
  CaseTruth(const Case&, double dt, std::size_t budget);
  CaseTruth(const CaseTruth&) = delete;
  CaseTruth& operator=(const CaseTruth&) = delete;
  ~CaseTruth() = default;

  /// Null if there is neither.
  const Engine* engine() const { return engine_; }
  /// Null if a closed form judges, or nothing.
  const ConvergedTruth* converged() const { return converged_ ? &*converged_ : nullptr; }
  /// Its run with the steps of the runs that are compared with it; it did not start if there is no engine.
  const Outcome& outcome() const { return outcome_; }
  /// Empty unless that run is ok. It points to parts of this.
  ReferenceRun reference() const;
  /// s, how long the motion is known; for ever where a closed form judges, or nothing.
  double valid_until() const;

 private:
  std::shared_ptr<const Scene> scene_;
  const Engine* engine_ = nullptr;
  std::optional<ConvergedTruth> converged_;
  Outcome outcome_{.status = Status::not_supported};
  std::optional<Truth> truth_;
  std::optional<ConvergedChecks> checks_;
};

/// The truths of cases, each found once: when it is first asked for.
class CaseTruths {
 public:
  /// `budget` as in CaseTruth.
  explicit CaseTruths(double dt, std::size_t budget = usual_budget) : dt_(dt), budget_(budget) {}

  /// s, the step of the runs.
  double dt() const { return dt_; }
  /// From any thread. Copies of a case that share its scene have one truth.
  const CaseTruth& of(const Case&);

 private:
  struct Lazy {
    std::once_flag found;
    std::unique_ptr<const CaseTruth> truth;
  };

  double dt_;
  std::size_t budget_;
  std::mutex looking_;
  std::map<std::shared_ptr<const Scene>, Lazy> truths_;
};

}  // namespace plumb
