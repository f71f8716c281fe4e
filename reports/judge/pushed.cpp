#include "reports/judge/pushed.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/vec.h"

namespace plumb {

double changed(std::span<const ContactState> before, const ContactState& now) {
  double pushed = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (const ContactState& then : before) {
    if (then.a != now.a || then.b != now.b) continue;
    const double away = length(then.point - now.point);
    if (!(away < nearest)) continue;
    nearest = away;
    pushed = then.normal_impulse;
  }
  return std::abs(now.normal_impulse - pushed);
}

// A method of first order may take a push from a step before. One that sweeps n times over all contacts takes it from a
// sweep before: of an error that each sweep multiplies by r, sweep n + 1 takes (1 - r) r^n, which is largest for
// r = n/(n + 1), whatever the scene makes of r. The error that the sweeps begin with is what the step changes.
std::vector<double> known_late(std::span<const ContactState> before, std::span<const ContactState> now,
                               const Stepping& stepping) {
  std::vector<double> late;
  late.reserve(now.size());
  for (const ContactState& contact : now) late.push_back(stepping.drift == 0 ? 0 : changed(before, contact));
  if (stepping.iterations == 0 || late.empty()) return late;
  const double n = stepping.iterations;
  const double swept = std::pow(n / (n + 1), n) / (n + 1) * *std::max_element(late.begin(), late.end());
  for (double& one : late) one = std::max(one, swept);
  return late;
}

}  // namespace plumb
