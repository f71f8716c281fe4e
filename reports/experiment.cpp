#include "reports/experiment.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "reports/comparator.h"
#include "reports/metric.h"
#include "reports/truth.h"
#include "reports/verdict.h"

namespace plumb {
namespace {

struct Spent {
  double wall = 0, stepping = 0;  // s
};

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
  if (record.status == Status::failed) record.verdict = Verdict::failed;
  if (record.status == Status::not_supported) record.verdict = Verdict::not_supported;
  return record;
}

// All runs of one case: the closed form first, where there is one.
class CaseRun {
 public:
  CaseRun(const Case& asked, double dt, Spent& spent) : asked_(asked), dt_(dt), spent_(spent) {
    if (asked.closed_form == nullptr) return;
    const Entrant closed_form{asked.closed_form, complete(*asked.closed_form, {})};
    RunRecord record = record_of(asked, closed_form, dt, run(*asked.scene, closed_form, dt));
    if (record.status == Status::ok) {
      truth_.emplace(*asked.closed_form, *asked.scene);
      truth_trace_ = record.trace;
      record.metrics = measure(evidence(*record.trace));
      record.verdict = Verdict::right;  // by definition; its formula has tests of its own
    }
    records_.push_back(std::move(record));
  }

  void add(const Entrant& entrant) {
    const Outcome outcome = run(*asked_.scene, entrant, dt_);
    spent_.wall += outcome.wall;
    spent_.stepping += outcome.stepping;
    RunRecord record = record_of(asked_, entrant, dt_, outcome);
    if (record.status == Status::ok) {
      record.metrics = measure(evidence(*record.trace));
      Judgement judgement = judge(*asked_.scene, asked_.scenario->expectations(asked_.parameters), *record.trace,
                                  entrant.contender->stepping(entrant.settings, dt_), truth_ ? &*truth_ : nullptr);
      record.truth = std::move(judgement.checks);
      record.verdict = judgement.verdict;
      runnable_.push_back(entrant);
    }
    records_.push_back(std::move(record));
  }

  std::vector<RunRecord>& records() { return records_; }
  const std::vector<Entrant>& runnable() const { return runnable_; }

 private:
  Evidence evidence(const Trace& trace) const {
    return {.scene = *asked_.scene,
            .trace = trace,
            .truth = truth_trace_.get(),
            .truth_until = truth_ ? truth_->until() : 0};
  }

  const Case& asked_;
  double dt_;
  Spent& spent_;
  std::optional<Truth> truth_;
  std::shared_ptr<const Trace> truth_trace_;
  std::vector<RunRecord> records_;
  std::vector<Entrant> runnable_;
};

const char* name_of(Better better) {
  switch (better) {
    case Better::lower:
      return "lower";
    case Better::higher:
      return "higher";
    case Better::neither:
      return "neither";
  }
  return "";
}

template <class Note>
void add_once(std::vector<Note>& notes, Note note) {
  const bool known = std::any_of(notes.begin(), notes.end(), [&](const Note& one) { return one.name == note.name; });
  if (!known) notes.push_back(std::move(note));
}

void add_notes(const Plan& plan, Report& report) {
  const auto add_engine = [&](const Contender& one) {
    add_once<EngineNote>(report.engines, {one.name, one.about, one.source, one.exact});
  };
  for (const Entrant& entrant : plan.entrants) add_engine(*entrant.contender);
  for (const Case& asked : plan.cases) {
    const Scenario& scenario = *asked.scenario;
    add_once<ScenarioNote>(report.scenarios,
                           {scenario.name, scenario.question, scenario.closed_form, scenario.parameters});
    if (asked.closed_form != nullptr) add_engine(*asked.closed_form);
  }
  for (const Metric* metric : Catalog<Metric>::all()) {
    report.metrics.push_back({metric->name, metric->unit, metric->definition, name_of(metric->better)});
  }
}

}  // namespace

Report carry_out(const Plan& plan, const Progress& progress) {
  Report report;
  Spent spent;
  std::size_t done = 0;
  const std::size_t all = plan.cases.size() * (plan.entrants.size() + 1);
  for (const Case& asked : plan.cases) {
    const std::string name = asked.scenario->name + " " + asked.variant + ": ";
    CaseRun runs(asked, plan.dt, spent);
    for (const Entrant& entrant : plan.entrants) {
      progress(name + label_of(entrant.contender->name, entrant.method()), done++, all);
      runs.add(entrant);
    }
    const auto comparisons = compare(runs.records());
    report.comparisons.insert(report.comparisons.end(), comparisons.begin(), comparisons.end());
    progress(name + "cost of a step", done++, all);
    const auto timings = time_steps(asked, runs.runnable(), plan.dt);
    report.timings.insert(report.timings.end(), timings.begin(), timings.end());
    for (RunRecord& record : runs.records()) report.runs.push_back(std::move(record));
  }
  add_notes(plan, report);
  report.clock = {{"runs_s", spent.wall},
                  {"steps_s", spent.stepping},
                  {"outside_step", spent.wall > 0 ? 1 - spent.stepping / spent.wall : 0}};
  return report;
}

}  // namespace plumb
