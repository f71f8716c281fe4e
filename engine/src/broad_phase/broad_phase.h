#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// m, straight on.
struct Way {
  Vec2 by;
  Real length = 0;
};

/// One part of one body, for the search of pairs.
struct Proxy {
  Aabb bounds;  // already grown by the margin, and by its own way to all sides
  Way way;      // that it may go within the margin
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

/// Whether the bounds of two overlap as deep as it takes to meet: both were grown by the way of each, but what goes the
/// same way closes no distance. A little less, that rounding never parts what meets, nor counts beside what stands
/// still.
inline bool within_reach(const Proxy& a, const Proxy& b) {
  const Real both = a.way.length + b.way.length;
  const Real depth = std::max(both - both / 64 - length(a.way.by - b.way.by), Real{0});
  const Vec2 deep{depth, depth};
  return overlap({a.bounds.low + deep, a.bounds.high}, {b.bounds.low + deep, b.bounds.high});
}

/// Finds the pairs that may touch: within reach, layers share a bit, at least one moves, not of one body. Each pair
/// once, sorted. Proxies come sorted by (body, part).
class BroadPhase {
 public:
  BroadPhase() = default;
  BroadPhase(const BroadPhase&) = delete;
  BroadPhase& operator=(const BroadPhase&) = delete;
  virtual ~BroadPhase() = default;
  virtual void find_pairs(std::span<const Proxy> proxies, std::vector<Pair>& pairs) = 0;
  /// Only those pairs in which one is chosen, or both; a flag for each proxy.
  virtual void find_pairs_of(std::span<const Proxy> proxies, std::span<const std::uint8_t> chosen,
                             std::vector<Pair>& pairs) {
    find_pairs(proxies, pairs);
    std::erase_if(pairs, [chosen](const Pair& pair) { return (chosen[pair.first] | chosen[pair.second]) == 0; });
  }
};

/// Whether two proxies whose bounds overlap may collide at all; for whatever says as much of them as a Proxy.
template <class One>
constexpr bool may_collide(const One& a, const One& b) {
  return (a.layers & b.layers) != 0 && (a.moves || b.moves) && a.body != b.body;
}

/// Whether `inner` lies in `outer`, edges included. Bounds that are not numbers lie nowhere.
constexpr bool within(const Aabb& inner, const Aabb& outer) {
  return outer.low.x <= inner.low.x && outer.low.y <= inner.low.y && inner.high.x <= outer.high.x &&
         inner.high.y <= outer.high.y;
}

}  // namespace impulse::inline IMPULSE_PRECISION
