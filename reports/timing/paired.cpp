#include "reports/timing/paired.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "reports/statistics.h"
#include "reports/timing/repetitions.h"

namespace plumb {
namespace {

// The geometric mean over the pairs that have values of this cost, round by round.
std::vector<double> geometric_means(std::span<const TimedPair> pairs, StepCosts TimedPair::*side,
                                    std::vector<double> StepCosts::*cost) {
  std::vector<double> logarithms;
  double cases = 0;
  for (const TimedPair& pair : pairs) {
    const std::vector<double>& values = pair.*side.*cost;
    if (values.empty()) continue;
    logarithms.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) logarithms[i] += std::log(values[i]);
    ++cases;
  }
  for (double& one : logarithms) one = std::exp(one / cases);
  return logarithms;
}

bool timed(const TimedPair& pair) { return pair.no_result.empty(); }

JudgedTime compared(TimedPair pair) {
  JudgedTime one{.pair = std::move(pair)};
  if (!timed(one.pair)) {
    one.change = TimeChange::no_result;
    return one;
  }
  one.time = shift_of(one.pair, &StepCosts::cpu);
  const auto counted = [](const StepCosts& cost) { return cost.instructions.size() == cost.cpu.size(); };
  if (counted(one.pair.before) && counted(one.pair.now) && counted(one.pair.again))
    one.instructions = shift_of(one.pair, &StepCosts::instructions);
  return one;
}

// Those cases, and last all together, which has no result unless there are several.
std::vector<JudgedTime> measure_and_compare(const TimeCases& time, std::span<const std::size_t> which, int rounds) {
  std::vector<TimedPair> pairs = time(which, rounds);
  TimedPair together = overall(pairs);
  together.name = "all cases";
  if (std::count_if(pairs.begin(), pairs.end(), timed) < 2) together.no_result = "not several cases";
  std::vector<JudgedTime> all;
  all.reserve(pairs.size() + 1);
  for (TimedPair& pair : pairs) all.push_back(compared(std::move(pair)));
  all.push_back(compared(std::move(together)));
  return all;
}

// Slower by time, or by instructions unless the time is shorter.
std::vector<bool> significantly_slower(const std::vector<JudgedTime>& all, double level, const TimingRule& rule) {
  std::vector<Shift> times;
  std::vector<Shift> counts;
  for (const JudgedTime& one : all) {
    times.push_back(one.time);
    counts.push_back(one.instructions && one.time.ratio >= 1 ? *one.instructions : Shift{});
  }
  std::vector<bool> out = slower(times, level, rule.least);
  const std::vector<bool> more = slower(counts, level, rule.least_instructions);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = out[i] || more[i];
  return out;
}

std::vector<std::size_t> marked_indices(const std::vector<bool>& marked) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < marked.size(); ++i) {
    if (marked[i]) all.push_back(i);
  }
  return all;
}

void mark_faster(std::vector<JudgedTime>& all, const TimingRule& rule) {
  std::vector<Shift> backwards;
  backwards.reserve(all.size());
  for (const JudgedTime& one : all) backwards.push_back({1 / one.time.ratio, one.time.p, -one.time.effect});
  const std::vector<bool> out = slower(backwards, rule.confirmed, rule.least);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (out[i]) all[i].change = TimeChange::faster;
  }
}

}  // namespace

Shift shift_of(const TimedPair& pair, std::vector<double> StepCosts::*cost) {
  const std::vector<double> chance = ratios(pair.again.*cost, pair.before.*cost);
  const std::vector<double> found = ratios(pair.now.*cost, pair.before.*cost);
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
  std::vector<bool> marked = significant(p, level);
  for (std::size_t i = 0; i < shifts.size(); ++i) marked[i] = marked[i] && shifts[i].ratio >= 1 + least;
  return marked;
}

TimedPair overall(std::span<const TimedPair> pairs) {
  TimedPair all;
  for (StepCosts TimedPair::*const side : {&TimedPair::before, &TimedPair::now, &TimedPair::again}) {
    for (std::vector<double> StepCosts::*const cost : {&StepCosts::cpu, &StepCosts::wall, &StepCosts::instructions}) {
      all.*side.*cost = geometric_means(pairs, side, cost);
    }
  }
  return all;
}

std::vector<JudgedTime> judge_times(const TimeCases& time, std::size_t cases, const TimingRule& rule) {
  std::vector<std::size_t> which(cases);
  std::iota(which.begin(), which.end(), 0U);
  std::vector<JudgedTime> all = measure_and_compare(time, which, rule.rounds);
  mark_faster(all, rule);

  std::vector<std::size_t> suspects = marked_indices(significantly_slower(all, rule.suspicious, rule));
  if (!suspects.empty()) {
    const bool together = suspects.back() == cases;
    if (!together) which = suspects;
    const std::vector<JudgedTime> measured = measure_and_compare(time, which, rule.rounds_again);
    std::vector<JudgedTime> anew;
    for (const std::size_t suspect : suspects) {
      const auto index = std::lower_bound(which.begin(), which.end(), suspect) - which.begin();
      anew.push_back(measured[static_cast<std::size_t>(index)]);
      anew.back().measured_again = true;
    }
    for (const std::size_t i : marked_indices(significantly_slower(anew, rule.confirmed, rule)))
      anew[i].change = TimeChange::slower;
    for (std::size_t i = 0; i < suspects.size(); ++i) all[suspects[i]] = std::move(anew[i]);
  }
  if (!timed(all.back().pair)) all.pop_back();
  return all;
}

}  // namespace plumb
