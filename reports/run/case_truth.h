#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "reports/run/case_run.h"
#include "reports/run/converged_checks.h"

namespace plumb {

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
