#include <algorithm>
#include <bit>
#include <cmath>

#include "broad_phase.h"
#include "method_list.h"
#include "pair_order.h"
#include "proxy_sizes.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// A uniform grid made anew by counting sort each time. Its cells are as large as the largest of the ordinary proxies,
/// so that one with its low corner in a cell meets only those with theirs in the same or the eight cells around.
///
/// The endless plane of cells is laid onto `buckets_` many buckets as if on a screw: cell (x, y) goes to x + pitch y,
/// modulo their number. Neighbours in a row stay neighbours in memory, no distant body can make the grid large, and
/// cells that share a bucket only cost a few tests more.
class Grid : public BroadPhase {
 public:
  void find_pairs(std::span<const Proxy> proxies, std::vector<Pair>& pairs) override {
    pairs.clear();
    lay_out(proxies);
    fill(proxies);
    for (std::uint32_t bucket = 0; bucket < buckets_; ++bucket) {
      for (std::uint32_t q = start_[bucket]; q < start_[bucket + 1]; ++q) meet_around(proxies, bucket, q, pairs);
    }
    for (const std::uint32_t large : large_) meet_all(proxies, large, pairs);
    order_.sort(proxies.size(), pairs);
  }

 private:
  struct Item {
    Aabb bounds;
    std::uint32_t proxy = 0;
  };

  // Puts each proxy into its bucket, or among the large.
  void lay_out(std::span<const Proxy> proxies) {
    const double typical = typical_extent(proxies);
    double largest = 0;
    for (const Proxy& proxy : proxies) {
      if (!is_large(proxy, typical)) largest = std::max(largest, extent(proxy));
    }
    // A little more, so that rounding never puts two that touch two cells apart.
    const double cells_per_meter = largest > 0 ? 1 / (1.001 * largest) : 0;
    buckets_ = std::max(least_buckets, std::bit_ceil(static_cast<std::uint32_t>(proxies.size())));
    // Odd and near the golden section: rows that follow each other land far apart, whatever the width of the scene.
    pitch_ = static_cast<std::uint32_t>(0.6180339887 * buckets_) | 1U;

    bucket_of_.resize(proxies.size());
    large_.clear();
    for (std::uint32_t i = 0; i < proxies.size(); ++i) {
      const double x = static_cast<double>(proxies[i].bounds.low.x) * cells_per_meter;
      const double y = static_cast<double>(proxies[i].bounds.low.y) * cells_per_meter;
      const bool countable = std::abs(x) < farthest && std::abs(y) < farthest;
      if (is_large(proxies[i], typical) || !countable) {
        bucket_of_[i] = none;
        large_.push_back(i);
      } else {
        bucket_of_[i] = (whole(x) + pitch_ * whole(y)) & (buckets_ - 1);
      }
    }
  }

  void fill(std::span<const Proxy> proxies) {
    start_.assign(buckets_ + 2, 0);
    for (const std::uint32_t bucket : bucket_of_) {
      if (bucket != none) ++start_[bucket + 2];
    }
    for (std::uint32_t b = 0; b < buckets_; ++b) start_[b + 2] += start_[b + 1];
    items_.resize(proxies.size() - large_.size());
    for (std::uint32_t i = 0; i < proxies.size(); ++i) {
      // start_[b + 1] runs from bucket b's begin to its end, which is where b + 1 begins.
      if (bucket_of_[i] != none) items_[start_[bucket_of_[i] + 1]++] = {proxies[i].bounds, i};
    }
  }

  // Half of the neighbourhood, for each pair of cells meets once: the rest of the own cell with the one to the right,
  // and the three above.
  void meet_around(std::span<const Proxy> proxies, std::uint32_t bucket, std::uint32_t q, std::vector<Pair>& pairs) {
    if (bucket + 1 < buckets_) {
      meet_range(proxies, q, q + 1, start_[bucket + 2], pairs);
    } else {
      meet_range(proxies, q, q + 1, start_[buckets_], pairs);
      meet_range(proxies, q, start_[0], start_[1], pairs);
    }
    const std::uint32_t above = (bucket + pitch_ - 1) & (buckets_ - 1);
    const std::uint32_t end = std::min(above + 3, buckets_);
    meet_range(proxies, q, start_[above], start_[end], pairs);
    if (above + 3 > buckets_) meet_range(proxies, q, start_[0], start_[above + 3 - buckets_], pairs);
  }

  void meet_range(std::span<const Proxy> proxies, std::uint32_t q, std::uint32_t begin, std::uint32_t end,
                  std::vector<Pair>& pairs) {
    const Item item = items_[q];
    for (std::uint32_t other = begin; other < end; ++other) {
      if (!overlap(item.bounds, items_[other].bounds)) continue;
      report(proxies, item.proxy, items_[other].proxy, pairs);
    }
  }

  void meet_all(std::span<const Proxy> proxies, std::uint32_t large, std::vector<Pair>& pairs) {
    for (std::uint32_t i = 0; i < proxies.size(); ++i) {
      const bool met_before = bucket_of_[i] == none && i <= large;
      if (!met_before && overlap(proxies[large].bounds, proxies[i].bounds)) report(proxies, large, i, pairs);
    }
  }

  static void report(std::span<const Proxy> proxies, std::uint32_t a, std::uint32_t b, std::vector<Pair>& pairs) {
    if (may_collide(proxies[a], proxies[b])) pairs.push_back({std::min(a, b), std::max(a, b)});
  }

  static std::uint32_t whole(double x) { return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(x))); }

  static constexpr std::uint32_t none = ~std::uint32_t{0};
  static constexpr std::uint32_t least_buckets = 64;  // the nine cells around one must be nine buckets
  static constexpr double farthest = 1e9;             // cells; beyond, doubles no longer tell neighbours apart well

  std::uint32_t buckets_ = 0;  // a power of two
  std::uint32_t pitch_ = 0;
  std::vector<std::uint32_t> bucket_of_;
  std::vector<std::uint32_t> large_;
  std::vector<std::uint32_t> start_;  // of each bucket's items; one more at the end
  std::vector<Item> items_;
  PairOrder order_;
};

const MethodList<BroadPhase>::Entry entry{{"grid", "uniform grid by counting sort: best for many bodies of like size",
                                           "Ericson, Real-Time Collision Detection, 7.1"},
                                          [] { return std::make_unique<Grid>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
