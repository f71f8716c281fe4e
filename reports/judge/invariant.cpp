#include "reports/judge/invariant.h"

#include <cmath>
#include <limits>

#include "scenarios/catalog.h"

namespace plumb {

double Worst::times_allowed(double value, double allowed) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!std::isfinite(value) || !std::isfinite(allowed)) return infinity;
  if (value <= 0) return 0;
  return allowed > 0 ? value / allowed : infinity;
}

InvariantCheck Worst::result() const {
  InvariantCheck check = check_;
  check.status = check.ratio <= 1 ? CheckStatus::held : CheckStatus::broken;
  return check;
}

InvariantCheck not_reported() { return {.status = CheckStatus::not_reported}; }

bool reports_contacts(const Trace& trace) {
  for (std::size_t i = 0; i < trace.size(); ++i) {
    if (!trace.contacts(i).empty()) return true;
  }
  return false;
}

std::string pair_name(const Scene& scene, std::size_t a, std::size_t b) {
  return scene.bodies[a].name + " - " + scene.bodies[b].name;
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
