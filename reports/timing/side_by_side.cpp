#include "reports/timing/side_by_side.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace plumb {
namespace {

bool timed(const TimedPair& pair) { return pair.no_result.empty(); }

JudgedTime measured(TimedPair pair) {
  JudgedTime one{.pair = std::move(pair)};
  if (!timed(one.pair)) {
    one.pace = Pace::no_result;
    return one;
  }
  one.time = shift_of(one.pair, &Cost::cpu);
  const auto counted = [](const Cost& cost) { return cost.instructions.size() == cost.cpu.size(); };
  if (counted(one.pair.before) && counted(one.pair.now) && counted(one.pair.again))
    one.instructions = shift_of(one.pair, &Cost::instructions);
  return one;
}

// Those cases, and last all together; which say nothing that a single one does not.
std::vector<JudgedTime> look(const TimeCases& time, std::span<const std::size_t> which, int sittings) {
  std::vector<TimedPair> pairs = time(which, sittings);
  TimedPair together = overall(pairs);
  together.name = "all cases";
  if (std::count_if(pairs.begin(), pairs.end(), timed) < 2) together.no_result = "not several cases";
  std::vector<JudgedTime> all;
  all.reserve(pairs.size() + 1);
  for (TimedPair& pair : pairs) all.push_back(measured(std::move(pair)));
  all.push_back(measured(std::move(together)));
  return all;
}

// Slower by time, or by instructions where the time does not say the contrary.
std::vector<bool> standing_out(const std::vector<JudgedTime>& all, double level, const TimingRule& rule) {
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

std::vector<std::size_t> places(const std::vector<bool>& marked) {
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
    if (out[i]) all[i].pace = Pace::faster;
  }
}

}  // namespace

std::vector<JudgedTime> judge_times(const TimeCases& time, std::size_t cases, const TimingRule& rule) {
  std::vector<std::size_t> which(cases);
  std::iota(which.begin(), which.end(), 0U);
  std::vector<JudgedTime> all = look(time, which, rule.sittings);
  mark_faster(all, rule);

  std::vector<std::size_t> suspects = places(standing_out(all, rule.suspicious, rule));
  if (!suspects.empty()) {
    const bool together = suspects.back() == cases;
    if (!together) which = suspects;
    const std::vector<JudgedTime> looked = look(time, which, rule.again);
    std::vector<JudgedTime> anew;
    for (const std::size_t suspect : suspects) {
      const auto place = std::lower_bound(which.begin(), which.end(), suspect) - which.begin();
      anew.push_back(looked[static_cast<std::size_t>(place)]);
      anew.back().measured_again = true;
    }
    for (const std::size_t i : places(standing_out(anew, rule.confirmed, rule))) anew[i].pace = Pace::slower;
    for (std::size_t i = 0; i < suspects.size(); ++i) all[suspects[i]] = std::move(anew[i]);
  }
  if (!timed(all.back().pair)) all.pop_back();
  return all;
}

}  // namespace plumb
