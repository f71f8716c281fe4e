#include "reports/prove/controls.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/judge/scale.h"
#include "reports/run/case_run.h"
#include "reports/run/experiment.h"
#include "reports/system/jobs.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

bool asks_about_loads(const Case& one_case) {
  const auto expectations = one_case.scenario->expectations(one_case.parameters);
  return std::any_of(expectations.begin(), expectations.end(),
                     [](const Expectation& one) { return one.quantity == Quantity::load; });
}

Unmasking unmasking_of(Verdict verdict, const std::vector<Detection>& detections, double difference) {
  const auto by_truth = [](const Detection& one) { return one.kind == DetectionKind::truth; };
  if (std::any_of(detections.begin(), detections.end(), by_truth)) return Unmasking::truth;
  if (!detections.empty()) return Unmasking::invariant;
  if (difference <= right_share) return Unmasking::same;
  return verdict == Verdict::right || verdict == Verdict::plausible ? Unmasking::passes : Unmasking::inconclusive;
}

bool less_telling(const Detection& a, const Detection& b) { return a.ratio < b.ratio; }

ControlRun control_run(const Case& one_case, const JudgedRun& right, const JudgedRun& control, double difference) {
  const std::vector<Detection> found = physics_detections(one_case, right, control);
  ControlRun run{.scenario = one_case.scenario->name,
                 .variant = one_case.variant,
                 .unmasking = unmasking_of(control.judgement.verdict, found, difference),
                 .verdict = control.judgement.verdict,
                 .difference = difference};
  if (!found.empty()) run.detection = *std::max_element(found.begin(), found.end(), less_telling);
  return run;
}

// By statement, then by control; empty where our engine cannot run the case.
using CaseRuns = std::vector<std::vector<ControlRun>>;

CaseRuns runs_of(const Case& one_case, const std::vector<Control>& controls, const std::vector<EngineConfig>& stated,
                 double dt, const CaseTruth& truth) {
  const Engine& ours = *Catalog<Engine>::find("impulse");
  const Settings settings = complete(ours, {});
  CaseRuns all(stated.size());
  const CaseRun right = run_case(one_case, {&ours, settings}, dt);
  if (right.outcome.status != Status::ok) return all;
  // A motion that is wrong is no standard for others.
  if (judge_run(one_case, {&ours, settings}, dt, right, truth).judgement.verdict == Verdict::wrong) return all;
  std::vector<JudgedRun> right_by;
  for (const EngineConfig& one : stated) right_by.push_back(judge_run(one_case, one, dt, right, truth));
  for (const Control& control : controls) {
    const Engine engine = engine_of(control);
    const CaseRun run = run_case(one_case, {&engine, settings}, dt);
    const double difference =
        run.outcome.status == Status::ok
            ? largest_difference(one_case, *right.outcome.trace, *run.outcome.trace, truth.valid_until())
            : unbounded;
    for (std::size_t s = 0; s < stated.size(); ++s) {
      all[s].push_back(control_run(one_case, right_by[s], judge_run(one_case, stated[s], dt, run, truth), difference));
    }
  }
  return all;
}

}  // namespace

const char* name_of(Unmasking unmasking) {
  switch (unmasking) {
    case Unmasking::truth:
      return "truth";
    case Unmasking::invariant:
      return "invariant";
    case Unmasking::same:
      return "same";
    case Unmasking::inconclusive:
      return "inconclusive";
    case Unmasking::passes:
      return "passes";
  }
  return "";
}

std::size_t ControlResult::count(Unmasking unmasking) const {
  return static_cast<std::size_t>(
      std::count_if(runs.begin(), runs.end(), [&](const ControlRun& one) { return one.unmasking == unmasking; }));
}

const ControlRun* ControlResult::best() const {
  const ControlRun* best = nullptr;
  for (const ControlRun& run : runs) {
    if (run.detection && (best == nullptr || less_telling(*best->detection, *run.detection))) best = &run;
  }
  return best;
}

std::size_t ControlReport::passes() const {
  std::size_t sum = 0;
  for (const ControlResult& result : results) sum += result.count(Unmasking::passes);
  return sum;
}

double largest_difference(const Case& one_case, const Trace& right, const Trace& other, double until) {
  if (other.size() < right.size()) return unbounded;
  if (right.has_contacts() && !other.has_contacts() && asks_about_loads(one_case)) return unbounded;
  const Scene& scene = *one_case.scene;
  const Scales scales(scene, right);
  const auto start = right.states(0);
  double largest = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].type != BodyType::dynamic) continue;
    const std::string& name = scene.bodies[i].name;
    const double distance = scales.of({.body = name, .quantity = Quantity::x}, start[i].position.x);
    const double angle = scales.of({.body = name, .quantity = Quantity::angle}, start[i].angle);
    for (std::size_t moment = 0; moment < right.size() && right.time(moment) <= until; ++moment) {
      const BodyState& a = right.states(moment)[i];
      const BodyState& b = other.states(moment)[i];
      largest = std::max({largest, length(a.position - b.position) / distance, std::abs(a.angle - b.angle) / angle});
    }
  }
  return largest;
}

std::vector<ControlReport> prove_controls(const std::vector<Control>& controls, const std::vector<Case>& cases,
                                          const std::vector<EngineConfig>& stated, CaseTruths& truths, int jobs,
                                          const Progress& progress) {
  ProgressCounter counter(progress, cases.size());
  std::vector<CaseRuns> runs(cases.size());
  do_all(cases.size(), jobs, [&](std::size_t c) {
    counter.begin(label_of(cases[c]));
    runs[c] = runs_of(cases[c], controls, stated, truths.dt(), truths.of(cases[c]));
  });
  std::vector<ControlReport> reports;
  for (std::size_t s = 0; s < stated.size(); ++s) {
    reports.push_back({.stated = label_of(stated[s].engine->name, stated[s].method()), .cases = cases.size()});
    for (std::size_t i = 0; i < controls.size(); ++i) {
      ControlResult result{.control = controls[i]};
      for (const CaseRuns& of_case : runs) {
        if (!of_case[s].empty()) result.runs.push_back(of_case[s][i]);
      }
      reports.back().results.push_back(std::move(result));
    }
    reports.back().left_out = static_cast<std::size_t>(
        std::count_if(runs.begin(), runs.end(), [s](const CaseRuns& of_case) { return of_case[s].empty(); }));
  }
  return reports;
}

}  // namespace plumb
