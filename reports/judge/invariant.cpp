#include "reports/judge/invariant.h"

#include <cmath>

#include "scenarios/catalog.h"

namespace plumb {
namespace {

// Whether bodies may touch at some moment of the run.
bool touches(const InvariantContext& context) {
  if (context.trace.has_contacts()) return true;
  for (std::size_t moment = 1; moment < context.trace.size(); ++moment) {
    if (!context.neighbours.in_step(moment).empty()) return true;
  }
  return false;
}

}  // namespace

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

std::optional<InvariantCheck> without_contacts(const InvariantContext& context, bool whole) {
  if (context.trace.has_contacts() && (context.stepping.whole_impulses || !whole)) return std::nullopt;
  return touches(context) ? not_reported() : InvariantCheck{.status = CheckStatus::not_applicable};
}

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
