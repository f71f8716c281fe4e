#include "reports/run/examine.h"

#include <fmt/format.h>

#include <utility>

#include "reports/run/phases.h"

namespace plumb {
namespace {

std::string choices_of(const Scene& scene, const EngineConfig& config) {
  if (!config.engine->chooses) return "";
  std::string text;
  for (const Choice& choice : config.engine->chooses(scene, config.settings)) {
    text += fmt::format("{}{}={}: {}", text.empty() ? "chose " : "; ", choice.option, choice.value, choice.reason);
  }
  return text;
}

}  // namespace

MetricContext Known::context(const Scene& scene, const Trace& of) const {
  return {.scene = scene, .trace = of, .truth = trace.get(), .truth_until = truth != nullptr ? truth->until() : 0};
}

RunRecord record_of(const Case& asked, const EngineConfig& config, double dt, const Outcome& outcome) {
  RunRecord record{.scenario = asked.scenario->name,
                   .variant = asked.variant,
                   .parameters = asked.parameters,
                   .engine = config.engine->name,
                   .method = config.method(),
                   .exact = config.engine->exact,
                   .dt = dt,
                   .status = outcome.status,
                   .reason = outcome.reason,
                   .scene = asked.scene,
                   .trace = outcome.trace};
  if (record.status == Status::ok) record.reason = choices_of(*asked.scene, config);
  if (record.status == Status::failed) record.verdict = Verdict::failed;
  if (record.status == Status::not_supported) record.verdict = Verdict::not_supported;
  return record;
}

RunRecord examine(const Case& asked, const EngineConfig& config, double dt, const Outcome& outcome,
                  const Known& known) {
  RunRecord record = record_of(asked, config, dt, outcome);
  if (record.status != Status::ok) return record;
  record.metrics = measure(known.context(*asked.scene, *record.trace));
  Judgement judgement = judge_case(asked, config, dt, *record.trace, known.truth);
  record.truth = std::move(judgement.checks);
  record.invariants = std::move(judgement.invariants);
  record.verdict = judgement.verdict;
  return record;
}

}  // namespace plumb
