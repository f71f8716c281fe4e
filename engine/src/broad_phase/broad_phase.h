#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "impulse/body.h"
#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// m, along a straight line.
struct Displacement {
  Vec2 by;
  Real length = 0;
};

/// One part of one body, for the search of pairs.
struct Proxy {
  Aabb bounds;                // already grown by the margin, and by its own displacement to all sides
  Displacement displacement;  // how far it may move within the margin's time
  std::uint32_t body = 0;
  std::uint16_t part = 0;
  bool moves = false;  // fixed and kinematic bodies don't collide with each other
  Layers layers;
};

/// Indices of two proxies, first < second.
struct Pair {
  std::uint32_t first = 0, second = 0;
  friend constexpr bool operator==(const Pair&, const Pair&) = default;
  friend constexpr bool operator<(const Pair& a, const Pair& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  }
};

/// Whether the bounds overlap deeply enough for the two to meet. Both were grown by their own displacement, but bodies
/// that move the same way do not approach each other. The depth is reduced by 1/64, so that rounding never separates
/// proxies that meet, and has no effect next to a proxy that stands still.
inline bool within_reach(const Proxy& a, const Proxy& b) {
  const Real both = a.displacement.length + b.displacement.length;
  const Real depth = std::max(both - both / 64 - length(a.displacement.by - b.displacement.by), Real{0});
  const Vec2 deep{depth, depth};
  return overlap({a.bounds.low + deep, a.bounds.high}, {b.bounds.low + deep, b.bounds.high});
}

/// Whether two proxies may collide at all if their bounds overlap. Takes any type with these fields of Proxy.
template <class One>
constexpr bool may_collide(const One& a, const One& b) {
  return collide(a.layers, b.layers) && (a.moves || b.moves) && a.body != b.body;
}

/// Whether `inner` lies in `outer`, edges included; false if any bound is NaN.
constexpr bool within(const Aabb& inner, const Aabb& outer) {
  return outer.low.x <= inner.low.x && outer.low.y <= inner.low.y && inner.high.x <= outer.high.x &&
         inner.high.y <= outer.high.y;
}

/// Finds the pairs that may touch: within reach of each other, with layers that collide, at least one moving, and of
/// different bodies. Each pair appears once, and pairs are sorted. Proxies must be sorted by (body, part).
class BroadPhase {
 public:
  BroadPhase() = default;
  BroadPhase(const BroadPhase&) = delete;
  BroadPhase& operator=(const BroadPhase&) = delete;
  virtual ~BroadPhase() = default;
  virtual void find_pairs(std::span<const Proxy> proxies, std::vector<Pair>& pairs) = 0;
  /// Finds only the pairs with at least one chosen proxy; `chosen` has a flag for each proxy.
  virtual void find_pairs_of(std::span<const Proxy> proxies, std::span<const std::uint8_t> chosen,
                             std::vector<Pair>& pairs) {
    find_pairs(proxies, pairs);
    std::erase_if(pairs, [chosen](const Pair& pair) { return (chosen[pair.first] | chosen[pair.second]) == 0; });
  }
};

/// The longer side of a proxy's bounds, in double: far from the origin, float would lose a small size.
inline double extent(const Proxy& proxy) {
  const double x = static_cast<double>(proxy.bounds.high.x) - static_cast<double>(proxy.bounds.low.x);
  const double y = static_cast<double>(proxy.bounds.high.y) - static_cast<double>(proxy.bounds.low.y);
  return x > y ? x : y;
}

/// Approximately the median extent, from a sample spread evenly over the proxies; 0 if there are none.
inline double typical_extent(std::span<const Proxy> proxies) {
  constexpr std::size_t most = 63;
  if (proxies.empty()) return 0;
  const std::size_t count = std::min(most, proxies.size());
  std::array<double, most> sample{};
  for (std::size_t i = 0; i < count; ++i) {
    const double size = extent(proxies[i * proxies.size() / count]);
    sample[i] = size > 0 ? size : 0;  // NaN cannot be sorted
  }
  const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(sample.begin(), middle, sample.begin() + static_cast<std::ptrdiff_t>(count));
  return *middle;
}

/// A grid treats a proxy longer than this many typical extents as large, and one whose bounds are NaN.
constexpr double largest_ordinary = 2;
inline bool is_large(const Proxy& proxy, double typical) { return !(extent(proxy) <= largest_ordinary * typical); }

}  // namespace impulse::inline IMPULSE_PRECISION
