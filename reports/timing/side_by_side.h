#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/timing/judge_times.h"
#include "reports/timing/sample.h"

/// Whether a change made stepping slower. Times are only ever compared within one run, in which both programs took
/// turns.
namespace plumb {

struct TimingRule {
  // With eight against eight the least p is 2/C(16, 8) = 1.6e-4: enough for Holm's level among some 300 cases.
  int sittings = 8;
  // What stands out is measured again, by itself, and judged by the new times alone: those that made it stand out are
  // the worst of many.
  int again = 12;
  double suspicious = 0.05;  // level of the first look: chance of measuring again without need
  double confirmed = 0.01;   // and of the second; a false alarm needs both
  // Halfway to 5 %, which is to be found: the median of twelve ratios, each with 1 to 2 % of noise, is as safe from
  // either side.
  double least = 0.025;
  double least_instructions = 0.01;  // which carry no such noise
};

enum class Pace { same, slower, faster, no_result };

/// What became of one case, or of all together.
struct JudgedTime {
  TimedPair pair;  // the times by which it was judged
  Pace pace = Pace::same;
  Shift time;
  std::optional<Shift> instructions;
  bool measured_again = false;
};

/// By case, then all together as "all cases" where there are several.
std::vector<JudgedTime> judge_times(const TimeCases&, std::size_t cases, const TimingRule& = {});

}  // namespace plumb
