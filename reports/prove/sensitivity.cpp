#include "reports/prove/sensitivity.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "reports/system/jobs.h"

namespace plumb {
namespace {

// Cases that a statement follows to smaller errors: those that see the present one most clearly.
constexpr std::size_t most_followed = 10;

// A case with the judgements of our engine as it is, by each statement. A check that an error of round-off size breaks
// is not held there.
struct JudgedCase {
  const Case* one = nullptr;
  const CaseTruth* truth = nullptr;
  std::vector<JudgedRun> right;
  std::string unstable;  // the first check, by our own statement, that held without such an error
};

// A case and the sign of the error.
struct Trial {
  std::size_t number = 0;  // of the case
  double sign = 1;
  friend auto operator<=>(const Trial&, const Trial&) = default;
};

// What a trial showed to a statement: the check with the largest ratio.
using Seen = std::optional<Detection>;

std::vector<JudgedRun> judged_by_all(const JudgedCase& of, const Outcome& outcome,
                                     const std::vector<EngineStatement>& statements, double dt) {
  std::vector<JudgedRun> all;
  for (const EngineStatement& statement : statements) {
    JudgedRun judged{.status = outcome.status, .reason = outcome.reason};
    if (outcome.status == Status::ok) {
      judged.judgement = judge_case(*of.one, statement.config, dt, *outcome.trace, {}, of.truth->reference());
    }
    all.push_back(std::move(judged));
  }
  return all;
}

// Takes a check as held only if it held in `also`, too.
void hold_in_both(JudgedRun& right, const JudgedRun& also) {
  for (std::size_t i = 0; i < right.judgement.checks.size(); ++i) {
    right.judgement.checks[i].passed = right.judgement.checks[i].passed && also.judgement.checks[i].passed;
  }
  for (std::size_t i = 0; i < right.judgement.invariants.size(); ++i) {
    double& ratio = right.judgement.invariants[i].ratio;
    ratio = std::max(ratio, also.judgement.invariants[i].ratio);
  }
}

JudgedCase judged_case(const Case& one, const std::vector<EngineStatement>& statements, CaseTruths& truths) {
  const double dt = truths.dt();
  JudgedCase judged{.one = &one, .truth = &truths.of(one)};
  const Engine& ours = *Catalog<Engine>::find("impulse");
  const Outcome outcome = run(*one.scene, {&ours, complete(ours, {})}, dt, one.first_step);
  judged.right = judged_by_all(judged, outcome, statements, dt);
  if (outcome.status != Status::ok) return judged;
  for (const Perturbation& parameter : all_perturbations()) {
    if (!parameter.applies(*one.scene)) continue;
    const Engine engine = perturbed_engine(parameter, round_off_error);
    const Outcome off = run(*one.scene, {&engine, complete(engine, {})}, dt, one.first_step);
    if (off.status != Status::ok) continue;
    const std::vector<JudgedRun> runs = judged_by_all(judged, off, statements, dt);
    const std::vector<Detection> broken = physics_detections(one, judged.right.front(), runs.front());
    if (judged.unstable.empty() && !broken.empty()) judged.unstable = broken.front().metric;
    for (std::size_t s = 0; s < runs.size(); ++s) hold_in_both(judged.right[s], runs[s]);
  }
  return judged;
}

// Searches for the smallest error of one parameter.
class Search {
 public:
  Search(const Perturbation& parameter, const std::vector<JudgedCase>& cases,
         const std::vector<EngineStatement>& statements, double dt, int jobs)
      : parameter_(parameter), cases_(cases), statements_(statements), dt_(dt), jobs_(jobs) {}

  Sensitivity result();

 private:
  using Sightings = std::vector<std::vector<Seen>>;  // by trial and statement

  Sightings look(const std::vector<Trial>&, double error) const;
  std::vector<Seen> look(const Trial&, double error) const;
  std::optional<Sighting> bisect(std::size_t statement, std::vector<Trial>, double error) const;

  const Perturbation& parameter_;
  const std::vector<JudgedCase>& cases_;
  const std::vector<EngineStatement>& statements_;
  double dt_;
  int jobs_;
};

std::vector<Seen> Search::look(const Trial& trial, double error) const {
  const JudgedCase& of = cases_[trial.number];
  const Engine engine = perturbed_engine(parameter_, trial.sign * error);
  const Outcome outcome = run(*of.one->scene, {&engine, complete(engine, {})}, dt_, of.one->first_step);
  std::vector<Seen> seen(statements_.size());
  if (outcome.status == Status::not_supported) return seen;
  const std::vector<JudgedRun> judged = judged_by_all(of, outcome, statements_, dt_);
  for (std::size_t s = 0; s < seen.size(); ++s) {
    const std::vector<Detection> all = physics_detections(*of.one, of.right[s], judged[s]);
    const auto best = std::max_element(all.begin(), all.end(),
                                       [](const Detection& a, const Detection& b) { return a.ratio < b.ratio; });
    if (best != all.end()) seen[s] = *best;
  }
  return seen;
}

Search::Sightings Search::look(const std::vector<Trial>& trials, double error) const {
  Sightings seen(trials.size());
  do_all(trials.size(), jobs_, [&](std::size_t i) { seen[i] = look(trials[i], error); });
  return seen;
}

// The trials that a statement saw, the clearest first.
std::vector<std::size_t> seen_by(std::size_t statement, const std::vector<std::vector<Seen>>& seen) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i][statement]) numbers.push_back(i);
  }
  std::stable_sort(numbers.begin(), numbers.end(),
                   [&](std::size_t a, std::size_t b) { return seen[a][statement]->ratio > seen[b][statement]->ratio; });
  return numbers;
}

// Some of the trials see `error`, none sees a tenth of it. At each error in between, those that see it stay.
std::optional<Sighting> Search::bisect(std::size_t statement, std::vector<Trial> trials, double error) const {
  std::optional<Sighting> smallest;
  double unseen = error / 10;
  for (double next = error; smallest == std::nullopt || error / unseen > error_precision;
       next = std::sqrt(error * unseen)) {
    const Sightings seen = look(trials, next);
    const std::vector<std::size_t> by = seen_by(statement, seen);
    if (by.empty()) {
      if (!smallest) return std::nullopt;
      unseen = next;
      continue;
    }
    error = next;
    smallest = Sighting{trials[by.front()].sign * next, *seen[by.front()][statement]};
    std::vector<Trial> left;
    for (const std::size_t i : by) left.push_back(trials[i]);
    trials = std::move(left);
  }
  return smallest;
}

Sensitivity Search::result() {
  Sensitivity result{.parameter = parameter_, .sighted = std::vector<std::optional<Sighting>>(statements_.size())};
  std::vector<Trial> trials;
  for (std::size_t c = 0; c < cases_.size(); ++c) {
    if (!parameter_.applies(*cases_[c].one->scene)) continue;
    ++result.cases;
    for (const double sign : {1.0, -1.0}) trials.push_back({c, sign});
  }
  // The smallest decade that each statement sees, and who sees it.
  struct Decade {
    double error = 0;
    std::vector<Trial> trials;
  };
  std::vector<Decade> last(statements_.size());
  for (double error = largest_error; error > smallest_error / 2 && !trials.empty(); error /= 10) {
    const Sightings seen = look(trials, error);
    std::set<Trial> followed;
    for (std::size_t s = 0; s < statements_.size(); ++s) {
      std::vector<Trial> by;
      for (const std::size_t i : seen_by(s, seen)) by.push_back(trials[i]);
      if (by.empty()) continue;
      by.resize(std::min(by.size(), most_followed));
      followed.insert(by.begin(), by.end());
      last[s] = {error, std::move(by)};
    }
    trials.assign(followed.begin(), followed.end());
  }
  for (std::size_t s = 0; s < statements_.size(); ++s) {
    if (last[s].error > 0) result.sighted[s] = bisect(s, last[s].trials, last[s].error);
  }
  return result;
}

}  // namespace

std::vector<EngineStatement> engine_statements() {
  std::vector<EngineStatement> all;
  for (const auto& [name, goal] :
       {std::pair<const char*, std::optional<double>>{"impulse", 1e-4}, {"box2d", 0.02}, {"chipmunk", std::nullopt}}) {
    const Engine* engine = Catalog<Engine>::find(name);
    if (engine != nullptr) all.push_back({name, {engine, complete(*engine, {})}, goal});
  }
  return all;
}

bool Sensitivity::reaches(std::size_t statement, const EngineStatement& of) const {
  if (!of.goal) return true;
  const std::optional<Sighting>& seen = sighted[statement];
  return seen && std::abs(seen->error) <= *of.goal;
}

std::vector<Perturbation> all_perturbations() {
  std::vector<Perturbation> all;
  for (const Perturbation* one : Catalog<Perturbation>::all()) all.push_back(*one);
  return all;
}

Sensitivities sensitivities(const std::vector<Perturbation>& parameters, const std::vector<Case>& cases,
                            const std::vector<EngineStatement>& statements, CaseTruths& truths, int jobs,
                            const Progress& progress) {
  const std::size_t all = parameters.size() + 1;
  progress("our engine as it is", 0, all);
  std::vector<JudgedCase> judged(cases.size());
  do_all(cases.size(), jobs, [&](std::size_t c) { judged[c] = judged_case(cases[c], statements, truths); });
  Sensitivities found;
  for (const JudgedCase& of : judged) {
    if (of.unstable.empty()) continue;
    const std::string& variant = of.one->variant;
    found.unstable.push_back(of.one->scenario->name + (variant.empty() ? "" : ":" + variant) + ", " + of.unstable);
  }
  for (const Perturbation& parameter : parameters) {
    progress(parameter.name, found.parameters.size() + 1, all);
    found.parameters.push_back(Search(parameter, judged, statements, truths.dt(), jobs).result());
  }
  return found;
}

}  // namespace plumb
