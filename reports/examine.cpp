#include "reports/examine.h"

#include <fmt/format.h>

#include <utility>

#include "reports/phases.h"

namespace plumb {
namespace {

std::string choices_of(const Scene& scene, const Entrant& entrant) {
  if (!entrant.contender->chooses) return "";
  std::string text;
  for (const Choice& choice : entrant.contender->chooses(scene, entrant.settings)) {
    text += fmt::format("{}{}={}: {}", text.empty() ? "chose " : "; ", choice.option, choice.value, choice.reason);
  }
  return text;
}

}  // namespace

Evidence Known::evidence(const Scene& scene, const Trace& of) const {
  return {.scene = scene, .trace = of, .truth = trace.get(), .truth_until = truth != nullptr ? truth->until() : 0};
}

RunRecord record_of(const Case& asked, const Entrant& entrant, double dt, const Outcome& outcome) {
  RunRecord record{.scenario = asked.scenario->name,
                   .variant = asked.variant,
                   .parameters = asked.parameters,
                   .engine = entrant.contender->name,
                   .method = entrant.method(),
                   .exact = entrant.contender->exact,
                   .dt = dt,
                   .status = outcome.status,
                   .reason = outcome.reason,
                   .scene = asked.scene,
                   .trace = outcome.trace};
  if (record.status == Status::ok) record.reason = choices_of(*asked.scene, entrant);
  if (record.status == Status::failed) record.verdict = Verdict::failed;
  if (record.status == Status::not_supported) record.verdict = Verdict::not_supported;
  return record;
}

RunRecord examine(const Case& asked, const Entrant& entrant, double dt, const Outcome& outcome, const Known& known) {
  RunRecord record = record_of(asked, entrant, dt, outcome);
  if (record.status != Status::ok) return record;
  record.metrics = measure(known.evidence(*asked.scene, *record.trace));
  Judgement judgement = judge_case(asked, entrant, dt, *record.trace, known.truth);
  record.truth = std::move(judgement.checks);
  record.invariants = std::move(judgement.invariants);
  record.verdict = judgement.verdict;
  return record;
}

}  // namespace plumb
