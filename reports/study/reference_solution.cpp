#include "reports/study/reference_solution.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "reports/judge/metric.h"
#include "reports/vec.h"
#include "scenarios/allowance.h"

namespace plumb {

void ReferenceSolution::find() {
  if (std::exchange(searched_, true)) return;
  const Scene& scene = *problem_.scene;
  engine_ = problem_.closed_form;
  if (engine_ == nullptr) {
    std::vector<double> moments(steps_in(scene.duration, finest_) + 1);
    for (std::size_t i = 0; i < moments.size(); ++i) moments[i] = static_cast<double>(i) * finest_;
    converged_ = converged_truth(scene, std::move(moments), {});
    reason_ = converged_->engine.unsupported(scene, {});
    if (!reason_.empty()) return;
    error_ = converged_->answer->largest_error();
    reason_ = converged_->answer->reason();
    engine_ = &converged_->engine;
  }
  const Outcome outcome = run(scene, {engine_, complete(*engine_, {})}, 1.0 / 60);
  if (outcome.status != Status::ok) {
    reason_ = outcome.reason;
    engine_ = nullptr;
    return;
  }
  until_ = engine_->build(scene, complete(*engine_, {}))->valid_until();
  for (std::size_t moment = 0; moment < outcome.trace->size(); ++moment) {
    for (const BodyState& state : outcome.trace->states(moment)) {
      extent_ = std::max(extent_, length(state.position) + length(state.velocity) * scene.duration);
    }
  }
}

double ReferenceSolution::error_of(const Trace& trace, double dt, double first_step) const {
  const Scene& scene = *problem_.scene;
  const Outcome truth = run(scene, {engine_, complete(*engine_, {})}, dt, first_step);
  const auto measured = measure({.scene = scene, .trace = trace, .truth = truth.trace.get(), .truth_until = until_});
  const auto found = measured.find("truth_error_rms");
  if (found == measured.end()) throw std::runtime_error("the error against the reference solution was not measured");
  return found->second.value;
}

double ReferenceSolution::round_off(const Stepping& stepping) const {
  return plumb::round_off(stepping, problem_.scene->duration, extent_);
}

}  // namespace plumb
