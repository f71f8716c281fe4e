#include "reports/run/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <numbers>
#include <utility>

#include "reports/compare/comparator.h"
#include "reports/judge/invariant.h"
#include "reports/judge/metric.h"
#include "reports/run/case_run.h"
#include "reports/run/horizon.h"
#include "reports/run/relations.h"
#include "reports/run/timings.h"
#include "reports/system/jobs.h"
#include "scenarios/scenario.h"

namespace plumb {
namespace {

// Of the engines' runs.
struct TimeSpent {
  double wall = 0, stepping = 0;  // s
};

std::string converged_words(const ConvergedTruth& truth, double duration) {
  const Converged& answer = *truth.answer;
  const std::string until = answer.reason().empty()
                                ? fmt::format("to the end, {:.4g} s", duration)
                                : fmt::format("until {:.4g} s: {}", answer.valid_until(), answer.reason());
  return fmt::format("converged to {:.1g} m, confirmed by {}, {}", answer.largest_error(), truth.confirmed_by, until);
}

// All runs of one case: the reference first, if there is one.
class CaseExperiment {
 public:
  CaseExperiment(const Case& test_case, double dt) : case_(test_case), dt_(dt), growth_(*test_case.scene, dt) {}

  // With a converged reference (see `converged_reference`) of that many body-steps; 0: none.
  void run_reference(std::size_t budget) {
    truth_ = std::make_unique<const CaseTruth>(case_, dt_, budget);
    const Engine* engine = truth_->engine();
    if (engine == nullptr) return;
    const EngineConfig config{engine, complete(*engine, {})};
    RunRecord record = record_of(case_, config, dt_, truth_->outcome());
    if (record.status == Status::ok) {
      reference_ = truth_->reference();
      record.metrics = measure(reference_.context(*case_.scene, *record.trace));
      if (const ConvergedTruth* converged = truth_->converged()) {
        record.converged = true;
        record.reason = converged_words(*converged, case_.scene->duration);
        record.metrics["truth_estimate_max"] = {converged->answer->largest_error(), "m"};
        record.metrics["truth_until"] = {converged->answer->valid_until(), "s"};
      } else {
        record.invariants = check_invariants({*case_.scene, *record.trace, engine->stepping(config.settings, dt_)});
      }
      record.verdict = Verdict::right;  // by definition; the formula has tests of its own
    }
    records_.push_back(std::move(record));
  }

  void run_engine(const EngineConfig& config, bool relations, bool explain) {
    const CaseRun runs = run_case(case_, config, dt_);
    add_time(runs.outcome);
    for (const Outcome& shifted : runs.shifted) add_time(shifted);
    RunRecord record = judged_record(case_, config, dt_, runs, reference_);
    if (record.status == Status::ok) runnable_.push_back(config);
    if (explain && record.verdict == Verdict::wrong) add_reason(record, cure_of(config));
    if (record.status == Status::ok && relations) judge_by_relations(config, record);
    records_.push_back(std::move(record));
  }

  void compare_engines(int ensemble, std::size_t budget) {
    comparisons_ = compare(records_, reference_.truth);
    if (ensemble > 0) compare_beyond_horizon(case_, runnable_, dt_, ensemble, budget, records_, comparisons_);
  }

  const Case& test_case() const { return case_; }
  /// The converged reference; null if there is none.
  const Engine* refined() const { return truth_->converged() != nullptr ? truth_->engine() : nullptr; }
  const TimeSpent& time_spent() const { return spent_; }
  std::vector<RunRecord>& records() { return records_; }
  std::vector<Comparison>& comparisons() { return comparisons_; }
  const std::vector<EngineConfig>& runnable() const { return runnable_; }

 private:
  // Whether a wrong run is only one that its iterations left unsolved: the same method, judged by the same statement,
  // passes with more of them. "" if not. Its time counts nowhere.
  std::string cure_of(const EngineConfig& config) const {
    const auto more = with_more_iterations(config, dt_);
    if (!more) return "";
    const Verdict cured = judged_record(case_, config, dt_, run_case(case_, more->config, dt_), reference_).verdict;
    for (const Verdict passes : {Verdict::right, Verdict::coarse, Verdict::plausible}) {
      if (cured == passes) {
        return fmt::format("not converged at {}: {} with {} iterations", more->before, name_of(passes), more->after);
      }
    }
    return "";
  }

  void judge_by_relations(const EngineConfig& config, RunRecord& record) const {
    for (RelationCheck& relation : check_relations(growth_, config, dt_, *record.trace)) {
      if (!relation.why_not.empty()) continue;
      relation.check.name = relation_prefix + relation.name;
      record.metrics[relation.check.name] = {relation.share, "1"};
      record.invariants.push_back(std::move(relation.check));
    }
    if (record.verdict == Verdict::wrong) return;
    record.verdict = questions_of(case_, reference_).verdict(record.truth, record.invariants);
  }

  void add_time(const Outcome& outcome) {
    spent_.wall += outcome.wall;
    spent_.stepping += outcome.stepping;
  }

  const Case& case_;
  double dt_;
  SceneGrowth growth_;
  TimeSpent spent_;
  std::unique_ptr<const CaseTruth> truth_;
  ReferenceRun reference_;
  std::vector<RunRecord> records_;
  std::vector<Comparison> comparisons_;
  std::vector<EngineConfig> runnable_;
};

template <class Note>
void add_once(std::vector<Note>& notes, Note note) {
  const bool known = std::any_of(notes.begin(), notes.end(), [&](const Note& one) { return one.name == note.name; });
  if (!known) notes.push_back(std::move(note));
}

void add_note(const Engine& one, Report& report) {
  add_once<EngineNote>(report.engines, {.name = one.name,
                                        .about = one.about,
                                        .source = one.source,
                                        .word = one.word,
                                        .language = one.language,
                                        .execution = one.execution,
                                        .exact = one.exact,
                                        .caveats = one.caveats});
}

// In words, for an engine that fails to say it too: its runs have failed for that.
std::string statement_of(const EngineConfig& config, double dt) {
  std::string why_not;
  const auto stated = stepping_of(config, dt, why_not);
  return stated ? statement(*stated) : why_not;
}

void add_notes(const Plan& plan, Report& report) {
  for (const EngineConfig& config : plan.configs) {
    add_note(*config.engine, report);
    const auto note = std::find_if(report.engines.begin(), report.engines.end(),
                                   [&](const EngineNote& one) { return one.name == config.engine->name; });
    if (!note->exact) note->states.push_back({config.method(), statement_of(config, plan.dt)});
  }
  for (const Case& one : plan.cases) {
    const Scenario& scenario = *one.scenario;
    add_once<ScenarioNote>(report.scenarios, {scenario.name, scenario.question, scenario.parameters, scenario.group});
    if (const ScenarioGroup* group = Catalog<ScenarioGroup>::find(scenario.group))
      add_once<GroupNote>(report.groups, {group->name, group->title, group->stake});
    if (one.closed_form != nullptr) add_note(*one.closed_form, report);
  }
  for (const Metric* metric : Catalog<Metric>::all()) {
    report.metrics.push_back({metric->name, metric->unit, metric->definition, name_of(metric->better)});
  }
  if (plan.ensemble > 0) report.metrics.push_back(horizon_note());
  if (plan.refine > 0) {
    report.metrics.push_back(
        {"truth_estimate_max", "m", "largest estimated error of the converged reference, while it is valid", "lower"});
    report.metrics.push_back({"truth_until", "s", "time up to which the converged reference is valid", "higher"});
  }
  for (const Invariant* invariant : Catalog<Invariant>::all()) {
    report.invariants.push_back({invariant->name, invariant->unit, invariant->definition});
  }
  if (!plan.relations) return;
  for (const MetamorphicRelation* relation : Catalog<MetamorphicRelation>::all()) {
    const std::string name = relation_prefix + relation->name;
    report.invariants.push_back({name, relation->unit, relation->definition});
    report.metrics.push_back({name, "1",
                              "the largest difference of a body's pose from that relation, over how far the body moves "
                              "or its size, up to the horizon",
                              "lower"});
  }
}

}  // namespace

Report run_experiment(const Plan& plan, const Progress& progress) {
  ProgressCounter counter(progress, plan.cases.size() * (plan.configs.size() + 1));
  const auto show = [&](const Case& one, const std::string& what) { counter.begin(label_of(one) + ": " + what); };

  std::vector<CaseExperiment> cases;
  for (const Case& one : plan.cases) cases.emplace_back(one, plan.dt);
  do_all(cases.size(), plan.jobs, [&](std::size_t i) {
    cases[i].run_reference(plan.refine);
    for (const EngineConfig& config : plan.configs) {
      show(cases[i].test_case(), label_of(config.engine->name, config.method()));
      cases[i].run_engine(config, plan.relations, plan.explain);
    }
    cases[i].compare_engines(plan.ensemble, plan.refine);
  });

  Report report;
  TimeSpent spent;
  for (CaseExperiment& one : cases) {
    if (one.refined() != nullptr) add_note(*one.refined(), report);
    show(one.test_case(), plan.timed ? "cost of a step" : "done");
    if (plan.timed)
      std::ranges::move(time_configs(one.test_case(), one.runnable(), plan.dt), std::back_inserter(report.timings));
    std::ranges::move(one.comparisons(), std::back_inserter(report.comparisons));
    std::ranges::move(one.records(), std::back_inserter(report.runs));
    spent.wall += one.time_spent().wall;
    spent.stepping += one.time_spent().stepping;
  }
  add_notes(plan, report);
  report.clock = {{"runs_s", spent.wall},
                  {"steps_s", spent.stepping},
                  {"outside_step", spent.wall > 0 ? 1 - spent.stepping / spent.wall : 0}};
  return report;
}

namespace {

bool differ_in_iterations_alone(const Stepping& a, const Stepping& b) {
  return (a.iterations != b.iterations || a.position_iterations != b.position_iterations) && a.dt == b.dt && a.h == b.h;
}

std::string joined(const std::string& counts, const std::string& count) {
  return counts.empty() ? count : counts + "/" + count;
}

}  // namespace

std::string statement(const Stepping& stepping) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  constexpr double mm = 1000;
  if (stepping.order > 0)
    add(fmt::format("order {} in free motion, in sub-steps of {:.3g} ms", stepping.order, stepping.h * mm));
  if (stepping.impact_lag > 0)
    add(fmt::format("finds impacts up to {:.3g} ms late", stepping.impact_lag * stepping.h * mm));
  if (stepping.impact_lead > 0)
    add(fmt::format("brakes an approach up to {:.3g} ms early", stepping.impact_lead * stepping.h * mm));
  if (stepping.skin > 0) add(fmt::format("bodies may rest {:.3g} mm apart", stepping.skin * mm));
  if (stepping.slop > 0) add(fmt::format("leaves overlaps of up to {:.3g} mm alone", stepping.slop * mm));
  if (stepping.contact_frequency > 0) {
    add(fmt::format("contacts are springs of {:.3g} Hz, {:.3g} Hz on what does not move, and overlap by their load",
                    stepping.contact_frequency, stepping.fixed_contact_frequency));
  }
  if (stepping.held_anchors) add("holds contact points on both bodies for a step, which lets rolling bodies sink in");
  if (stepping.tangent_rotation) add("turns by atan(w h) in a sub-step");
  if (stepping.joint_frequency > 0) {
    add(fmt::format("joints are springs of {:.3g} Hz and open by their load", stepping.joint_frequency));
  }
  if (stepping.joint_slop > 0) add(fmt::format("joints may be open by {:.3g} mm", stepping.joint_slop * mm));
  if (stepping.angular_slop > 0) {
    add(fmt::format("a hinge may rest {:.3g} degrees past its limit", stepping.angular_slop * 180 / std::numbers::pi));
  }
  if (stepping.creep > 0) add(fmt::format("what sticks may creep at {:.3g} mm/s", stepping.creep * mm));
  if (stepping.rest_speed > 0) add(fmt::format("puts to sleep below {:.3g} m/s", stepping.rest_speed));
  if (stepping.restitution_threshold > 0)
    add(fmt::format("nothing bounces below {:.3g} m/s", stepping.restitution_threshold));
  if (stepping.position_iterations > 0) {
    add(fmt::format("{} iterations of velocities, {} of positions", stepping.iterations, stepping.position_iterations));
  } else if (stepping.iterations > 0) {
    add(fmt::format("{} iteration{}", stepping.iterations, stepping.iterations == 1 ? "" : "s"));
  }
  if (stepping.epsilon > 0) add(stepping.epsilon > 1e-9 ? "single precision" : "double precision");
  if (stepping.differenced_velocities) add("keeps velocities as differences of positions");
  return text;
}

std::optional<MoreIterations> with_more_iterations(const EngineConfig& config, double dt) {
  const Stepping stated = config.engine->stepping(config.settings, dt);
  MoreIterations more{.config = config};
  std::string why_not;
  for (const Option& option : config.engine->options) {
    const auto given = config.settings.find(option.key);
    if (!option.whole || given == config.settings.end()) continue;
    const double count = std::stod(given->second);
    const double most = std::min(more_times * count, option.max);
    if (!(most > count)) continue;
    const std::string after = std::to_string(std::llround(most));
    Settings changed = config.settings;
    changed[option.key] = after;
    const auto with_changed = stepping_of({config.engine, changed}, dt, why_not);
    if (!with_changed || !differ_in_iterations_alone(stated, *with_changed)) continue;
    more.before = joined(more.before, given->second);
    more.after = joined(more.after, after);
    more.config.settings[option.key] = after;
  }
  if (more.before.empty()) return std::nullopt;
  return more;
}

}  // namespace plumb
