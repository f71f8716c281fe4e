#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// Judges whether a program has become slower: statistics of times that two programs took side by side. Times are only
/// compared within a round, in which the programs ran alternately.
namespace plumb {

/// What a step costs a program, by round. In each round it runs in a new process: where things happen to lie in memory,
/// which alone can change times by some percent (Mytkowicz et al. 2009), varies from process to process.
struct StepCosts {
  std::vector<double> cpu, wall;     // s
  std::vector<double> instructions;  // empty if they are not counted
};

/// The costs of one case in two programs.
struct TimedPair {
  std::string name;
  std::string no_result;  // why there are no times; "" if there are
  std::size_t steps = 0;  // timed, from the start of the scene
  std::size_t of = 0;     // steps that the scene has
  // Each has the same number of rounds: the program before, this one, and the one before again, in a process of its
  // own. The difference between the first and the last shows how much times vary by chance.
  StepCosts before, now, again;
};

/// How much more one program costs than another, and whether that may be chance.
struct Shift {
  double ratio = 1;   // now to before
  double p = 1;       // of the rank test
  double effect = 0;  // Cliff's delta: 1 if every value of now is larger
};

/// The shift of one cost of a pair. What changes from round to round, above all the clock rate of the machine, cancels:
/// now/before is compared with again/before, which differs from 1 only by chance. (Both share their denominators, which
/// makes the test conservative.) The ratio is the median of all quotients of the two (the estimator of J. L. Hodges and
/// E. L. Lehmann, 1963, on logarithms). Values are positive. Throws std::invalid_argument if there are none, or unequal
/// numbers of them.
Shift shift_of(const TimedPair&, std::vector<double> StepCosts::*cost);

/// Which of the shifts are significant at that level together (Holm) and a slowdown of at least `least`, a fraction.
std::vector<bool> slower(std::span<const Shift>, double level, double least);

/// The geometric mean over the cases that have a result, round by round: a slowdown that most cases share is
/// significant there long before it is in any single one.
TimedPair overall(std::span<const TimedPair>);

struct TimingRule {
  // With eight values against eight the smallest p is 2/C(16, 8) = 1.6e-4: enough for Holm's level among 300 cases.
  int rounds = 8;
  // Suspicious cases are measured again, alone, and judged by the new times only: the times that made them suspicious
  // are the worst of many.
  int rounds_again = 12;
  double suspicious = 0.05;  // level of the first test: the chance of measuring again without need
  double confirmed = 0.01;   // level of the second test; a false alarm must pass both
  // Half of 5 %, the slowdown that must be found: the median of twelve ratios, each with a noise of 1 to 2 %, is
  // equally safe from either side.
  double least = 0.025;
  double least_instructions = 0.01;  // smaller, because instruction counts have no such noise
};

enum class TimeChange { same, slower, faster, no_result };

/// The verdict on one case, or on all together.
struct JudgedTime {
  TimedPair pair;  // the times that were judged
  TimeChange change = TimeChange::same;
  Shift time;
  std::optional<Shift> instructions;
  bool measured_again = false;
};

/// Times the cases with these indices in that many new rounds.
using TimeCases = std::function<std::vector<TimedPair>(std::span<const std::size_t> which, int rounds)>;

/// The verdict on each case and, if there are several, last on "all cases" together.
std::vector<JudgedTime> judge_times(const TimeCases&, std::size_t cases, const TimingRule& = {});

}  // namespace plumb
