#include <algorithm>
#include <bit>
#include <cmath>

#include "bounds_table.h"
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
/// cells that share a bucket only cost a few tests more. Behind the last bucket stands a copy of the first two, so that
/// three neighbours are always one range; behind that, what is too large for the cells.
class Grid : public BroadPhase {
 public:
  void find_pairs(std::span<const Proxy> proxies, std::vector<Pair>& pairs) override {
    pairs.clear();
    lay_out(proxies);
    fill(proxies);
    for (std::uint32_t bucket = 0; bucket < buckets_; ++bucket) meet_around(bucket, pairs);
    for (std::uint32_t q = first_large_; q < end_; ++q) meet_all(q, pairs);
    order_.sort(proxies.size(), pairs);
  }

  void find_pairs_of(std::span<const Proxy> proxies, std::span<const std::uint8_t> chosen,
                     std::vector<Pair>& pairs) override {
    pairs.clear();
    lay_out(proxies);
    fill(proxies);
    for (std::uint32_t i = 0; i < proxies.size(); ++i) {
      if (chosen[i] != 0) meet_others(i, proxies[i], chosen, pairs);
    }
    order_.sort(proxies.size(), pairs);
  }

 private:
  // Puts each proxy into its bucket, or among the large.
  void lay_out(std::span<const Proxy> proxies) {
    const double typical = typical_extent(proxies);
    bucket_of_.resize(proxies.size());
    reach_.resize(proxies.size());
    double largest = 0;
    for (std::uint32_t i = 0; i < proxies.size(); ++i) {
      const double size = extent(proxies[i]);
      const bool ordinary = !is_large(proxies[i], typical);
      bucket_of_[i] = ordinary ? 0 : none;
      if (ordinary && size > largest) largest = size;
    }
    // A little more, so that rounding never puts two that touch two cells apart.
    const double cells_per_meter = largest > 0 ? 1 / (1.001 * largest) : 0;
    buckets_ = std::max(least_buckets, std::bit_ceil(static_cast<std::uint32_t>(proxies.size())));
    // Odd and near the golden section: rows that follow each other land far apart, whatever the width of the scene.
    pitch_ = static_cast<std::uint32_t>(0.6180339887 * buckets_) | 1U;

    large_.clear();
    for (std::uint32_t i = 0; i < proxies.size(); ++i) {
      const double x = static_cast<double>(proxies[i].bounds.low.x) * cells_per_meter;
      const double y = static_cast<double>(proxies[i].bounds.low.y) * cells_per_meter;
      const bool countable = std::abs(x) < farthest && std::abs(y) < farthest;
      if (bucket_of_[i] == none || !countable) {
        bucket_of_[i] = none;
        large_.push_back(i);
      } else {
        bucket_of_[i] = (whole(x) + pitch_ * whole(y)) & (buckets_ - 1);
        const double high_x = static_cast<double>(proxies[i].bounds.high.x) * cells_per_meter;
        const double high_y = static_cast<double>(proxies[i].bounds.high.y) * cells_per_meter;
        reach_[i] = {whole(high_x) != whole(x), whole(high_y) != whole(y)};
      }
    }
  }

  void fill(std::span<const Proxy> proxies) {
    start_.assign(buckets_ + repeated + 1, 0);
    for (const std::uint32_t bucket : bucket_of_) {
      if (bucket != none) ++start_[bucket + 2];
    }
    for (std::uint32_t b = 0; b < buckets_; ++b) start_[b + 2] += start_[b + 1];
    count_ = static_cast<std::uint32_t>(proxies.size() - large_.size());
    items_.resize(2 * proxies.size());
    bounds_.resize(2 * proxies.size());
    for (std::uint32_t i = 0; i < proxies.size(); ++i) {
      // start_[b + 1] runs from bucket b's begin to its end, which is where b + 1 begins.
      if (bucket_of_[i] != none) put(start_[bucket_of_[i] + 1]++, proxies[i], i);
    }
    for (std::uint32_t b = 1; b <= repeated; ++b) start_[buckets_ + b] = count_ + start_[b];
    for (std::uint32_t q = 0; q < start_[repeated]; ++q) {
      items_[count_ + q] = items_[q];
      bounds_.set(count_ + q, bounds_.bounds(q), bounds_.way(q));
    }
    first_large_ = end_ = count_ + start_[repeated];
    for (const std::uint32_t large : large_) put(end_++, proxies[large], large);
  }

  void put(std::uint32_t at, const Proxy& proxy, std::uint32_t i) {
    items_[at] = {i, proxy.body, proxy.layers, proxy.moves};
    bounds_.set(at, proxy.bounds, proxy.way);
  }

  // Half of the neighbourhood, for each pair of cells meets once: the rest of the own cell with the one to the right,
  // and the three above; of these, as many as it reaches.
  void meet_around(std::uint32_t bucket, std::vector<Pair>& pairs) {
    const std::uint32_t above = (bucket + pitch_ - 1) & (buckets_ - 1);
    for (std::uint32_t q = start_[bucket]; q < start_[bucket + 1]; ++q) {
      const Reach reach = reach_[items_[q].proxy];
      const std::uint32_t right = reach.right ? 1 : 0;
      const Range own{q + 1, start_[bucket + 1 + right]};
      const auto others = reach.above ? around(q, {own, {start_[above], start_[above + 2 + right]}}) : around(q, {own});
      for (const std::uint32_t other : others) report(items_[q], items_[other], pairs);
    }
  }

  // All around, or all. Of two that are chosen the first reports.
  void meet_others(std::uint32_t i, const Proxy& proxy, std::span<const std::uint8_t> chosen,
                   std::vector<Pair>& pairs) {
    const Item own{i, proxy.body, proxy.layers, proxy.moves};
    const std::uint32_t bucket = bucket_of_[i];
    const Range large{first_large_, end_};
    const auto others =
        bucket == none
            ? bounds_.within_reach(proxy.bounds, proxy.way, {{0, count_}, large})
            : bounds_.within_reach(proxy.bounds, proxy.way,
                                   {row(bucket - pitch_, reach_[i].right), row(bucket, reach_[i].right),
                                    reach_[i].above ? row(bucket + pitch_, reach_[i].right) : Range{}, large});
    for (const std::uint32_t other : others) {
      if (chosen[items_[other].proxy] == 0 || i < items_[other].proxy) report(own, items_[other], pairs);
    }
  }

  // The cell's left neighbour, itself, and its right neighbour if that is reached.
  Range row(std::uint32_t cell, bool right) const {
    const std::uint32_t left = (cell - 1) & (buckets_ - 1);
    return {start_[left], start_[left + (right ? 3 : 2)]};
  }

  // All in the grid and the rest of the large.
  void meet_all(std::uint32_t q, std::vector<Pair>& pairs) {
    for (const std::uint32_t other : around(q, {{0, count_}, {q + 1, end_}})) {
      report(items_[q], items_[other], pairs);
    }
  }

  std::span<const std::uint32_t> around(std::uint32_t q, std::initializer_list<Range> ranges) {
    return bounds_.within_reach(bounds_.bounds(q), bounds_.way(q), ranges);
  }

  /// What is asked of a proxy whose bounds overlap another's.
  struct Item {
    std::uint32_t proxy, body, layers;
    bool moves;
  };

  static void report(const Item& a, const Item& b, std::vector<Pair>& pairs) {
    if (may_collide(a, b)) pairs.push_back({std::min(a.proxy, b.proxy), std::max(a.proxy, b.proxy)});
  }

  // Rounded down. std::floor may be a call.
  static std::uint32_t whole(double x) {
    const auto towards_zero = static_cast<std::int64_t>(x);
    return static_cast<std::uint32_t>(towards_zero - (static_cast<double>(towards_zero) > x ? 1 : 0));
  }

  /// Whether bounds end in another cell than they begin in.
  struct Reach {
    bool right, above;
  };

  static constexpr std::uint32_t none = ~std::uint32_t{0};
  static constexpr std::uint32_t least_buckets = 64;  // the nine cells around one must be nine buckets
  static constexpr std::uint32_t repeated = 2;
  static constexpr double farthest = 1e9;  // cells; beyond, doubles no longer tell neighbours apart well

  std::uint32_t buckets_ = 0;  // a power of two
  std::uint32_t pitch_ = 0;
  std::uint32_t count_ = 0;                  // in the buckets, copies aside
  std::uint32_t first_large_ = 0, end_ = 0;  // of the items, behind the copies
  std::vector<std::uint32_t> bucket_of_;
  std::vector<Reach> reach_;  // of each proxy in the grid
  std::vector<std::uint32_t> large_;
  std::vector<std::uint32_t> start_;  // of each bucket's items; one more at the end
  std::vector<Item> items_;
  BoundsTable bounds_;
  PairOrder order_;
};

const MethodList<BroadPhase>::Entry entry{{"grid", "uniform grid by counting sort: best for many bodies of like size",
                                           "Ericson, Real-Time Collision Detection, 7.1"},
                                          [] { return std::make_unique<Grid>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
