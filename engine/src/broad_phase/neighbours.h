#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/bounds_table.h"
#include "broad_phase/broad_phase.h"
#include "solver/lanes/kernels.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Pairs of proxies that are near each other, kept from step to step, so that what hardly moves costs no search.
///
/// Every proxy gets bounds with some room. While it stays within, the pairs whose rooms overlap hold all that can be
/// within reach, and only these are asked. A few that leave are given new rooms and looked for among all others; where
/// many leave there is a new search, and where that happens again at once, searches without rooms for a while.
class Neighbours {
 public:
  /// What broad_phase.find_pairs() finds, the same pairs in the same order. `version` tells whether the proxies are
  /// still those of the last call, moved.
  void find(BroadPhase& broad_phase, std::span<const Proxy> proxies, std::uint64_t version, std::vector<Pair>& pairs);

 private:
  bool keep_near(std::span<const Proxy> proxies, std::uint64_t version);
  void give_room(std::span<const Proxy> proxies, std::uint32_t i);
  void search_again(BroadPhase& broad_phase, std::span<const Proxy> proxies);
  void follow_leavers(std::span<const Proxy> proxies);
  void list_near_leavers();

  std::uint64_t version_ = 0;  // of the proxies that have rooms; 0 if none have
  std::vector<Proxy> rooms_;   // the proxies with their rooms as bounds, standing still
  BoundsTable table_;          // of the rooms
  std::vector<Pair> near_;     // whose rooms overlap, sorted
  std::vector<Pair> next_near_;
  std::vector<std::uint32_t> leavers_;
  std::vector<std::uint8_t> left_;  // of each proxy: whether it is a leaver
  std::vector<Pair> of_leavers_;    // pairs with a leaver, sorted
  int steps_with_rooms_ = 0;
  int steps_without_ = 0;  // that are still to come
};

}  // namespace impulse::inline IMPULSE_PRECISION
