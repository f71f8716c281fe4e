#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/bounds_table.h"
#include "broad_phase/broad_phase.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Pairs of proxies with overlapping fat AABBs, kept from step to step, so that proxies that hardly move need no new
/// search.
///
/// While every proxy stays within its fat AABB, the pairs whose fat AABBs overlap include all that can be within reach,
/// and only those are tested. If a few proxies leave theirs, they get new ones and are tested against all others; if
/// many leave, the search is repeated; and if that happens again soon, fat AABBs are not used for a while.
class Neighbours {
 public:
  /// Finds the same pairs as broad_phase.find_pairs(), in the same order. While `version` is unchanged, the proxies are
  /// those of the last call, except that they may have moved.
  void find(BroadPhase& broad_phase, std::span<const Proxy> proxies, std::uint64_t version, std::vector<Pair>& pairs);

 private:
  bool keep_near(std::span<const Proxy> proxies, std::uint64_t version);
  void set_fat(std::span<const Proxy> proxies, std::uint32_t i);
  void search_again(BroadPhase& broad_phase, std::span<const Proxy> proxies);
  void update_moved(std::span<const Proxy> proxies);
  void list_near_moved();

  std::uint64_t version_ = 0;  // of the proxies that have fat AABBs; 0 if none have
  std::vector<Proxy> fat_;     // the proxies with their fat AABBs as bounds, standing still
  BoundsTable table_;          // of the fat AABBs
  std::vector<Pair> near_;     // whose fat AABBs overlap, sorted
  std::vector<Pair> next_near_;
  std::vector<std::uint32_t> moved_;  // proxies that have left their fat AABBs
  std::vector<std::uint8_t> moved_flag_;
  std::vector<Pair> near_moved_;  // near pairs with a moved proxy, sorted
  int steps_with_fat_ = 0;
  int steps_without_ = 0;  // steps left without fat AABBs
};

}  // namespace impulse::inline IMPULSE_PRECISION
