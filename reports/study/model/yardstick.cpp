#include "reports/study/model/yardstick.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "reference/scene_facts.h"
#include "reports/judge/states.h"
#include "reports/run/case_run.h"
#include "reports/run/horizon.h"

namespace plumb {

Yardstick::Yardstick(Case asked, EngineConfig full, double dt, double tolerance)
    : asked_(std::move(asked)),
      full_(std::move(full)),
      dt_(dt),
      tolerance_(tolerance),
      answer_(asked_, dt),
      arm_(smallest_body(*asked_.scene) / (2 * std::sqrt(2.0))),  // a disc's, by its diameter
      phases_(plumb::phases(asked_, asked_.scenario->phased ? judged_phases : 1)) {}

void Yardstick::find() {
  if (std::exchange(found_, true)) return;
  answer_.find();
  for (const Case& phase : phases_) {
    if (const Engine* witness = answer_.witness()) {
      truths_.push_back(run(*phase.scene, {witness, complete(*witness, {})}, dt_, phase.first_step).trace);
    }
    fulls_.push_back(run(*phase.scene, full_, dt_, phase.first_step).trace);
  }
  const double end = asked_.scene->duration;
  const bool told = answer_.witness() != nullptr && answer_.until() >= end * (1 - 1e-9);
  if (!told || answer_.error() > tolerance_)
    compared_until_ = std::min(end, horizon_of(*asked_.scene, dt_).value_or(end));
  full_error_ = read(full_).error;
}

std::string Yardstick::truth() const { return answer_.witness() == nullptr ? "" : answer_.witness()->name; }

double Yardstick::truth_until() const {
  return answer_.witness() == nullptr ? 0 : std::min(answer_.until(), asked_.scene->duration);
}

Yardstick::Reading Yardstick::read(const EngineConfig& model) const {
  Reading reading;
  double squares = 0;
  double apart = 0;
  for (std::size_t i = 0; i < phases_.size(); ++i) {
    const Outcome outcome = run(*phases_[i].scene, model, dt_, phases_[i].first_step);
    reading.status = outcome.status;
    reading.reason = outcome.reason;
    if (outcome.status != Status::ok || !fulls_[i]) {
      reading.error = reading.change = std::numeric_limits<double>::infinity();
      return reading;
    }
    const double error = truths_.empty() ? 0 : difference(*outcome.trace, *truths_[i], answer_.until());
    squares += error * error;
    if (compared_until_ > 0) apart = std::max(apart, difference(*outcome.trace, *fulls_[i], compared_until_));
  }
  reading.error = truths_.empty() ? std::numeric_limits<double>::quiet_NaN()
                                  : std::sqrt(squares / static_cast<double>(phases_.size()));
  reading.change = std::max(apart, truths_.empty() ? 0.0 : reading.error - full_error_);
  return reading;
}

bool Yardstick::within(const Reading& reading) const {
  return reading.status == Status::ok && reading.change <= tolerance_;
}

// RMS over time and bodies of how far points are moved that lie as far out as the mass does, on the average.
double Yardstick::difference(const Trace& a, const Trace& b, double until) const {
  const auto all = pose_differences(*asked_.scene, a, b, until);
  double squares = 0;
  for (const PoseDifference& one : all) {
    squares += one.position * one.position + arm_ * arm_ * one.angle * one.angle;
  }
  return all.empty() ? 0 : std::sqrt(squares / static_cast<double>(all.size()));
}

}  // namespace plumb
