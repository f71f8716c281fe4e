#include "reports/run/case_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

namespace plumb {
namespace {

const double golden_ratio = (std::sqrt(5.0) - 1) / 2;

std::string choices_of(const Scene& scene, const EngineConfig& config) {
  if (!config.engine->chooses) return "";
  std::string text;
  for (const Choice& choice : config.engine->chooses(scene, config.settings)) {
    text += fmt::format("{}{}={}: {}", text.empty() ? "chose " : "; ", choice.option, choice.value, choice.reason);
  }
  return text;
}

}  // namespace

std::vector<Case> phases(const Case& test_case, int n) {
  std::vector<Case> all(static_cast<std::size_t>(std::max(n, 1)), test_case);
  for (std::size_t k = 1; k < all.size(); ++k) {
    const double multiple = static_cast<double>(k) * golden_ratio;
    all[k].first_step = multiple - std::floor(multiple);
  }
  return all;
}

std::vector<Outcome> run_shifted(const Case& test_case, const EngineConfig& config, double dt) {
  std::vector<Outcome> outcomes;
  if (!test_case.scenario->phased) return outcomes;
  for (const Case& phase : phases(test_case, judged_phases)) {
    if (phase.first_step != test_case.first_step) {
      outcomes.push_back(run(*phase.scene, config, dt, phase.first_step));
    }
  }
  return outcomes;
}

CaseRun run_case(const Case& test_case, const EngineConfig& config, double dt) {
  CaseRun all{.outcome = run(*test_case.scene, config, dt, test_case.first_step)};
  if (all.outcome.status == Status::ok) all.shifted = run_shifted(test_case, config, dt);
  return all;
}

Questions questions_of(const Case& test_case, const ReferenceRun& reference) {
  const Truth* truth = reference.truth;
  Questions questions{.known = reference.converged != nullptr && reference.converged->knows_contact()};
  for (Expectation& one : test_case.scenario->expectations(test_case.parameters)) {
    const double time = one.time.value_or(test_case.scene->duration);
    // Without a closed form, a value that nobody states is a fault of the scenario, which `judge` shows.
    const bool answered =
        one.expected || test_case.closed_form == nullptr || (truth != nullptr && time <= truth->until());
    if (answered) {
      questions.answered.push_back(std::move(one));
    } else {
      // Like what an engine does not report: it counts neither way, and is no evidence.
      questions.open.push_back({.quantity = name_of(one.quantity), .time = time, .reported = false, .idle = true});
    }
  }
  if (!questions.open.empty()) {
    questions.reason = fmt::format("{} of {} values not judged: {}", questions.open.size(),
                                   questions.open.size() + questions.answered.size(),
                                   truth == nullptr ? "the closed form does not handle these parameters"
                                                    : fmt::format("the closed form ends at {:.4g} s", truth->until()));
  }
  return questions;
}

Verdict Questions::verdict(std::span<const TruthCheck> checks, std::span<const InvariantCheck> invariants) const {
  std::vector<TruthCheck> all(checks.begin(), checks.end());
  all.insert(all.end(), open.begin(), open.end());
  const Verdict verdict = verdict_of(all, invariants);
  return verdict == Verdict::plausible && known ? Verdict::no_evidence : verdict;
}

Judgement judge_case(const Case& test_case, const EngineConfig& config, double dt, const Trace& trace,
                     std::span<const Outcome> shifted, const ReferenceRun& reference) {
  const Truth* truth = reference.truth;
  const Questions questions = questions_of(test_case, reference);
  const Stepping stepping = config.engine->stepping(config.settings, dt);
  Judgement judgement;
  if (test_case.scenario->phased) {
    std::vector<const Trace*> traces;
    for (const Outcome& one : shifted) traces.push_back(one.status == Status::ok ? one.trace.get() : nullptr);
    judgement = judge_phases(*test_case.scene, questions.answered, trace, traces, stepping, truth);
  } else {
    judgement = judge(*test_case.scene, questions.answered, trace, stepping, truth);
  }
  if (const ConvergedChecks* converged = reference.converged) {
    std::ranges::move(converged->of(stepping, trace), std::back_inserter(judgement.checks));
    for (TruthCheck& one : judgement.checks) one.idle = one.idle || converged->precedes_touch(one.body, one.time);
  }
  if (judgement.verdict == Verdict::right || (reference.converged != nullptr && judgement.verdict != Verdict::wrong))
    judgement.verdict = questions.verdict(judgement.checks, judgement.invariants);
  return judgement;
}

MetricContext ReferenceRun::context(const Scene& scene, const Trace& of) const {
  return {.scene = scene, .trace = of, .truth = trace.get(), .truth_until = truth != nullptr ? truth->until() : 0};
}

RunRecord record_of(const Case& test_case, const EngineConfig& config, double dt, const Outcome& outcome) {
  RunRecord record{.scenario = test_case.scenario->name,
                   .variant = test_case.variant,
                   .parameters = test_case.parameters,
                   .engine = config.engine->name,
                   .method = config.method(),
                   .exact = config.engine->exact,
                   .dt = dt,
                   .status = outcome.status,
                   .reason = outcome.reason,
                   .scene = test_case.scene,
                   .trace = outcome.trace};
  if (record.status == Status::ok) record.reason = choices_of(*test_case.scene, config);
  if (record.status == Status::failed) record.verdict = Verdict::failed;
  if (record.status == Status::not_supported) record.verdict = Verdict::not_supported;
  return record;
}

RunRecord judged_record(const Case& test_case, const EngineConfig& config, double dt, const CaseRun& runs,
                        const ReferenceRun& reference) {
  RunRecord record = record_of(test_case, config, dt, runs.outcome);
  if (record.status != Status::ok) return record;
  record.converged = reference.converged != nullptr;
  record.metrics = measure(reference.context(*test_case.scene, *record.trace));
  const Questions questions = questions_of(test_case, reference);
  add_reason(record, questions.reason);
  Judgement judgement = judge_case(test_case, config, dt, *record.trace, runs.shifted, reference);
  if (reference.converged != nullptr && judgement.checks.size() == questions.answered.size())
    add_reason(record, "no converged truth for a method of this order and step");
  record.truth = std::move(judgement.checks);
  record.invariants = std::move(judgement.invariants);
  record.verdict = judgement.verdict;
  return record;
}

void add_reason(RunRecord& record, const std::string& reason) {
  if (!reason.empty()) record.reason += (record.reason.empty() ? "" : "; ") + reason;
}

CaseTruth::CaseTruth(const Case& one_case, double dt, std::size_t budget)
    : scene_(one_case.scene), engine_(one_case.closed_form), converged_(converged_reference(one_case, dt, budget)) {
  if (converged_) engine_ = &converged_->engine;
  if (engine_ == nullptr) return;
  outcome_ = run(*scene_, {engine_, complete(*engine_, {})}, dt);
  if (outcome_.status != Status::ok) return;
  truth_.emplace(*engine_, *scene_);
  if (converged_) checks_.emplace(*scene_, *converged_, dt);
}

ReferenceRun CaseTruth::reference() const {
  if (!truth_) return {};
  return {.truth = &*truth_, .trace = outcome_.trace, .converged = checks_ ? &*checks_ : nullptr};
}

double CaseTruth::valid_until() const {
  return checks_ ? converged_->answer->valid_until() : std::numeric_limits<double>::infinity();
}

const CaseTruth& CaseTruths::of(const Case& one_case) {
  Lazy* lazy = nullptr;
  {
    const std::lock_guard alone(looking_);
    lazy = &truths_[one_case.scene];
  }
  std::call_once(lazy->found, [&] { lazy->truth = std::make_unique<const CaseTruth>(one_case, dt_, budget_); });
  return *lazy->truth;
}

}  // namespace plumb
