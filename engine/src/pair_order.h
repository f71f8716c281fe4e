#pragma once

#include <vector>

#include "broad_phase.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Sorts pairs of proxies in time proportional to their number: a counting sort by the first, then a few comparisons
/// among the handful of partners that a first has.
class PairOrder {
 public:
  void sort(std::size_t proxy_count, std::vector<Pair>& pairs);

 private:
  std::vector<std::uint32_t> start_;  // of each first's partners
  std::vector<Pair> sorted_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
