#pragma once

#include <memory>
#include <string>
#include <vector>

#include "reports/compare/ensembles.h"
#include "reports/run/case_run.h"
#include "reports/run/run.h"
#include "reports/study/reference_solution.h"

namespace plumb {

/// How much larger a model's error in a case is than the full model's.
///
/// Errors are measured against the reference solution, as long as it is valid. If it ends before the scene, or its own
/// error exceeds the tolerance, models are also compared with the full model, up to the scene's horizon: beyond it,
/// runs from starts a billionth apart have diverged, and a difference means nothing.
///
/// In a scene whose horizon comes before its end (heaps, rain) no two methods give the same motion, and none is needed:
/// a model is sufficient if ensembles of runs of it and of the full model, from starts a billionth apart, differ
/// neither in energy nor in spread nor in rest time by more than 5 % of the energy lost, the spread and the duration
/// (reports/compare/ensembles.h), and if no bodies overlap deeper than in the full model by 5 % of the smallest body.
///
/// A model that breaks a law or misses a truth, as `plumb run` judges it, is not sufficient where the full model does
/// neither.
class ModelError {
 public:
  ModelError(Case problem, EngineConfig full, double dt, double tolerance);
  ModelError(const ModelError&) = delete;
  ModelError& operator=(const ModelError&) = delete;

  /// Finds the reference solution and runs the full model; calls after the first do nothing. Must be called before
  /// anything else.
  void find();

  struct Result {
    Status status = Status::ok;
    std::string reason;  // why not ok
    double error = 0;    // m, against the reference solution; NaN if there is none
    double change = 0;   // m, by which an error or an overlap exceeds the full model's; infinite if it did not run
    std::string different = {};  // chaotic scenes: in which statistics from the full model; "" if in none
    /// What `plumb run` calls wrong, but not in the full model: "cone of pit - box 5, sticking ..."; "" if nothing.
    std::string breaks = {};
  };
  Result of(const EngineConfig& model) const;
  bool within_tolerance(const Result&) const;

  const Case& problem() const { return problem_; }
  const EngineConfig& full() const { return full_; }
  double dt() const { return dt_; }
  /// The name of the engine that gives the reference solution; "" if there is none.
  std::string truth() const;
  double truth_until() const;                                // s
  double truth_error() const { return reference_.error(); }  // m
  /// s, up to where models are compared with the full one; 0 if the reference solution is enough.
  double compared_until() const { return compared_until_; }
  /// Judged by statistics.
  bool chaotic() const { return chaotic_; }
  std::size_t phases() const { return phases_.size(); }

 private:
  // A check that a run does not pass.
  struct Complaint {
    std::string check;  // "cone"
    std::string words;  // "cone of pit - box 5"
  };
  static std::vector<Complaint> complaints_of(const RunRecord&);
  std::string worse_than_full(const RunRecord&) const;
  std::vector<EnsembleSample> ensemble_of(const EngineConfig&) const;
  std::string difference_in_statistics(const EngineConfig&, double overlap) const;
  double difference(const Trace&, const Trace&, double until) const;

  Case problem_;
  EngineConfig full_;
  double dt_;
  double tolerance_;
  ReferenceSolution reference_;
  double gyration_;  // m, radius of gyration of the smallest body: converts an angle into a displacement
  bool found_ = false;
  double compared_until_ = 0;
  std::vector<Case> phases_;
  std::vector<std::shared_ptr<const Trace>> truths_;  // by phase
  std::vector<std::shared_ptr<const Trace>> fulls_;   // by phase
  std::unique_ptr<const CaseTruth> judging_truth_;
  std::vector<Complaint> full_complaints_;
  double full_overlap_ = 0;  // m
  double full_error_ = 0;    // m
  bool chaotic_ = false;
  std::vector<EnsembleSample> full_runs_;
};

}  // namespace plumb
