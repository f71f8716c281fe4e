#pragma once

#include <span>
#include <string>
#include <vector>

#include "collapse.h"
#include "course.h"
#include "reports/run/run.h"

namespace plumb::benchmarks {

constexpr double dt = 1.0 / 60;  // s, of every step

/// What one engine's window cost in one round, s.
struct Lap {
  double wall = 0;
  double cpu = 0;  // of the thread that steps
};

/// How one engine fared.
struct Finish {
  std::string no_result;  // why its time is none: what it cannot run, or what became of the scene; "" when it is one
  std::vector<Lap> laps;  // by round; none where there is no result
  Depth overlap;          // at the window's end; the worse of each where rounds differ
};

/// In each round every engine builds the scene anew, makes the steps before the window, and then its share of the
/// window in ten turns with the others, in an order that moves on from turn to turn: what disturbs the machine for
/// longer than a turn disturbs them alike. Only steps are on the clock. Who takes more than `patience` seconds over a
/// round's steps drops out. The answer is in the order of the configs.
std::vector<Finish> race(const Start&, Window, std::span<const EngineConfig>, int rounds, double patience);

}  // namespace plumb::benchmarks
