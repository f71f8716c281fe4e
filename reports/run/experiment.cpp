#include "reports/run/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <mutex>
#include <optional>
#include <utility>

#include "reference/converged/converged.h"
#include "reports/compare/comparator.h"
#include "reports/judge/invariant.h"
#include "reports/judge/metric.h"
#include "reports/judge/truth.h"
#include "reports/run/beyond.h"
#include "reports/run/examine.h"
#include "reports/system/jobs.h"

namespace plumb {
namespace {

struct Spent {
  double wall = 0, stepping = 0;  // s
};

std::vector<double> moments_in(double duration, double dt) {
  std::vector<double> moments(steps_in(duration, dt) + 1);
  for (std::size_t i = 0; i < moments.size(); ++i) moments[i] = static_cast<double>(i) * dt;
  return moments;
}

// All runs of one case: the closed form first, where there is one.
class CaseRun {
 public:
  CaseRun(const Case& asked, double dt) : asked_(asked), dt_(dt) {}

  void find_truth(bool refine) {
    const Engine* witness = asked_.closed_form;
    if (witness == nullptr && refine) {
      refined_ = converged_truth(*asked_.scene, moments_in(asked_.scene->duration, dt_), {.dt = dt_});
      witness = &refined_->engine;
    }
    if (witness == nullptr) return;
    const EngineConfig closed_form{witness, complete(*witness, {})};
    RunRecord record = record_of(asked_, closed_form, dt_, run(*asked_.scene, closed_form, dt_));
    if (record.status == Status::ok) {
      truth_.emplace(*witness, *asked_.scene);
      known_ = {&*truth_, record.trace};
      record.metrics = measure(known_.context(*asked_.scene, *record.trace));
      if (refined_) record.metrics["truth_estimate_max"] = {refined_->answer->largest_error(), "m"};
      if (!refined_) {
        record.invariants =
            check_invariants({*asked_.scene, *record.trace, witness->stepping(closed_form.settings, dt_)});
      }
      record.verdict = Verdict::right;  // by definition; its formula has tests of its own
    }
    records_.push_back(std::move(record));
  }

  void add(const EngineConfig& config) {
    const Outcome outcome = run(*asked_.scene, config, dt_);
    spent_.wall += outcome.wall;
    spent_.stepping += outcome.stepping;
    RunRecord record = examine(asked_, config, dt_, outcome, known_);
    if (record.status == Status::ok) runnable_.push_back(config);
    records_.push_back(std::move(record));
  }

  void compare_all(int ensemble) {
    comparisons_ = compare(records_);
    if (ensemble > 0) look_beyond(asked_, runnable_, dt_, ensemble, records_, comparisons_);
  }

  const Case& asked() const { return asked_; }
  /// Who answers for the truth where no closed form does; null where none was asked.
  const Engine* refined() const { return refined_ ? &refined_->engine : nullptr; }
  const Spent& spent() const { return spent_; }
  std::vector<RunRecord>& records() { return records_; }
  std::vector<Comparison>& comparisons() { return comparisons_; }
  const std::vector<EngineConfig>& runnable() const { return runnable_; }

 private:
  const Case& asked_;
  double dt_;
  Spent spent_;
  std::optional<ConvergedTruth> refined_;
  std::optional<Truth> truth_;
  Known known_;
  std::vector<RunRecord> records_;
  std::vector<Comparison> comparisons_;
  std::vector<EngineConfig> runnable_;
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

void add_note(const Engine& one, Report& report) {
  add_once<EngineNote>(report.engines, {one.name, one.about, one.source, one.exact});
}

void add_notes(const Plan& plan, Report& report) {
  for (const EngineConfig& config : plan.configs) add_note(*config.engine, report);
  for (const Case& asked : plan.cases) {
    const Scenario& scenario = *asked.scenario;
    add_once<ScenarioNote>(report.scenarios,
                           {scenario.name, scenario.question, scenario.closed_form, scenario.parameters});
    if (asked.closed_form != nullptr) add_note(*asked.closed_form, report);
  }
  for (const Metric* metric : Catalog<Metric>::all()) {
    report.metrics.push_back({metric->name, metric->unit, metric->definition, name_of(metric->better)});
  }
  if (plan.ensemble > 0) report.metrics.push_back(horizon_note());
  if (plan.refine) {
    report.metrics.push_back(
        {"truth_estimate_max", "m", "largest error that a converged reference admits to, while it holds", "lower"});
  }
  for (const Invariant* invariant : Catalog<Invariant>::all()) {
    report.invariants.push_back({invariant->name, invariant->unit, invariant->definition});
  }
}

}  // namespace

Report carry_out(const Plan& plan, const Progress& progress) {
  std::mutex telling;
  std::size_t done = 0;
  const std::size_t all = plan.cases.size() * (plan.configs.size() + 1);
  const auto tell = [&](const Case& asked, const std::string& what) {
    const std::lock_guard alone(telling);
    progress(asked.scenario->name + " " + asked.variant + ": " + what, done++, all);
  };

  std::vector<CaseRun> runs;
  for (const Case& asked : plan.cases) runs.emplace_back(asked, plan.dt);
  do_all(runs.size(), plan.jobs, [&](std::size_t i) {
    runs[i].find_truth(plan.refine);
    for (const EngineConfig& config : plan.configs) {
      tell(runs[i].asked(), label_of(config.engine->name, config.method()));
      runs[i].add(config);
    }
    runs[i].compare_all(plan.ensemble);
  });

  Report report;
  Spent spent;
  for (CaseRun& one : runs) {
    if (one.refined() != nullptr) add_note(*one.refined(), report);
    tell(one.asked(), plan.timed ? "cost of a step" : "done");
    if (plan.timed)
      std::ranges::move(time_steps(one.asked(), one.runnable(), plan.dt), std::back_inserter(report.timings));
    std::ranges::move(one.comparisons(), std::back_inserter(report.comparisons));
    std::ranges::move(one.records(), std::back_inserter(report.runs));
    spent.wall += one.spent().wall;
    spent.stepping += one.spent().stepping;
  }
  add_notes(plan, report);
  report.clock = {{"runs_s", spent.wall},
                  {"steps_s", spent.stepping},
                  {"outside_step", spent.wall > 0 ? 1 - spent.stepping / spent.wall : 0}};
  return report;
}

}  // namespace plumb
