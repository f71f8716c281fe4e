#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "reports/statistics.h"

/// Repeats timings of several contestants in rounds until they are precise enough. In each round every contestant is
/// timed once, and each round begins with another one: what disturbs the machine for longer than a repetition then
/// disturbs all of them alike.
namespace plumb {

/// Calls `repeat` once for each contestant, in the order of that round: contestant `round` modulo their number first.
void play_round(std::size_t round, std::size_t contestants, const std::function<void(std::size_t contestant)>& repeat);

/// Plays rounds until `repeat` has returned false for all contestants of a round. It returns false without timing
/// anything if its contestant needs no more repetitions.
void repeat_until_settled(std::size_t contestants, const std::function<bool(std::size_t contestant)>& repeat);

/// When there are enough repetitions of one timing.
struct RepetitionRule {
  std::size_t fewest = 5;  // counted repetitions
  std::size_t most = 15;   // and no more than these
  double budget = 0;       // s spent, after which a timing that still varies is left as it is
  double wide = 0;         // interquartile range over median, up to which a timing is precise enough to end early
  // s spent, after which fewest_if_slow are enough. A first repetition that takes longer is no warm-up but counts.
  double slow = std::numeric_limits<double>::infinity();
  std::size_t fewest_if_slow = 3;
  // s, from which the first repetition is enough alone: an interrupt is short beside it.
  double long_enough = std::numeric_limits<double>::infinity();
};

/// The repetitions of one timing. The first one is a warm-up and not counted, unless it is slow.
class Repetitions {
 public:
  explicit Repetitions(const RepetitionRule& rule) : rule_(rule) {}

  /// Adds a timing, in s, of a repetition that took `spent` seconds altogether.
  void add(double seconds, double spent);
  void add(double seconds) { add(seconds, seconds); }

  /// Whether there are enough.
  bool settled() const;
  std::span<const double> counted() const;
  Quartiles spread() const;
  /// Whether the interquartile range exceeds the rule's share of the median.
  bool wide() const;

 private:
  RepetitionRule rule_;
  std::vector<double> seconds_;
  double first_ = 0, spent_ = 0;  // s spent on the first repetition, and on all
};

/// `over` divided by `under`, element by element. Throws std::invalid_argument if their lengths differ.
std::vector<double> ratios(std::span<const double> over, std::span<const double> under);

/// Quartiles of a's time over b's. Both are timed in pairs, alternately a or b first: at least `fewest` pairs, then
/// until they are `decided`, and at most `most`.
Quartiles time_ratio(const std::function<double()>& a, const std::function<double()>& b, std::size_t fewest,
                     std::size_t most, const std::function<bool(const Quartiles&)>& decided);

}  // namespace plumb
