#include "reports/run/case_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "reports/judge/invariant.h"
#include "reports/judge/metric.h"

namespace plumb {
namespace {

std::string converged_words(const ConvergedTruth& truth, double duration) {
  const Converged& answer = *truth.answer;
  const std::string until = answer.reason().empty()
                                ? fmt::format("to the end, {:.4g} s", duration)
                                : fmt::format("until {:.4g} s: {}", answer.valid_until(), answer.reason());
  return fmt::format("converged to {:.1g} m, confirmed by {}, {}", answer.largest_error(), truth.confirmed_by, until);
}

}  // namespace

CaseJudge::CaseJudge(const Case& test_case, double dt, std::size_t budget)
    : case_(test_case), dt_(dt), refined_(converged_reference(test_case, dt, budget)) {
  const Engine* engine = refined_ ? &refined_->engine : case_.closed_form;
  if (engine == nullptr) return;
  const Scene& scene = *case_.scene;
  const EngineConfig config{engine, complete(*engine, {})};
  record_ = record_of(case_, config, dt_, run(scene, config, dt_));
  if (record_->status != Status::ok) return;
  truth_.emplace(*engine, scene);
  reference_ = {&*truth_, record_->trace};
  record_->metrics = measure(reference_.context(scene, *record_->trace));
  record_->verdict = Verdict::right;  // by definition; the formula has tests of its own
  if (refined_) {
    checks_.emplace(scene, *refined_, dt_);
    record_->reason = converged_words(*refined_, scene.duration);
    record_->metrics["truth_estimate_max"] = {refined_->answer->largest_error(), "m"};
    record_->metrics["truth_until"] = {refined_->answer->valid_until(), "s"};
  } else {
    record_->invariants = check_invariants({scene, *record_->trace, engine->stepping(config.settings, dt_)});
  }
}

RunRecord CaseJudge::judged(const EngineConfig& config, const CaseRun& runs) const {
  return judged(config, runs, config);
}

RunRecord CaseJudge::judged(const EngineConfig& config, const CaseRun& runs, const EngineConfig& stated) const {
  RunRecord record = judged_record(case_, config, dt_, runs, reference_);
  if (record.status != Status::ok || !checks_) return record;
  auto checks = checks_->of(stated.engine->stepping(stated.settings, dt_), *record.trace);
  if (checks.empty()) add_reason(record, "no converged truth for a method of this order and step");
  std::ranges::move(checks, std::back_inserter(record.truth));
  judge_again(record);
  return record;
}

void CaseJudge::judge_again(RunRecord& record) const {
  if (record.verdict == Verdict::wrong) return;
  record.verdict = questions_of(case_, truth()).verdict(record.truth, record.invariants);
}

void add_reason(RunRecord& record, const std::string& reason) {
  if (!reason.empty()) record.reason += (record.reason.empty() ? "" : "; ") + reason;
}

}  // namespace plumb
