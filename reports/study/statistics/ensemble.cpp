#include "reports/study/statistics/ensemble.h"

#include <stdexcept>

namespace plumb {
namespace {

struct NotRun {
  Status status;
  std::string reason;
};

}  // namespace

void EnsembleRun::take(const Outcome& outcome) {
  stepping_ += outcome.stepping;
  if (outcome.status != Status::ok) throw NotRun{outcome.status, outcome.reason};
}

void EnsembleRun::watch(const Scene& scene, const Observer& observer) {
  take(plumb::watch(scene, config_, dt_, 1, observer));
}

std::shared_ptr<const Trace> EnsembleRun::record(const Scene& scene) {
  const Outcome outcome = run(scene, config_, dt_);
  take(outcome);
  if (!outcome.trace->has_contacts()) throw NotRun{Status::not_supported, "reports no contacts"};
  return outcome.trace;
}

RunResult run_ensemble(const Ensemble& ensemble, const EngineConfig& config, std::uint64_t seed) {
  EnsembleRun one(config, ensemble.dt);
  RunResult result;
  try {
    result.draws = ensemble.draws(one, seed);
  } catch (const NotRun& not_run) {
    result.status = not_run.status;
    result.reason = not_run.reason;
  } catch (const std::domain_error& error) {
    result.status = Status::failed;
    result.reason = error.what();
  }
  for (const EnsembleDraw& draw : result.draws) {
    if (draw.size() != ensemble.statistics.size())
      throw std::logic_error("ensemble " + ensemble.name + ": a draw is not as long as its statistics");
  }
  result.stepping = one.stepping();
  return result;
}

}  // namespace plumb
