#include "reports/judge/roundings.h"

#include <algorithm>

namespace plumb {

double roundings(const Trace& trace, const Stepping& stepping) {
  if (trace.size() == 0) return 0;
  const auto steps = static_cast<double>(trace.size() - 1);
  return ((stepping.h > 0 ? std::max(steps, trace.times().back() / stepping.h) : steps) + 2) * stepping.epsilon;
}

double roundings_of_solver(const Stepping& stepping) {
  constexpr double sweeps = 64;
  return sweeps * stepping.epsilon;
}

}  // namespace plumb
