#pragma once

#include <span>
#include <vector>

#include "reports/timing/sample.h"

namespace plumb {

/// By how much one program takes longer than another, and whether that may be chance.
struct Shift {
  double ratio = 1;   // now to before
  double p = 1;       // of the rank test
  double effect = 0;  // N. Cliff's: 1 where now is always larger
};

/// Of one figure of a pair, by sitting. What changes from sitting to sitting, the pace of the machine above all, is
/// divided out: now/before is held against again/before, which chance alone moves from 1. (They share their
/// denominators, which makes the test err on the side of chance.) The ratio is the median of all quotients of one and
/// the other (J. L. Hodges, E. L. Lehmann, 1963, of logarithms). Values are above 0, as many of each. Throws
/// std::invalid_argument for none.
Shift shift_of(const TimedPair&, std::vector<double> Cost::*what);

/// Which of them are slower at that level together (Holm), and by at least a share of the time before.
std::vector<bool> slower(std::span<const Shift>, double level, double least);

/// The geometric mean over cases, sitting by sitting: what most of them share shows there long before it does in any.
/// Of those that have a result.
TimedPair overall(std::span<const TimedPair>);

}  // namespace plumb
