#include "reports/timing/repetitions.h"

#include <algorithm>
#include <stdexcept>

namespace plumb {

void play_round(std::size_t round, std::size_t contestants, const std::function<void(std::size_t)>& repeat) {
  for (std::size_t i = 0; i < contestants; ++i) repeat((round + i) % contestants);
}

void repeat_until_settled(std::size_t contestants, const std::function<bool(std::size_t)>& repeat) {
  bool any = true;
  for (std::size_t round = 0; any; ++round) {
    any = false;
    play_round(round, contestants, [&](std::size_t contestant) { any = repeat(contestant) || any; });
  }
}

void Repetitions::add(double seconds, double spent) {
  if (seconds_.empty()) first_ = spent;
  seconds_.push_back(seconds);
  spent_ += spent;
}

bool Repetitions::settled() const {
  const std::size_t count = counted().size();
  if (first_ >= rule_.long_enough) return true;
  if (count < std::min(rule_.fewest, rule_.fewest_if_slow)) return false;
  if (count < rule_.fewest && spent_ < rule_.slow) return false;
  return count >= rule_.most || spent_ >= rule_.budget || !wide();
}

std::span<const double> Repetitions::counted() const {
  const bool warm_up = !seconds_.empty() && first_ <= rule_.slow;
  return std::span(seconds_).subspan(warm_up ? 1 : 0);
}

Quartiles Repetitions::spread() const {
  const std::span<const double> all = counted();
  return quartiles({all.begin(), all.end()});
}

bool Repetitions::wide() const {
  const Quartiles all = spread();
  return all.high - all.low > rule_.wide * all.median;
}

std::vector<double> ratios(std::span<const double> over, std::span<const double> under) {
  if (over.size() != under.size()) throw std::invalid_argument("ratios of unequal numbers of repetitions");
  std::vector<double> all(over.size());
  std::transform(over.begin(), over.end(), under.begin(), all.begin(), [](double a, double b) { return a / b; });
  return all;
}

Quartiles time_ratio(const std::function<double()>& a, const std::function<double()>& b, std::size_t fewest,
                     std::size_t most, const std::function<bool(const Quartiles&)>& decided) {
  std::vector<double> all;
  while (all.size() < fewest || (all.size() < most && !decided(quartiles(all)))) {
    const bool b_first = all.size() % 2 != 0;
    const double first = b_first ? b() : a();
    const double second = b_first ? a() : b();
    all.push_back(b_first ? second / first : first / second);
  }
  return quartiles(all);
}

}  // namespace plumb
