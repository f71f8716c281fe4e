#pragma once

#include <cstddef>
#include <optional>

#include "reports/run/case_run.h"
#include "reports/run/converged_checks.h"

namespace plumb {

/// Judges runs of a case as `plumb run` does: by its reference solution, which is the closed form or, where there is
/// none, a converged reference, and by the invariants.
class CaseJudge {
 public:
  /// Runs the reference solution. The case must outlive the judge. `budget`: body-steps of each engine of a converged
  /// reference (see `converged_reference`); 0: none.
  CaseJudge(const Case&, double dt, std::size_t budget);
  CaseJudge(const CaseJudge&) = delete;
  CaseJudge& operator=(const CaseJudge&) = delete;

  /// The record of the run of the reference solution, which is right by definition; nullopt if there is none.
  const std::optional<RunRecord>& reference() const { return record_; }
  /// The reference solution; null if there is none or it cannot run the case.
  const Truth* truth() const { return truth_ ? &*truth_ : nullptr; }
  /// The converged reference; null if there is none.
  const Engine* refined() const { return refined_ ? &refined_->engine : nullptr; }

  /// The record of a run, measured and judged.
  RunRecord judged(const EngineConfig&, const CaseRun&) const;

  /// Of a run with more iterations than `stated`, by whose statement the converged reference judges it.
  RunRecord judged(const EngineConfig&, const CaseRun&, const EngineConfig& stated) const;

  /// Gives a record the verdict of all its checks, some of which were added to it.
  void judge_again(RunRecord&) const;

 private:
  const Case& case_;
  double dt_;
  std::optional<ConvergedTruth> refined_;
  std::optional<Truth> truth_;
  std::optional<ConvergedChecks> checks_;
  ReferenceRun reference_;
  std::optional<RunRecord> record_;
};

/// Adds a reason to those that a record has.
void add_reason(RunRecord&, const std::string&);

}  // namespace plumb
