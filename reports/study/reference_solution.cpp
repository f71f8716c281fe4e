#include "reports/study/reference_solution.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "reference/scene_facts.h"
#include "reports/judge/metric.h"
#include "scenarios/allowance.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

// m, the RMS distance of dynamic bodies from where they start, over the moments up to `until`.
double displacement(const Scene& scene, const Trace& trace, double until) {
  double squares = 0;
  double count = 0;
  for (std::size_t moment = 0; moment < trace.size() && trace.time(moment) <= until; ++moment) {
    for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
      if (scene.bodies[body].type != BodyType::dynamic) continue;
      const double moved = length(trace.states(moment)[body].position - trace.states(0)[body].position);
      squares += moved * moved;
      ++count;
    }
  }
  return count > 0 ? std::sqrt(squares / count) : 0;
}

}  // namespace

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
  scale_ = std::max(displacement(scene, *outcome.trace, until_), smallest_body(scene));
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
