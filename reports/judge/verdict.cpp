#include "reports/judge/verdict.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <string_view>

#include "reports/judge/invariant.h"
#include "reports/judge/mechanics.h"
#include "reports/judge/overlap.h"
#include "reports/judge/rounding.h"
#include "reports/judge/scale.h"
#include "reports/statistics.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

// By how much a value misses its relation to the expected one; 0 if it satisfies it.
double missed_by(Relation relation, double measured, double expected) {
  switch (relation) {
    case Relation::equal:
      return std::abs(measured - expected);
    case Relation::at_least:
      return measured >= expected ? 0 : expected - measured;
    case Relation::at_most:
      return measured <= expected ? 0 : measured - expected;
  }
  return missing;
}

TruthCheck check(const Scene& scene, const Expectation& expectation, const Trace& trace, const Stepping& stepping,
                 const Truth* truth, const Scales& scales) {
  const auto observed = observe(scene, trace, expectation, scene.duration);
  const double time = observed ? observed->time : expectation.time.value_or(scene.duration);
  const std::size_t body = expectation.body.empty() ? 0 : index_of(scene, expectation.body);
  const double tolerance = expectation.within
                               ? *expectation.within
                               : (expectation.allowed ? expectation.allowed(stepping) : 0) +
                                     quantity_rounding(expectation.quantity, body, scene, trace, stepping);
  TruthCheck check{.body = expectation.body,
                   .quantity = name_of(expectation.quantity),
                   .unit = unit_of(expectation.quantity),
                   .time = time,
                   .relation = expectation.relation,
                   .expected = expected_value(scene, expectation, truth, time).value_or(missing),
                   .measured = observed ? observed->value : missing,
                   .tolerance = tolerance,
                   .chance = expectation.chance,
                   .reported = is_reported(trace, expectation.quantity),
                   .source = expectation.source};
  if (!check.reported) check.measured = missing;
  check.scale = scales.of(expectation, check.expected);
  check.error = missed_by(check.relation, check.measured, check.expected);
  // An infinite tolerance or bound would pass anything.
  const double numbers[] = {check.tolerance, check.measured, check.expected};
  check.passed = std::all_of(std::begin(numbers), std::end(numbers), [](double one) { return std::isfinite(one); }) &&
                 check.error <= check.tolerance;
  return check;
}

// A run of the scene in which nothing moves, although velocities are those of the start.
Trace motionless(const Scene& scene) {
  const std::vector<BodyState> start = initial_states(scene);
  Trace trace(start.size());
  trace.record(0, start, {});
  trace.record(scene.duration, start, {});
  return trace;
}

// Orders the phases of a check by how badly they miss it; phases that report nothing come last.
double badness(const TruthCheck& check) { return check.reported ? error_ratio(check.error, check.tolerance) : -1; }

// What a check asks about. Both coordinates of a point, for example, are one question.
const char* subject_of(const TruthCheck& check) {
  static const std::map<std::string, const char*> subjects{{name_of(Quantity::x), "place"},
                                                           {name_of(Quantity::y), "place"},
                                                           {name_of(Quantity::apex), "place"},
                                                           {name_of(Quantity::vx), "velocity"},
                                                           {name_of(Quantity::vy), "velocity"},
                                                           {name_of(Quantity::speed), "velocity"},
                                                           {name_of(Quantity::energy), "energy"},
                                                           {name_of(Quantity::energy_rise), "energy"},
                                                           {name_of(Quantity::momentum_x), "momentum"},
                                                           {name_of(Quantity::momentum_y), "momentum"}};
  const auto found = subjects.find(check.quantity);
  return found == subjects.end() ? check.quantity.c_str() : found->second;
}

// Whether each check of a value is evidence, or one of the same quantity at that time or later is, and one is about the
// motion. What is known of a quantity before the time of a question says nothing about what happens until then. A bound
// on one side can be missed, but many motions keep it.
bool has_power(std::span<const TruthCheck> truth) {
  std::map<std::string_view, double> evident_until;  // s, by subject
  bool moving = false;
  for (const TruthCheck& check : truth) {
    if (!is_evidence(check) || check.relation != Relation::equal) continue;
    double& until = evident_until.try_emplace(subject_of(check), check.time).first->second;
    until = std::max(until, check.time);
    moving = moving || !check.idle;
  }
  return moving && std::all_of(truth.begin(), truth.end(), [&](const TruthCheck& check) {
           if (check.relation != Relation::equal) return true;
           const auto evident = evident_until.find(subject_of(check));
           return evident != evident_until.end() && evident->second >= check.time;
         });
}

// Of two phases of a run.
Verdict worse(Verdict a, Verdict b) {
  for (const Verdict one : {Verdict::wrong, Verdict::coarse, Verdict::no_evidence, Verdict::plausible}) {
    if (a == one || b == one) return one;
  }
  return Verdict::right;
}

}  // namespace

Verdict verdict_of(std::span<const TruthCheck> truth, std::span<const InvariantCheck> invariants) {
  const auto broken = [](const InvariantCheck& one) { return one.status == CheckStatus::broken; };
  const auto failed = [](const TruthCheck& one) { return one.reported && !one.passed; };
  if (std::any_of(invariants.begin(), invariants.end(), broken)) return Verdict::wrong;
  if (std::any_of(truth.begin(), truth.end(), failed)) return Verdict::wrong;
  if (std::all_of(truth.begin(), truth.end(), [](const TruthCheck& one) { return one.idle; })) {
    const auto tested = [](const InvariantCheck& one) { return is_evidence(one); };
    return std::any_of(invariants.begin(), invariants.end(), tested) ? Verdict::plausible : Verdict::no_evidence;
  }
  const auto far = [](const TruthCheck& one) { return one.reported && relative_error(one) > right_share; };
  if (std::any_of(truth.begin(), truth.end(), far)) return Verdict::coarse;
  return has_power(truth) ? Verdict::right : Verdict::no_evidence;
}

std::vector<TruthCheck> check_expectations(const Scene& scene, std::span<const Expectation> expectations,
                                           const Trace& trace, const Stepping& stepping, const Truth* truth) {
  std::vector<TruthCheck> checks;
  const Scales scales(scene, truth);
  const bool moving = scales.moves() || Scales(scene, trace).moves();
  const Trace still = motionless(scene);
  for (const Expectation& expectation : expectations) {
    checks.push_back(check(scene, expectation, trace, stepping, truth, scales));
    const bool prescribed =
        !expectation.body.empty() && scene.bodies[index_of(scene, expectation.body)].type != BodyType::dynamic;
    checks.back().idle = prescribed || (moving && check(scene, expectation, still, stepping, truth, scales).passed);
  }
  return checks;
}

Judgement judge(const Scene& scene, std::span<const Expectation> expectations, const Trace& trace,
                const Stepping& stepping, const Truth* truth) {
  Judgement judgement{.checks = check_expectations(scene, expectations, trace, stepping, truth)};
  judgement.invariants = check_invariants({scene, trace, stepping});
  judgement.verdict = verdict_of(judgement.checks, judgement.invariants);
  return judgement;
}

Judgement judge_phases(const Scene& scene, std::span<const Expectation> expectations, const Trace& trace,
                       std::span<const Trace* const> shifted, const Stepping& stepping, const Truth* truth) {
  Judgement judgement = judge(scene, expectations, trace, stepping, truth);
  std::vector<std::vector<double>> errors;
  for (const TruthCheck& one : judgement.checks) errors.push_back({one.error});
  for (const Trace* phase : shifted) {
    if (phase == nullptr) {
      judgement.verdict = Verdict::wrong;
      continue;
    }
    const Judgement other = judge(scene, expectations, *phase, stepping, truth);
    for (std::size_t i = 0; i < errors.size(); ++i) {
      errors[i].push_back(other.checks[i].error);
      if (badness(other.checks[i]) > badness(judgement.checks[i])) judgement.checks[i] = other.checks[i];
    }
    // The scene decides which invariants apply, so every phase has the same.
    for (std::size_t i = 0; i < judgement.invariants.size(); ++i) {
      if (other.invariants[i].ratio > judgement.invariants[i].ratio) judgement.invariants[i] = other.invariants[i];
    }
    judgement.verdict = worse(judgement.verdict, other.verdict);
  }
  for (InvariantCheck& one : judgement.invariants) one.phases = 1 + static_cast<int>(shifted.size());
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const std::vector<double>& of = errors[i];
    judgement.checks[i].spread = {*std::min_element(of.begin(), of.end()), quartiles(of).median,
                                  *std::max_element(of.begin(), of.end()), static_cast<int>(of.size())};
  }
  return judgement;
}

}  // namespace plumb
