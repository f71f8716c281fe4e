#include "reports/run/case_truth.h"

#include <limits>

namespace plumb {

CaseTruth::CaseTruth(const Case& one_case, double dt, std::size_t budget)
    : scene_(one_case.scene), engine_(one_case.closed_form), converged_(converged_reference(one_case, dt, budget)) {
  if (converged_) engine_ = &converged_->engine;
  if (engine_ == nullptr) return;
  outcome_ = run(*scene_, {engine_, complete(*engine_, {})}, dt);
  if (outcome_.status != Status::ok) return;
  truth_.emplace(*engine_, *scene_);
  if (converged_) checks_.emplace(*scene_, *converged_, dt);
}

ReferenceRun CaseTruth::reference() const {
  if (!truth_) return {};
  return {.truth = &*truth_, .trace = outcome_.trace, .converged = checks_ ? &*checks_ : nullptr};
}

double CaseTruth::valid_until() const {
  return checks_ ? converged_->answer->valid_until() : std::numeric_limits<double>::infinity();
}

const CaseTruth& CaseTruths::of(const Case& one_case) {
  Lazy* lazy = nullptr;
  {
    const std::lock_guard alone(looking_);
    lazy = &truths_[one_case.scene];
  }
  std::call_once(lazy->found, [&] { lazy->truth = std::make_unique<const CaseTruth>(one_case, dt_, budget_); });
  return *lazy->truth;
}

}  // namespace plumb
