#include "reports/study/stability/map.h"

#include <algorithm>
#include <cmath>

namespace plumb {

std::vector<double> Axis::values(int n) const {
  std::vector<double> all;
  for (int i = 0; i < n; ++i) {
    const double share = n > 1 ? static_cast<double>(i) / (n - 1) : 0;
    // Ends are what they are said to be, without rounding.
    const double value = share == 0    ? from
                         : share == 1  ? to
                         : logarithmic ? from * std::pow(to / from, share)
                                       : from + (to - from) * share;
    const double taken = whole ? std::round(value) : value;
    if (all.empty() || all.back() != taken) all.push_back(taken);
  }
  return all;
}

double Axis::between(double a, double b) const {
  const double middle = logarithmic ? std::sqrt(a * b) : (a + b) / 2;
  if (!whole) return middle;
  const double taken = std::round(middle);
  return taken == b ? a : taken;
}

bool Boundary::fails(Fate fate) const {
  if (failing.empty()) return is_failure(fate);
  return std::find(failing.begin(), failing.end(), fate) != failing.end();
}

double stated_gap(const EngineConfig& config, double dt) { return config.engine->stepping(config.settings, dt).gap; }

}  // namespace plumb
