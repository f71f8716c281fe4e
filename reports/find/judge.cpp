#include "reports/find/judge.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

#include "reference/converged/converged.h"
#include "reference/faults/altered_engine.h"
#include "reports/judge/invariant.h"
#include "reports/judge/metric.h"
#include "reports/run/scene_file.h"
#include "reports/run/selection.h"
#include "scenarios/scene/nearest.h"
#include "scenarios/scene/scene.h"

namespace plumb {
namespace {

constexpr std::string_view fault_mark = "fault:";
constexpr std::string_view closed_form_mark = "closed-form:";

Suspect suspect_of(const Fault& fault) {
  Suspect suspect{.name = std::string(fault_mark) + fault.name,
                  .faulty = std::make_shared<const Engine>(faulty_engine(fault)),
                  .sound = std::make_shared<const Engine>(right_engine(fault))};
  suspect.config = {suspect.faulty.get(), settings_of(fault)};
  suspect.right = EngineConfig{suspect.sound.get(), settings_of(fault)};
  return suspect;
}

std::vector<Suspect> faults_named(std::string_view name) {
  std::vector<Suspect> found;
  std::vector<std::string> names{"all"};
  for (const Fault& fault : all_faults()) {
    if (name == "all" || name == fault.name) found.push_back(suspect_of(fault));
    names.push_back(fault.name);
  }
  if (found.empty()) throw std::invalid_argument(unknown("fault", std::string(name), names));
  return found;
}

std::vector<Suspect> closed_forms_named(std::string_view name) {
  std::vector<Suspect> found;
  std::vector<std::string> names{"all"};
  for (const Engine* engine : Catalog<Engine>::all()) {
    if (!engine->exact) continue;
    names.push_back(engine->name);
    if (name != "all" && name != engine->name) continue;
    found.push_back({.name = std::string(closed_form_mark) + engine->name, .config = {engine, complete(*engine, {})}});
  }
  if (found.empty()) throw std::invalid_argument(unknown("closed form", std::string(name), names));
  return found;
}

}  // namespace

bool is_closed_form(std::string_view suspect) { return suspect.starts_with(closed_form_mark); }

std::vector<Suspect> parse_suspects(std::string_view word) {
  if (is_closed_form(word)) return closed_forms_named(word.substr(closed_form_mark.size()));
  if (word.starts_with(fault_mark)) return faults_named(word.substr(fault_mark.size()));
  return {{.name = std::string(word), .config = parse_engine(word)}};
}

std::vector<Suspect> parse_suspects(const std::vector<std::string>& words) {
  std::vector<Suspect> all;
  for (const std::string& word : words) std::ranges::move(parse_suspects(word), std::back_inserter(all));
  if (!words.empty()) return all;
  for (const EngineConfig& config : default_engines()) {
    if (config.method().empty()) all.push_back({.name = config.engine->name, .config = config});
  }
  return all;
}

namespace {

// Refinement of larger scenes takes seconds, and few of them can be predicted far.
constexpr std::size_t most_refined_bodies = 6;
constexpr std::size_t refinement_budget = 40'000;  // body-steps of each engine
constexpr double converged_share = 0.01;           // of the smallest body, as in `plumb run`
// Every relation takes one to three runs of the engine, and the growth about ten of ours.
constexpr std::size_t most_related_bodies = 16;
constexpr const char* relation_mark = "relation ";

std::vector<double> moments_of(const Scene& scene, const Engine* closed_form) {
  std::vector<double> moments(steps_in(scene.duration, search_step) + 1);
  for (std::size_t i = 0; i < moments.size(); ++i) moments[i] = static_cast<double>(i) * search_step;
  if (closed_form != nullptr) {
    const double until = Truth(*closed_form, scene).until();
    std::erase_if(moments, [&](double moment) { return moment > until; });
  }
  return moments;
}

Complaint complaint_of(const InvariantCheck& check) {
  return {.judge = "invariant",
          .what = check.name,
          .where = check.where,
          .unit = check.unit,
          .value = check.value,
          .tolerance = check.tolerance,
          .ratio = check.ratio,
          .time = check.time};
}

// Keeps the worst of each reason.
void add(std::vector<Complaint>& all, Complaint one) {
  const auto same = std::ranges::find_if(all, [&](const Complaint& other) { return other.reason() == one.reason(); });
  if (same == all.end()) {
    all.push_back(std::move(one));
  } else if (one.ratio > same->ratio) {
    *same = std::move(one);
  }
}

}  // namespace

Judges Judges::of_reason(const std::string& reason) {
  const bool relation = reason.starts_with(relation_mark);
  return {.places = reason.starts_with("closed form") || reason.starts_with("converged"),
          .relations = relation,
          .only = relation ? reason.substr(std::string(relation_mark).size()) : ""};
}

Known::Known(const Scene& scene, Posed posed, Judges judges) : judges_(std::move(judges)) {
  if (posed != Posed::well) return;
  if (judges_.relations && scene.bodies.size() <= most_related_bodies) {
    growth_.emplace(scene, search_step);
    growth_->growth();  // now: what a process of its own measured would be lost with it
  }
  if (!judges_.places || scene.bodies.size() > most_refined_bodies) return;
  const Engine* closed_form = find_closed_form(scene);
  // Bodies on paths go straight within a step, so that a finer answer is of another motion.
  if (closed_form == nullptr && has_paths(scene)) return;
  judge_ = closed_form != nullptr ? "closed form" : "converged";
  // The states of a closed form don't depend on the step, so it converges at once.
  const Refinement refinement{
      .engine = closed_form, .dt = search_step, .tolerance = converged_share, .budget = refinement_budget};
  const std::vector<double> moments = moments_of(scene, closed_form);
  if (moments.size() < 2) return;
  truth_ = closed_form != nullptr ? converged_truth(scene, moments, refinement)
                                  : confirmed_truth(scene, moments, refinement);
  if (truth_->answer != nullptr && truth_->engine.unsupported(scene, {}).empty()) {
    checks_.emplace(scene, *truth_, search_step);
  }
}

std::vector<Complaint> Known::complaints(const EngineConfig& config, const Trace& trace) const {
  std::vector<Complaint> all = misplaced(config.engine->stepping(config.settings, search_step), trace);
  if (!growth_) return all;
  const std::vector<std::string> only = judges_.only.empty() ? std::vector<std::string>{} : std::vector{judges_.only};
  for (const RelationCheck& one : check_relations(*growth_, config, search_step, trace, only)) {
    if (!one.why_not.empty() || one.check.status != CheckStatus::broken) continue;
    Complaint complaint = complaint_of(one.check);
    complaint.judge = "relation";
    complaint.what = one.name;
    add(all, std::move(complaint));
  }
  return all;
}

std::vector<Complaint> Known::misplaced(const Stepping& stepping, const Trace& trace) const {
  return checks_ ? complaints_of(judge_, checks_->of(stepping, trace)) : std::vector<Complaint>{};
}

std::vector<Complaint> complaints_of(const std::string& judge, std::span<const TruthCheck> checks) {
  std::vector<Complaint> all;
  for (const TruthCheck& check : checks) {
    if (check.passed || !check.reported) continue;
    add(all, {.judge = judge,
              .what = check.quantity,
              .sign = check.measured > check.expected ? 1 : -1,
              .where = check.body,
              .unit = check.unit,
              .value = check.error,
              .tolerance = check.tolerance,
              .ratio = error_ratio(check.error, check.tolerance),
              .time = check.time});
  }
  return all;
}

Opinion judged_by_laws(const Scene& scene, Posed posed, const EngineConfig& config) {
  const Outcome outcome = run(scene, config, search_step);
  Opinion opinion{.status = name_of(outcome.status), .note = outcome.reason};
  if (outcome.status == Status::not_supported) return opinion;
  if (outcome.status == Status::failed) {
    opinion.complaints.push_back({.judge = "run",
                                  .what = outcome.lost ? "diverges" : "stops",
                                  .where = outcome.lost ? scene.bodies[*outcome.lost].name : "",
                                  .ratio = std::numeric_limits<double>::infinity(),
                                  .time = outcome.time});
    return opinion;
  }
  if (posed == Posed::overlapping) return opinion;
  const Stepping stepping = config.engine->stepping(config.settings, search_step);
  for (const InvariantCheck& check : check_invariants({scene, *outcome.trace, stepping})) {
    const bool holds_here = posed != Posed::impossible || check.name == "energy" || check.name == "energy_bound";
    if (check.status == CheckStatus::broken && holds_here) add(opinion.complaints, complaint_of(check));
  }
  const auto metrics = measure({.scene = scene, .trace = *outcome.trace});
  const auto value_of = [&](const char* name) -> std::optional<double> {
    const auto found = metrics.find(name);
    return found == metrics.end() ? std::nullopt : std::optional(found->second.value);
  };
  opinion.energy_rise = value_of("energy_rise");
  opinion.overlap = value_of("penetration_max");
  return opinion;
}

std::vector<Complaint> judged_by(const Known& known, const Scene& scene, const EngineConfig& config) {
  const Outcome outcome = run(scene, config, search_step);
  return outcome.status == Status::ok ? known.complaints(config, *outcome.trace) : std::vector<Complaint>{};
}

}  // namespace plumb
