#pragma once

#include <cmath>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The largest share of a restitution, below 1, at which an impact does no work: `at_all`, J > 0, is what it does with
/// all of it, work_at(share) what with less. None is done without any. By regula falsi, halved where that is slow.
template <class Number, class WorkAt>
Number largest_share(Number at_all, const WorkAt& work_at) {
  constexpr int rounds = 24;
  Number low = 0;
  Number high = 1;
  Number at_low = work_at(low);
  if (!(at_low < 0)) return low;
  for (int round = 0; round < rounds; ++round) {
    const bool halves = round % 3 == 2 || !std::isfinite(at_all);
    const Number share = halves ? (low + high) / 2 : low + (high - low) * at_low / (at_low - at_all);
    if (!(share > low && share < high)) break;
    const Number there = work_at(share);
    (there > 0 ? high : low) = share;
    (there > 0 ? at_all : at_low) = there;
    if (there == 0) break;
  }
  return low;
}

}  // namespace impulse::inline IMPULSE_PRECISION
