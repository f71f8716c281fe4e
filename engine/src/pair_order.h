#pragma once

#include <algorithm>
#include <vector>

#include "broad_phase.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Sorts pairs in time proportional to their number, by counting.
class PairOrder {
 public:
  /// By first, then by second.
  void sort(std::size_t proxy_count, std::vector<Pair>& pairs) {
    // Few pairs of many proxies: not worth to count them all.
    if (pairs.size() < proxy_count / 16) return std::sort(pairs.begin(), pairs.end());
    stable_sort(proxy_count, pairs, [](const Pair& pair) { return pair.second; });
    stable_sort(proxy_count, pairs, [](const Pair& pair) { return pair.first; });
  }

  /// By a key below key_count; those with equal keys keep their order.
  template <class Key>
  void stable_sort(std::size_t key_count, std::vector<Pair>& pairs, const Key& key) {
    start_.assign(key_count + 1, 0);
    for (const Pair& pair : pairs) ++start_[key(pair) + 1];
    for (std::size_t i = 0; i < key_count; ++i) start_[i + 1] += start_[i];
    sorted_.resize(pairs.size());
    for (const Pair& pair : pairs) sorted_[start_[key(pair)]++] = pair;
    pairs.swap(sorted_);
  }

 private:
  std::vector<std::uint32_t> start_;  // of each key's pairs
  std::vector<Pair> sorted_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
