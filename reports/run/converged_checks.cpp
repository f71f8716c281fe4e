#include "reports/run/converged_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "reference/converged/converged.h"
#include "reports/judge/groups.h"
#include "reports/judge/verdict.h"
#include "scenarios/allowance.h"
#include "scenarios/scene/scene.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

constexpr std::size_t most_moments = 24;  // at which a check may be made
constexpr double never = std::numeric_limits<double>::infinity();

// J: a state's energy changes by m v dv + I w dw with its speeds, and by its weight with its height.
double energy_error_of(const Scene& scene, std::span<const BodyState> states, std::span<const StateError> errors) {
  const Conserved conserved(scene);
  const auto masses = conserved.masses();
  double error = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto& [mass, inertia, center] = masses[i];
    if (mass == 0) continue;
    error += mass * length(states[i].velocity) * errors[i].velocity +
             inertia * std::abs(states[i].angular_velocity) * errors[i].angular_velocity +
             mass * length(scene.gravity) * errors[i].position;
  }
  return error;
}

// The largest error of a pose that a converged reference may have, as a share of the smallest body. Its errors are part
// of the tolerances.
constexpr double converged_share = 0.01;

bool asks_for_places(const Case& one_case) {
  const Scene& scene = *one_case.scene;
  const auto expectations = one_case.scenario->expectations(one_case.parameters);
  return std::any_of(expectations.begin(), expectations.end(), [&](const Expectation& one) {
    const bool place = one.quantity == Quantity::x || one.quantity == Quantity::y || one.quantity == Quantity::angle ||
                       one.quantity == Quantity::apex;
    return place && one.relation == Relation::equal &&
           (one.body.empty() || scene.bodies[index_of(scene, one.body)].type == BodyType::dynamic);
  });
}

std::vector<double> moments_in(double duration, double dt) {
  std::vector<double> moments(steps_in(duration, dt) + 1);
  for (std::size_t i = 0; i < moments.size(); ++i) moments[i] = static_cast<double>(i) * dt;
  return moments;
}

// s, by body: when it, or one that joints connect with it, first touches anything; infinite if that never happens, or
// our engine can't run the scene.
std::vector<double> first_touches(const Scene& scene, double dt) {
  std::vector<double> first(scene.bodies.size(), never);
  const Outcome outcome = run(scene, our_config(), dt);
  if (!outcome.trace) return first;
  Groups groups(first.size());
  for (const Joint& joint : scene.joints) std::visit([&](const auto& of) { groups.join(of.a, of.b); }, joint);
  for (std::size_t moment = outcome.trace->size(); moment-- > 0;) {
    for (const ContactState& contact : outcome.trace->contacts(moment)) {
      if (contact.normal_impulse <= 0) continue;
      for (const std::size_t body : {contact.a, contact.b}) first[groups.of(body)] = outcome.trace->time(moment);
    }
  }
  std::vector<double> all;
  for (std::size_t i = 0; i < first.size(); ++i) all.push_back(first[groups.of(i)]);
  return all;
}

}  // namespace

std::optional<ConvergedTruth> converged_reference(const Case& one_case, double dt, std::size_t budget) {
  const Engine* closed_form = one_case.closed_form;
  const Scene& scene = *one_case.scene;
  const bool solved = closed_form != nullptr && closed_form->unsupported(scene, complete(*closed_form, {})).empty();
  if (budget == 0 || solved || has_paths(scene) || asks_for_places(one_case)) return std::nullopt;
  return confirmed_truth(scene, moments_in(scene.duration, dt),
                         {.dt = dt, .tolerance = converged_share, .budget = budget});
}

ConvergedChecks::ConvergedChecks(const Scene& scene, const ConvergedTruth& truth, double dt)
    : scene_(scene),
      answer_(*truth.answer),
      truth_(truth.engine, scene),
      scales_(scene, &truth_),
      growth_(scene, dt, answer_.valid_until() + dt),
      touches_(first_touches(scene, dt)) {
  const auto valid = std::upper_bound(answer_.times().begin(), answer_.times().end(), answer_.valid_until());
  const std::size_t known = growth_.moments() > 0 ? growth_.moments() - 1 : 0;  // a step more is needed, see tolerance
  const auto last = std::min(static_cast<std::size_t>(valid - answer_.times().begin()), known);
  if (last < 2) return;
  for (std::size_t k = most_moments; k > 0; --k) {
    const std::size_t index = (last - 1) * k / most_moments;
    if (index == 0 || (!moments_.empty() && moments_.back().index == index)) continue;
    const double time = answer_.times()[index];
    const Truth until(truth.engine, scene, time);
    moments_.push_back({.index = index,
                        .moved = Scales(scene, &until),
                        .energy_error = energy_error_of(scene, answer_.states(index), answer_.errors(index))});
  }
  const Conserved conserved(scene);
  for (std::size_t i = 0; i < last; ++i) energies_.push_back(conserved.energy(answer_.states(i)).total());
}

std::vector<ConvergedChecks::Question> ConvergedChecks::questions() const {
  std::vector<std::size_t> moving;
  for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
    if (scene_.bodies[i].type == BodyType::dynamic) moving.push_back(i);
  }
  std::vector<Question> all;
  if (moving.empty()) return all;
  const std::size_t count = std::min(judged_bodies, moving.size());
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t body = moving[count == 1 ? 0 : k * (moving.size() - 1) / (count - 1)];
    for (const Quantity quantity : {Quantity::x, Quantity::y, Quantity::angle}) {
      all.push_back({{.body = scene_.bodies[body].name, .quantity = quantity}, body});
    }
  }
  all.push_back({{.quantity = Quantity::energy}, moving.front()});
  return all;
}

double ConvergedChecks::tolerance(const Question& question, const Moment& moment, const Stepping& stepping) const {
  // An engine with a skin may touch a step before ours, by which growth is measured.
  const auto shift = growth_.allowance(stepping, moment.index + 1, question.body);
  if (!shift) return never;
  const StateError& error = answer_.errors(moment.index)[question.body];
  switch (question.expectation.quantity) {
    case Quantity::angle:
      return shift->angle + error.angle;
    case Quantity::energy:
      return shift->energy + moment.energy_error + energy_lag(moment.index, lag(stepping));
    default:
      return shift->place + error.position;
  }
}

double ConvergedChecks::energy_lag(std::size_t index, double late) const {
  const std::vector<double>& times = answer_.times();
  double most = 0;
  for (std::size_t i = index; late > 0; --i) {
    most = std::max(most, std::abs(energies_[i] - energies_[index]));
    if (i == 0 || times[index] - times[i] > late) break;
  }
  return most;
}

bool ConvergedChecks::precedes_touch(const std::string& body, double time) const {
  const double touch =
      body.empty() ? *std::min_element(touches_.begin(), touches_.end()) : touches_[index_of(scene_, body)];
  return std::isfinite(touch) && time < touch;
}

bool ConvergedChecks::knows_contact() const {
  const double touch = *std::min_element(touches_.begin(), touches_.end());
  return !moments_.empty() && (!std::isfinite(touch) || touch <= answer_.times()[moments_.front().index]);
}

std::string ConvergedChecks::source(const Question& question, const Moment& moment, const Stepping& stepping) const {
  return fmt::format(
      "converged reference, good to {:.1g} m; tolerance: the method's own error by then, {:.2g} m, as "
      "this motion amplifies it",
      answer_.errors(moment.index)[question.body].position, growth_.own_error(stepping, moment.index).place);
}

std::vector<TruthCheck> ConvergedChecks::of(const Stepping& stepping, const Trace& trace) const {
  constexpr double of_what_moved = 0.5;
  std::vector<Expectation> asked;
  for (const Question& question : questions()) {
    double before = never;  // s
    for (const Moment& moment : moments_) {
      const double time = answer_.times()[moment.index];
      if (time > before || time > trace.times().back() * (1 + 1e-9)) continue;
      Expectation expectation = question.expectation;
      expectation.time = time;
      const double allowed = tolerance(question, moment, stepping);
      const double expected = expected_value(scene_, expectation, &truth_, time).value();
      if (!(allowed < evidence_share * scales_.of(expectation, expected)) ||
          !(allowed < of_what_moved * moment.moved.of(expectation, expected))) {
        continue;
      }
      expectation.allowed = [allowed](const Stepping&) { return allowed; };
      expectation.source = source(question, moment, stepping);
      asked.push_back(std::move(expectation));
      if (std::isfinite(before)) break;
      before = time / 2;
    }
  }
  std::vector<TruthCheck> checks = check_expectations(scene_, asked, trace, stepping, &truth_);
  std::erase_if(checks, [](const TruthCheck& one) { return !is_evidence(one); });
  for (TruthCheck& one : checks) one.converged = true;
  return checks;
}

}  // namespace plumb
