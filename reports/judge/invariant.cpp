#include "reports/judge/invariant.h"

#include <cmath>

#include "scenarios/catalog.h"

namespace plumb {

void WorstViolation::test(double tolerance, double scale) {
  const double power = error_ratio(scale, tolerance);
  if (!(power > power_)) return;
  power_ = power;
  scale_ = scale;
}

InvariantCheck WorstViolation::result() const {
  InvariantCheck check = check_;
  check.scale = check.tolerance > 0 && std::isfinite(power_) ? power_ * check.tolerance : scale_;
  check.status = check.ratio <= 1 ? CheckStatus::held : CheckStatus::broken;
  return check;
}

InvariantCheck not_reported() { return {.status = CheckStatus::not_reported}; }

std::vector<InvariantCheck> check_invariants(const InvariantContext& context) {
  std::vector<InvariantCheck> checks;
  if (context.trace.size() < 2) return checks;
  for (const Invariant* invariant : Catalog<Invariant>::all()) {
    auto check = invariant->check(context);
    if (!check) continue;
    check->name = invariant->name;
    check->unit = invariant->unit;
    checks.push_back(std::move(*check));
  }
  return checks;
}

}  // namespace plumb
