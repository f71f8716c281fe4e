#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/broad_phase.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Sorts pairs in linear time, by counting sort.
class PairOrder {
 public:
  /// By first, then by second.
  void sort(std::size_t proxy_count, std::vector<Pair>& pairs) {
    if (few(pairs.size(), proxy_count)) return std::sort(pairs.begin(), pairs.end());
    sorted_.resize(pairs.size());
    spread(
        proxy_count, pairs, [](const Pair& pair) { return pair.second; }, sorted_);
    spread(
        proxy_count, sorted_, [](const Pair& pair) { return pair.first; }, pairs);
  }

  /// By a key below key_count; pairs with equal keys keep their order.
  template <class Key>
  void stable_sort(std::size_t key_count, std::span<Pair> pairs, const Key& key) {
    if (few(pairs.size(), key_count)) {
      const auto before = [&key](const Pair& left, const Pair& right) { return key(left) < key(right); };
      return std::stable_sort(pairs.begin(), pairs.end(), before);
    }
    sorted_.resize(pairs.size());
    spread(key_count, pairs, key, sorted_);
    std::copy(sorted_.begin(), sorted_.end(), pairs.begin());
  }

 private:
  /// Too few pairs for a pass over all keys to pay.
  static bool few(std::size_t pairs, std::size_t keys) { return pairs < keys / 16; }

  template <class Key>
  void spread(std::size_t key_count, std::span<const Pair> pairs, const Key& key, std::span<Pair> to) {
    start_.assign(key_count + 1, 0);
    for (const Pair& pair : pairs) ++start_[key(pair) + 1];
    for (std::size_t i = 0; i < key_count; ++i) start_[i + 1] += start_[i];
    for (const Pair& pair : pairs) to[start_[key(pair)]++] = pair;
  }

  std::vector<std::uint32_t> start_;  // where each key's pairs start
  std::vector<Pair> sorted_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
