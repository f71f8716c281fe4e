#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "broad_phase/broad_phase.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The longer side of a proxy's bounds, in double: next to a coordinate a small size must not be lost.
inline double extent(const Proxy& proxy) {
  const double x = static_cast<double>(proxy.bounds.high.x) - static_cast<double>(proxy.bounds.low.x);
  const double y = static_cast<double>(proxy.bounds.high.y) - static_cast<double>(proxy.bounds.low.y);
  return x > y ? x : y;
}

/// About the middle one of all extents, from a sample spread evenly over the proxies. 0 if there are none.
inline double typical_extent(std::span<const Proxy> proxies) {
  constexpr std::size_t most = 63;
  if (proxies.empty()) return 0;
  const std::size_t count = std::min(most, proxies.size());
  std::array<double, most> sample{};
  for (std::size_t i = 0; i < count; ++i) {
    const double size = extent(proxies[i * proxies.size() / count]);
    sample[i] = size > 0 ? size : 0;  // what is not a number cannot be sorted
  }
  const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(sample.begin(), middle, sample.begin() + static_cast<std::ptrdiff_t>(count));
  return *middle;
}

/// What is longer than this many typical extents, a grid treats as large; so what is not a number.
constexpr double largest_ordinary = 2;
inline bool is_large(const Proxy& proxy, double typical) { return !(extent(proxy) <= largest_ordinary * typical); }

}  // namespace impulse::inline IMPULSE_PRECISION
