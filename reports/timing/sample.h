#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace plumb {

/// What a step costs a program, by sitting: each a process of its own, so that where things happen to lie in memory,
/// which alone can make some percent (Mytkowicz et al. 2009), is drawn anew.
struct Cost {
  std::vector<double> cpu, wall;     // s
  std::vector<double> instructions;  // empty where they are not counted
};

/// One case, timed in two programs side by side.
struct TimedPair {
  std::string name;
  std::string no_result;  // why there are no times; "" where there are
  std::size_t steps = 0;  // of a run, from its start
  std::size_t of = 0;     // steps that the scene has
  // As many sittings of each: the program before, this one, and the one before once more, in a process of its own. How
  // far the last is from the first tells how much there is of chance.
  Cost before, now, again;
};

/// Times those cases, by index, in that many sittings more.
using TimeCases = std::function<std::vector<TimedPair>(std::span<const std::size_t> which, int sittings)>;

}  // namespace plumb
