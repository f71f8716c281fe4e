#include "reports/study/answer.h"

#include <algorithm>
#include <stdexcept>

#include "reports/judge/metric.h"
#include "reports/vec.h"
#include "scenarios/allowance.h"

namespace plumb {

void Answer::find() {
  if (std::exchange(sought_, true)) return;
  const Scene& scene = *asked_.scene;
  witness_ = asked_.closed_form;
  if (witness_ == nullptr) {
    std::vector<double> moments(steps_in(scene.duration, finest_) + 1);
    for (std::size_t i = 0; i < moments.size(); ++i) moments[i] = static_cast<double>(i) * finest_;
    converged_ = converged_truth(scene, std::move(moments), {});
    reason_ = converged_->engine.unsupported(scene, {});
    if (!reason_.empty()) return;
    error_ = converged_->answer->largest_error();
    reason_ = converged_->answer->reason();
    witness_ = &converged_->engine;
  }
  const Outcome outcome = run(scene, {witness_, complete(*witness_, {})}, 1.0 / 60);
  if (outcome.status != Status::ok) {
    reason_ = outcome.reason;
    witness_ = nullptr;
    return;
  }
  until_ = witness_->build(scene, complete(*witness_, {}))->valid_until();
  for (std::size_t moment = 0; moment < outcome.trace->size(); ++moment) {
    for (const BodyState& state : outcome.trace->states(moment)) {
      reach_ = std::max(reach_, length(state.position) + length(state.velocity) * scene.duration);
    }
  }
}

const Engine* Answer::witness() const { return witness_; }

double Answer::error_of(const Trace& trace, double dt, double first_step) const {
  const Scene& scene = *asked_.scene;
  const Outcome truth = run(scene, {witness_, complete(*witness_, {})}, dt, first_step);
  const auto measured = measure({.scene = scene, .trace = trace, .truth = truth.trace.get(), .truth_until = until_});
  const auto found = measured.find("truth_error_rms");
  if (found == measured.end()) throw std::runtime_error("no distance from the truth could be measured");
  return found->second.value;
}

double Answer::round_off(const Stepping& stepping) const {
  return plumb::round_off(stepping, asked_.scene->duration, reach_);
}

}  // namespace plumb
