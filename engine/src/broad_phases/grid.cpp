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
/// three neighbours are always one range; behind that, what is too large for the cells. Each of those meets what lies
/// in the cells that it covers, so that a ground of many long pieces costs little.
class Grid : public BroadPhase {
 public:
  void find_pairs(std::span<const Proxy> proxies, std::vector<Pair>& pairs) override {
    pairs.clear();
    lay_out(proxies);
    fill(proxies);
    for (std::uint32_t bucket = 0; bucket < buckets_; ++bucket) meet_around(bucket, pairs);
    for (std::uint32_t q = first_large_; q < end_; ++q) {
      meet_large(q, [&](std::uint32_t other) { report(items_[q], items_[other], pairs); });
    }
    order_.sort(proxies.size(), pairs);
  }

  void find_pairs_of(std::span<const Proxy> proxies, std::span<const std::uint8_t> chosen,
                     std::vector<Pair>& pairs) override {
    pairs.clear();
    lay_out(proxies);
    fill(proxies);
    // A few ask the large ones, many are asked by them.
    const bool many = proxies.size() - static_cast<std::size_t>(std::count(chosen.begin(), chosen.end(), 0)) > few;
    const Range large = many ? Range{} : Range{first_large_, end_};
    for (std::uint32_t i = 0; i < proxies.size(); ++i) {
      if (chosen[i] != 0 && !(many && bucket_of_[i] == none)) meet_others(i, proxies[i], chosen, large, pairs);
    }
    for (std::uint32_t q = first_large_; many && q < end_; ++q) {
      const bool asks = chosen[items_[q].proxy] != 0;
      meet_large(q, [&](std::uint32_t other) {
        if (asks || chosen[items_[other].proxy] != 0) report(items_[q], items_[other], pairs);
      });
    }
    order_.sort(proxies.size(), pairs);
  }

 private:
  // Puts each proxy into its bucket, or among the large.
  void lay_out(std::span<const Proxy> proxies) {
    const double typical = typical_extent(proxies);
    bucket_of_.resize(proxies.size());
    place_.resize(proxies.size());
    double largest = 0;
    for (std::uint32_t i = 0; i < proxies.size(); ++i) {
      const double size = extent(proxies[i]);
      const bool ordinary = !is_large(proxies[i], typical);
      bucket_of_[i] = ordinary ? 0 : none;
      if (ordinary && size > largest) largest = size;
    }
    // A little more, so that rounding never puts two that touch two cells apart.
    cells_per_meter_ = largest > 0 ? 1 / (1.001 * largest) : 0;
    buckets_ = std::max(least_buckets, std::bit_ceil(static_cast<std::uint32_t>(proxies.size())));
    // Odd and near the golden section: rows that follow each other land far apart, whatever the width of the scene.
    pitch_ = static_cast<std::uint32_t>(0.6180339887 * buckets_) | 1U;

    large_.clear();
    for (std::uint32_t i = 0; i < proxies.size(); ++i) {
      const Cells cells = cells_of(proxies[i].bounds);
      if (bucket_of_[i] == none || !cells.countable()) {
        bucket_of_[i] = none;
        large_.push_back(i);
      } else {
        const std::uint32_t row = whole(cells.bottom);
        bucket_of_[i] = bucket_at(whole(cells.left), row);
        place_[i] = {row, whole(cells.right) != whole(cells.left), whole(cells.top) != row};
      }
    }
    // What stands still meets only those large ones that move: they come first and meet all behind them.
    std::stable_partition(large_.begin(), large_.end(), [proxies](std::uint32_t i) { return proxies[i].moves; });
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
      const Place& place = place_[items_[q].proxy];
      const std::uint32_t right = place.reaches_right ? 1 : 0;
      const Range own{q + 1, start_[bucket + 1 + right]};
      const auto others =
          place.reaches_above ? around(q, {own, {start_[above], start_[above + 2 + right]}}) : around(q, {own});
      for (const std::uint32_t other : others) report(items_[q], items_[other], pairs);
    }
  }

  // All around and some of the large, or all. Of two that are chosen the first reports.
  void meet_others(std::uint32_t i, const Proxy& proxy, std::span<const std::uint8_t> chosen, const Range& large,
                   std::vector<Pair>& pairs) {
    const Item own{i, proxy.body, proxy.layers, proxy.moves};
    const std::uint32_t bucket = bucket_of_[i];
    const Place& place = place_[i];
    const auto others =
        bucket == none
            ? bounds_.within_reach(proxy.bounds, proxy.way, {{0, count_}, large})
            : bounds_.within_reach(proxy.bounds, proxy.way,
                                   {row(bucket - pitch_, place.reaches_right), row(bucket, place.reaches_right),
                                    place.reaches_above ? row(bucket + pitch_, place.reaches_right) : Range{}, large});
    for (const std::uint32_t other : others) {
      if (chosen[items_[other].proxy] == 0 || i < items_[other].proxy) report(own, items_[other], pairs);
    }
  }

  // The cell's left neighbour, itself, and its right neighbour if that is reached.
  Range row(std::uint32_t cell, bool right) const {
    const std::uint32_t left = (cell - 1) & (buckets_ - 1);
    return {start_[left], start_[left + (right ? 3 : 2)]};
  }

  /// Calls meet(other) for all that a large one is within reach of, in the grid and among the large ones behind it.
  template <class Meet>
  void meet_large(std::uint32_t q, const Meet& meet) {
    if (items_[q].moves) {
      for (const std::uint32_t other : around(q, {{q + 1, end_}})) meet(other);
    }
    const Cells cells = cells_of(bounds_.bounds(q));
    // What begins in the cells to the left and below may end in these.
    const double columns = cells.right - cells.left + 3;
    const double rows = cells.top - cells.bottom + 3;
    if (!(cells.countable() && columns < buckets_ && rows * worth_a_row < count_)) {
      for (const std::uint32_t other : around(q, {{0, count_}})) meet(other);
      return;
    }
    const std::uint32_t left = whole(cells.left) - 1;
    const std::uint32_t width = whole(cells.right) - left + 1;
    for (std::uint32_t row = whole(cells.bottom) - 1; row != whole(cells.top) + 1; ++row) {
      const std::uint32_t begin = bucket_at(left, row);
      const std::uint32_t end = std::min(begin + width, buckets_);
      const Range rest{0, start_[begin + width - end]};  // of the row, from the first bucket on
      const Range first{start_[begin], start_[end]};
      const auto others = rest.end > 0 ? around(q, {first, rest}) : around(q, {first});
      for (const std::uint32_t other : others) {
        if (place_[items_[other].proxy].row == row) meet(other);  // and not by chance in the same bucket
      }
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

  /// Where bounds begin and end, in cells.
  struct Cells {
    double left, bottom, right, top;
    bool countable() const {
      return left <= right && bottom <= top && std::abs(left) < farthest && std::abs(bottom) < farthest &&
             std::abs(right) < farthest && std::abs(top) < farthest;
    }
  };
  Cells cells_of(const Aabb& bounds) const {
    const auto cells = [this](Real x) { return static_cast<double>(x) * cells_per_meter_; };
    return {cells(bounds.low.x), cells(bounds.low.y), cells(bounds.high.x), cells(bounds.high.y)};
  }
  std::uint32_t bucket_at(std::uint32_t column, std::uint32_t row) const {
    return (column + pitch_ * row) & (buckets_ - 1);
  }

  /// The row of cells that bounds begin in, and whether they end in another cell than they begin in.
  struct Place {
    std::uint32_t row;
    bool reaches_right, reaches_above;
  };

  static constexpr std::uint32_t none = ~std::uint32_t{0};
  static constexpr std::uint32_t least_buckets = 64;  // the nine cells around one must be nine buckets
  static constexpr std::uint32_t repeated = 2;
  static constexpr double farthest = 1e9;  // cells; beyond, doubles no longer tell neighbours apart well
  // So many proxies are tested in the time that it takes to turn to another row of cells.
  static constexpr double worth_a_row = 64;
  static constexpr std::size_t few = 256;

  std::uint32_t buckets_ = 0;  // a power of two
  std::uint32_t pitch_ = 0;
  double cells_per_meter_ = 0;
  std::uint32_t count_ = 0;                  // in the buckets, copies aside
  std::uint32_t first_large_ = 0, end_ = 0;  // of the items, behind the copies
  std::vector<std::uint32_t> bucket_of_;
  std::vector<Place> place_;  // of each proxy in the grid
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
