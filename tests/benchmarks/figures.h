#pragma once

#include <span>

#include "race.h"
#include "reports/statistics.h"

namespace plumb::benchmarks {

/// Which of a lap's times ratios are made of: CPU time, which others on the machine hardly touch, where one thread does
/// all the work; wall time where there are several.
enum class Basis { cpu, wall };

/// Whether something else had the processor: wall and CPU time differ by more than a tenth of the wall time.
bool disturbed(const Lap&);

/// What laps of so many steps come to.
struct Figures {
  Quartiles wall, cpu;  // s a step
  Quartiles speed;      // the reference's time over this one's, round by round: 2 means twice as fast
  int disturbed = 0;    // rounds
};

/// Zeros where there are no laps, a speed of zeros where the reference has none. Throws std::invalid_argument where
/// both have some, but not as many: ratios are of the same round.
Figures figures(std::span<const Lap>, std::span<const Lap> reference, int steps, Basis);

}  // namespace plumb::benchmarks
