#include "reports/prove/detection.h"

#include <limits>
#include <utility>

namespace plumb {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Detection detection_in(const Case& one_case, DetectionKind kind, std::string metric) {
  return {.scenario = one_case.scenario->name, .variant = one_case.variant, .kind = kind, .metric = std::move(metric)};
}

// The truths and invariants that a run fails, but not those that another run of the case fails as well. `right` may be
// null.
std::vector<Detection> failed_checks(const Case& one_case, const JudgedRun& suspect, const JudgedRun* right) {
  if (suspect.status != Status::ok) {
    Detection lost = detection_in(one_case, DetectionKind::invariant, "the run's end");
    lost.ratio = infinite;
    return {lost};
  }
  std::vector<Detection> all;
  const auto& checks = suspect.judgement.checks;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    const TruthCheck& check = checks[i];
    if (check.passed || !check.reported) continue;
    if (right != nullptr && !right->judgement.checks[i].passed) continue;
    Detection missed = detection_in(one_case, DetectionKind::truth,
                                    check.body.empty() ? check.quantity : check.body + " " + check.quantity);
    missed.unit = check.unit;
    missed.error = check.error;
    missed.tolerance = check.tolerance;
    missed.ratio = error_ratio(check.error, check.tolerance);
    all.push_back(missed);
  }
  const auto& invariants = suspect.judgement.invariants;
  for (std::size_t i = 0; i < invariants.size(); ++i) {
    if (!(invariants[i].ratio > 1)) continue;
    if (right != nullptr && !(right->judgement.invariants[i].ratio <= 1)) continue;
    Detection broken = detection_in(one_case, DetectionKind::invariant, invariants[i].name);
    broken.unit = invariants[i].unit;
    broken.error = invariants[i].value;
    broken.tolerance = invariants[i].tolerance;
    broken.ratio = invariants[i].ratio;
    all.push_back(broken);
  }
  return all;
}

Detection unrepeatable(const Case& one_case) {
  Detection other = detection_in(one_case, DetectionKind::repeat, "bits of two runs");
  other.ratio = infinite;
  return other;
}

}  // namespace

JudgedRun judge_run(const Case& one_case, const EngineConfig& stated, double dt, const CaseRun& runs,
                    const CaseTruth& truth) {
  const auto& [outcome, shifted] = runs;
  JudgedRun judged{.status = outcome.status, .reason = outcome.reason};
  if (outcome.trace) judged.bits = hash_of(*outcome.trace);
  if (outcome.status != Status::ok) return judged;
  judged.judgement = judge_case(one_case, stated, dt, *outcome.trace, shifted, truth.reference());
  return judged;
}

JudgedRun judge_two_runs(const Case& one_case, const EngineConfig& config, double dt, const CaseTruth& truth) {
  JudgedRun judged = judge_run(one_case, config, dt, run_case(one_case, config, dt), truth);
  if (judged.status != Status::ok) return judged;
  const Outcome again = run(*one_case.scene, config, dt, one_case.first_step);
  judged.repeatable = again.trace && hash_of(*again.trace) == judged.bits;
  return judged;
}

const char* name_of(DetectionKind kind) {
  switch (kind) {
    case DetectionKind::truth:
      return "truth";
    case DetectionKind::invariant:
      return "invariant";
    case DetectionKind::repeat:
      return "repeat";
    case DetectionKind::bits:
      return "bits";
  }
  return "";
}

std::vector<Detection> physics_detections(const Case& one_case, const JudgedRun& right, const JudgedRun& suspect) {
  return right.status == Status::ok ? failed_checks(one_case, suspect, &right) : std::vector<Detection>{};
}

std::vector<Detection> detections(const Case& one_case, const JudgedRun& right, const JudgedRun& suspect) {
  if (right.status != Status::ok) return {};
  std::vector<Detection> all = physics_detections(one_case, right, suspect);
  if (right.repeatable && !suspect.repeatable) all.push_back(unrepeatable(one_case));
  if (all.empty() && suspect.bits != right.bits) {
    all.push_back(detection_in(one_case, DetectionKind::bits, "bits"));
  }
  return all;
}

std::vector<Detection> false_alarms(const Case& one_case, const JudgedRun& run) {
  std::vector<Detection> all = failed_checks(one_case, run, nullptr);
  if (!run.repeatable) all.push_back(unrepeatable(one_case));
  return all;
}

std::vector<LooseTruth> loose_truths(const Case& one_case, const JudgedRun& run) {
  std::vector<LooseTruth> all;
  for (NotATest& one : not_tests(run.judgement.checks))
    all.push_back({one_case.scenario->name, one_case.variant, std::move(one)});
  return all;
}

}  // namespace plumb
