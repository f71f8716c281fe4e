#include "reports/study/model/model_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "reference/scene_facts.h"
#include "reports/judge/mechanics.h"
#include "reports/judge/states.h"
#include "reports/run/case_run.h"
#include "reports/run/converged_checks.h"
#include "reports/run/horizon.h"

namespace plumb {
namespace {

// By phase, the case itself first.
std::vector<const Outcome*> outcomes_of(const CaseRun& runs) {
  std::vector<const Outcome*> all{&runs.outcome};
  for (const Outcome& one : runs.shifted) all.push_back(&one);
  return all;
}

// m, the deepest; 0 if there are no two bodies.
double overlap_in(const RunRecord& record) {
  const auto found = record.metrics.find("penetration_max");
  return found == record.metrics.end() ? 0 : found->second.value;
}

}  // namespace

ModelError::ModelError(Case problem, EngineConfig full, double dt, double tolerance)
    : problem_(std::move(problem)),
      full_(std::move(full)),
      dt_(dt),
      tolerance_(tolerance),
      reference_(problem_, dt),
      gyration_(smallest_body(*problem_.scene) / (2 * std::sqrt(2.0))),  // of a disc with that diameter
      phases_(plumb::phases(problem_, problem_.scenario->phased ? judged_phases : 1)) {}

void ModelError::find() {
  if (std::exchange(found_, true)) return;
  reference_.find();
  judging_truth_ = std::make_unique<const CaseTruth>(problem_, dt_, usual_budget);
  for (const Case& phase : phases_) {
    const Engine* engine = reference_.engine();
    if (engine == nullptr) break;
    truths_.push_back(run(*phase.scene, {engine, complete(*engine, {})}, dt_, phase.first_step).trace);
  }
  const CaseRun full = run_case(problem_, full_, dt_);
  for (const Outcome* outcome : outcomes_of(full)) fulls_.push_back(outcome->trace);
  const RunRecord record = judged_record(problem_, full_, dt_, full, judging_truth_->reference());
  full_complaints_ = complaints_of(record);
  full_overlap_ = overlap_in(record);
  const double end = problem_.scene->duration;
  const bool reaches_end = reference_.engine() != nullptr && reference_.until() >= end * (1 - 1e-9);
  if (!reaches_end || reference_.error() > tolerance_)
    compared_until_ = std::min(end, horizon_of(*problem_.scene, dt_).value_or(end));
  chaotic_ = compared_until_ > 0 && compared_until_ < end * (1 - 1e-9);
  if (chaotic_) full_runs_ = ensemble_of(full_);
  full_error_ = of(full_).error;
}

// Eight against eight: the rank test finds every quantity in which all of one kind exceed all of the other.
std::vector<EnsembleSample> ModelError::ensemble_of(const EngineConfig& model) const {
  constexpr int members = 8;
  const Scene& scene = *problem_.scene;
  const double size = smallest_difference(scene, full_.engine->stepping(full_.settings, dt_));
  return run_ensemble(scene, model, dt_, size, members, 1);
}

std::string ModelError::truth() const { return reference_.engine() == nullptr ? "" : reference_.engine()->name; }

double ModelError::truth_until() const {
  return reference_.engine() == nullptr ? 0 : std::min(reference_.until(), problem_.scene->duration);
}

ModelError::Result ModelError::of(const EngineConfig& model) const {
  Result result;
  const CaseRun runs = run_case(problem_, model, dt_);
  const std::vector<const Outcome*> outcomes = outcomes_of(runs);
  double squares = 0;
  double largest_difference = 0;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const Outcome& outcome = *outcomes[i];
    result.status = outcome.status;
    result.reason = outcome.reason;
    if (outcome.status != Status::ok || i >= fulls_.size() || !fulls_[i]) {
      result.error = result.change = std::numeric_limits<double>::infinity();
      return result;
    }
    const double error = truths_.empty() ? 0 : difference(*outcome.trace, *truths_[i], reference_.until());
    squares += error * error;
    if (compared_until_ > 0) {
      largest_difference = std::max(largest_difference, difference(*outcome.trace, *fulls_[i], compared_until_));
    }
  }
  result.error = truths_.empty() ? std::numeric_limits<double>::quiet_NaN()
                                 : std::sqrt(squares / static_cast<double>(outcomes.size()));
  result.change = std::max(largest_difference, truths_.empty() ? 0.0 : result.error - full_error_);
  if (model.settings == full_.settings) return result;
  const RunRecord record = judged_record(problem_, model, dt_, runs, judging_truth_->reference());
  result.breaks = worse_than_full(record);
  if (chaotic_) {
    result.different = difference_in_statistics(model, overlap_in(record));
  } else {
    result.change = std::max(result.change, overlap_in(record) - full_overlap_);
  }
  return result;
}

std::vector<ModelError::Complaint> ModelError::complaints_of(const RunRecord& record) {
  std::vector<Complaint> all;
  const auto of = [](const std::string& where) { return where.empty() ? "" : " of " + where; };
  for (const InvariantCheck& one : record.invariants) {
    if (one.status == CheckStatus::broken) all.push_back({one.name, one.name + of(one.where)});
  }
  for (const TruthCheck& one : record.truth) {
    if (one.reported && !one.passed) all.push_back({one.quantity + of(one.body), one.quantity + of(one.body)});
  }
  return all;
}

// Each check once, in whatever places it fails.
std::string ModelError::worse_than_full(const RunRecord& record) const {
  std::vector<std::string> known;
  for (const Complaint& one : full_complaints_) known.push_back(one.check);
  std::string words;
  for (const Complaint& one : complaints_of(record)) {
    if (std::find(known.begin(), known.end(), one.check) != known.end()) continue;
    known.push_back(one.check);
    words += (words.empty() ? "" : ", ") + one.words;
  }
  return words;
}

// Runs of one method hardly scatter, so a rank test finds differences that do not matter: only those of more than a
// twentieth of scale count, which is also where a tolerance ceases to be a test.
std::string ModelError::difference_in_statistics(const EngineConfig& model, double overlap) const {
  constexpr double matters = 0.05;
  const Scene& scene = *problem_.scene;
  const std::vector<EnsembleSample> runs = ensemble_of(model);
  const int members = static_cast<int>(runs.front().values.size());
  if (runs.front().values.size() != full_runs_.front().values.size())
    return fmt::format("different: only {} runs reach their end", members);
  const double start = Conserved(scene).energy(fulls_.front()->states(0)).total();
  std::vector<EnsembleDifference> differences = compare_ensembles(full_runs_, runs);
  for (EnsembleDifference& one : differences) {
    const double scale = one.quantity == "energy" ? std::abs(start - one.a.median)
                         : one.quantity == "rest" ? scene.duration
                                                  : one.a.median;
    one.different = one.different && std::abs(one.b.median - one.a.median) > matters * scale;
  }
  std::string words = differences_in_words(differences, members);
  if (overlap - full_overlap_ > matters * smallest_body(scene)) {
    words +=
        fmt::format("{}overlap {:.3g} against {:.3g} m", words.empty() ? "different: " : "; ", overlap, full_overlap_);
  }
  return words;
}

bool ModelError::within_tolerance(const Result& result) const {
  if (result.status != Status::ok || !result.breaks.empty()) return false;
  return chaotic_ ? result.different.empty() : result.change <= tolerance_;
}

// RMS over time and bodies of the displacement of points at the radius of gyration.
double ModelError::difference(const Trace& a, const Trace& b, double until) const {
  const auto all = pose_differences(*problem_.scene, a, b, until);
  double squares = 0;
  for (const PoseDifference& one : all) {
    squares += one.position * one.position + gyration_ * gyration_ * one.angle * one.angle;
  }
  return all.empty() ? 0 : std::sqrt(squares / static_cast<double>(all.size()));
}

}  // namespace plumb
