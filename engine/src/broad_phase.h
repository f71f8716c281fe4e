#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// One part of one body, for the search of pairs.
struct Proxy {
  Aabb bounds;  // already grown by the margin
  std::uint32_t body = 0;
  std::uint16_t part = 0;
  bool moves = false;        // fixed and kinematic bodies don't collide with each other
  std::uint32_t layers = 0;  // two proxies may meet only if a bit is shared
};

/// Indices into the proxies, first < second.
struct Pair {
  std::uint32_t first = 0, second = 0;
  friend constexpr bool operator==(const Pair&, const Pair&) = default;
  friend constexpr bool operator<(const Pair& a, const Pair& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  }
};

/// Finds the pairs that may touch: bounds overlap, layers share a bit, at least one moves, not of one body. Each pair
/// once, sorted. Proxies come sorted by (body, part).
class BroadPhase {
 public:
  BroadPhase() = default;
  BroadPhase(const BroadPhase&) = delete;
  BroadPhase& operator=(const BroadPhase&) = delete;
  virtual ~BroadPhase() = default;
  virtual void find_pairs(std::span<const Proxy> proxies, std::vector<Pair>& pairs) = 0;
};

/// Whether two proxies whose bounds overlap may collide at all; for whatever says as much of them as a Proxy.
template <class One>
constexpr bool may_collide(const One& a, const One& b) {
  return (a.layers & b.layers) != 0 && (a.moves || b.moves) && a.body != b.body;
}

}  // namespace impulse::inline IMPULSE_PRECISION
