#include "reports/run/phases.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "reports/statistics.h"

namespace plumb {
namespace {

const double golden = (std::sqrt(5.0) - 1) / 2;

// The share of what is allowed; an error that is no number is the worst of all.
double share(const TruthCheck& check) {
  if (!check.reported) return -1;
  if (check.passed && check.error == 0) return 0;
  return std::isfinite(check.error / check.tolerance) ? check.error / check.tolerance
                                                      : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<Case> phases(const Case& asked, int n) {
  std::vector<Case> all(static_cast<std::size_t>(std::max(n, 1)), asked);
  for (std::size_t k = 1; k < all.size(); ++k) {
    const double turns = static_cast<double>(k) * golden;
    all[k].first_step = turns - std::floor(turns);
  }
  return all;
}

Judgement judge_case(const Case& asked, const EngineConfig& config, double dt, const Trace& trace, const Truth* truth) {
  const auto expectations = asked.scenario->expectations(asked.parameters);
  const Stepping stepping = config.engine->stepping(config.settings, dt);
  Judgement judgement = judge(*asked.scene, expectations, trace, stepping, truth);
  if (!asked.scenario->phased) return judgement;
  std::vector<std::vector<double>> errors;
  for (const TruthCheck& check : judgement.checks) errors.push_back({check.error});
  for (const Case& phase : phases(asked, judged_phases)) {
    if (phase.first_step == asked.first_step) continue;
    const Outcome outcome = run(*phase.scene, config, dt, phase.first_step);
    if (outcome.status != Status::ok) {
      judgement.verdict = Verdict::wrong;
      continue;
    }
    const Judgement other = judge(*phase.scene, expectations, *outcome.trace, stepping, truth);
    for (std::size_t i = 0; i < errors.size(); ++i) {
      errors[i].push_back(other.checks[i].error);
      if (share(other.checks[i]) > share(judgement.checks[i])) judgement.checks[i] = other.checks[i];
    }
    // Which invariants apply hangs on the scene, and every phase has the same.
    for (std::size_t i = 0; i < judgement.invariants.size(); ++i) {
      if (other.invariants[i].ratio > judgement.invariants[i].ratio) judgement.invariants[i] = other.invariants[i];
    }
    if (other.verdict == Verdict::wrong) judgement.verdict = Verdict::wrong;
  }
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const std::vector<double>& of = errors[i];
    judgement.checks[i].spread = {*std::min_element(of.begin(), of.end()), quartiles(of).median,
                                  *std::max_element(of.begin(), of.end()), static_cast<int>(of.size())};
  }
  return judgement;
}

}  // namespace plumb
