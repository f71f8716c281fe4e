#include "pair_order.h"

#include <algorithm>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

// Above, a first's partners (of a floor under a whole pile, say) are no handful any more.
constexpr std::ptrdiff_t handful = 16;

void sort_partners(std::vector<Pair>::iterator begin, std::vector<Pair>::iterator end) {
  if (end - begin > handful) {
    std::sort(begin, end);
    return;
  }
  for (auto next = begin; next != end; ++next) {
    for (auto at = next; at != begin && at->second < (at - 1)->second; --at) std::swap(*at, *(at - 1));
  }
}

}  // namespace

void PairOrder::sort(std::size_t proxy_count, std::vector<Pair>& pairs) {
  start_.assign(proxy_count + 1, 0);
  for (const Pair& pair : pairs) ++start_[pair.first + 1];
  for (std::size_t i = 0; i < proxy_count; ++i) start_[i + 1] += start_[i];

  sorted_.resize(pairs.size());
  for (const Pair& pair : pairs) sorted_[start_[pair.first]++] = pair;  // start_ becomes each first's end
  std::uint32_t begin = 0;
  for (std::size_t i = 0; i < proxy_count; ++i) {
    if (start_[i] - begin > 1) sort_partners(sorted_.begin() + begin, sorted_.begin() + start_[i]);
    begin = start_[i];
  }
  pairs.swap(sorted_);
}

}  // namespace impulse::inline IMPULSE_PRECISION
