#include "reports/timing/judge_times.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "reports/statistics.h"

namespace plumb {
namespace {

// Of those that have values at all.
std::vector<double> geometric_means(std::span<const TimedPair> pairs, Cost TimedPair::*side,
                                    std::vector<double> Cost::*what) {
  std::vector<double> logarithms;
  double cases = 0;
  for (const TimedPair& pair : pairs) {
    const std::vector<double>& values = pair.*side.*what;
    if (values.empty()) continue;
    logarithms.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) logarithms[i] += std::log(values[i]);
    ++cases;
  }
  for (double& one : logarithms) one = std::exp(one / cases);
  return logarithms;
}

std::vector<double> ratios(const std::vector<double>& over, const std::vector<double>& under) {
  std::vector<double> all;
  for (std::size_t i = 0; i < std::min(over.size(), under.size()); ++i) all.push_back(over[i] / under[i]);
  return all;
}

}  // namespace

Shift shift_of(const TimedPair& pair, std::vector<double> Cost::*what) {
  const std::vector<double> chance = ratios(pair.again.*what, pair.before.*what);
  const std::vector<double> found = ratios(pair.now.*what, pair.before.*what);
  const RankTest ranks = rank_test(found, chance);
  std::vector<double> quotients;
  for (const double a : chance) {
    for (const double b : found) quotients.push_back(b / a);
  }
  return {quartiles(std::move(quotients)).median, ranks.p, ranks.effect};
}

std::vector<bool> slower(std::span<const Shift> shifts, double level, double least) {
  std::vector<double> p;
  p.reserve(shifts.size());
  for (const Shift& shift : shifts) p.push_back(shift.p);
  std::vector<bool> stands = significant(p, level);
  for (std::size_t i = 0; i < shifts.size(); ++i) stands[i] = stands[i] && shifts[i].ratio >= 1 + least;
  return stands;
}

TimedPair overall(std::span<const TimedPair> pairs) {
  TimedPair all;
  for (Cost TimedPair::*const side : {&TimedPair::before, &TimedPair::now, &TimedPair::again}) {
    for (std::vector<double> Cost::*const what : {&Cost::cpu, &Cost::wall, &Cost::instructions}) {
      all.*side.*what = geometric_means(pairs, side, what);
    }
  }
  return all;
}

}  // namespace plumb
