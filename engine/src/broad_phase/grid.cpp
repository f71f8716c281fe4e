#include <algorithm>
#include <bit>
#include <cmath>

#include "broad_phase/bounds_table.h"
#include "broad_phase/broad_phase.h"
#include "broad_phase/pair_order.h"
#include "core/method_list.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// A uniform grid, rebuilt by counting sort in each call. Each proxy is in the cell of its low corner and, unless it is
/// large, extends at most `reach_` cells from there.
///
/// The infinite plane of cells is hashed to `buckets_` buckets: cell (x, y) goes to x + pitch y, modulo their number.
/// Neighbours in a row stay neighbours in memory, a distant body cannot make the grid large, and cells that share a
/// bucket only cost a few more tests. The first few buckets are copied behind the last one, so that neighbours in a row
/// always form one range; proxies too large for the cells come after that. Each large proxy is tested against what lies
/// in the cells it covers, so that a ground of many long pieces costs little.
class Grid : public BroadPhase {
 public:
  void find_pairs(std::span<const Proxy> proxies, std::vector<Pair>& pairs) override {
    lay_out(proxies);
    clear_queries();
    for (std::uint32_t bucket = 0; bucket < buckets_; ++bucket) {
      for (std::uint32_t q = start_[bucket]; q < start_[bucket + 1]; ++q) query_around(q, bucket);
    }
    for (std::uint32_t q = first_large_; q < end_; ++q) query_as_large(q);
    report(pairs, [](std::uint32_t, std::uint32_t) { return true; });
    order_.sort(proxies.size(), pairs);
  }

  /// If the chosen proxies have only grown a little and the others are unchanged, all stay in their cells.
  void find_pairs_of(std::span<const Proxy> proxies, std::span<const std::uint8_t> chosen,
                     std::vector<Pair>& pairs) override {
    if (!grow(proxies, chosen)) lay_out(proxies);
    clear_queries();
    // Few large proxies are tested by the queries of the chosen; many query themselves.
    const bool large_query = end_ - first_large_ > few_large;
    for (std::uint32_t i = 0; i < proxies.size(); ++i) {
      if (chosen[i] == 0 || (large_query && slot_of_[i] >= first_large_)) continue;
      query_cells(slot_of_[i]);
      if (!large_query) query(slot_of_[i], every_row, {first_large_, end_});
    }
    for (std::uint32_t q = first_large_; large_query && q < end_; ++q) query_as_large(q);
    report(pairs, [&, first_large = first_large_](std::uint32_t from, std::uint32_t other) {
      const std::uint32_t a = items_[from].proxy;
      const std::uint32_t b = items_[other].proxy;
      if (large_query && from >= first_large) return (chosen[a] | chosen[b]) != 0;
      return static_cast<bool>((chosen[b] == 0) | (a < b));  // two chosen proxies both query
    });
    order_.sort(proxies.size(), pairs);
  }

 private:
  void lay_out(std::span<const Proxy> proxies) {
    choose_cells(proxies);
    large_.clear();
    place_.resize(proxies.size());
    for (std::uint32_t i = 0; i < proxies.size(); ++i) {
      const Cells cells = cells_of(proxies[i].bounds);
      if (cells.countable() && !is_large(proxies[i], typical_)) {
        place_[i] = place_in(cells);
      } else {
        place_[i].bucket = none;
        large_.push_back(i);
      }
    }
    // Proxies that stand still meet only the large ones that move: those come first and query all behind them.
    std::stable_partition(large_.begin(), large_.end(), [proxies](std::uint32_t i) { return proxies[i].moves; });
    fill(proxies);
    laid_out_.assign(proxies.begin(), proxies.end());
  }

  void choose_cells(std::span<const Proxy> proxies) {
    typical_ = typical_extent(proxies);
    double largest = 0;
    for (const Proxy& proxy : proxies) {
      const double size = extent(proxy);
      if (!is_large(proxy, typical_) && size > largest) largest = size;
    }
    // The largest spans two cells; a little more, so that rounding never puts two that touch too far apart.
    const double reach = 1.001 * largest;
    const double cell = std::max(typical_, reach / 2);
    cells_per_meter_ = reach > 0 ? 1 / cell : 0;
    reach_ = reach * cells_per_meter_;
    growth_ = 0;
    buckets_ = std::max(least_buckets, std::bit_ceil(static_cast<std::uint32_t>(proxies.size())));
    // Odd and near the golden ratio: successive rows land far apart, whatever the width of the scene.
    pitch_ = static_cast<std::uint32_t>(0.6180339887 * buckets_) | 1U;
  }

  void fill(std::span<const Proxy> proxies) {
    start_.assign(buckets_ + repeated + 1, 0);
    for (const Place& place : place_) {
      if (place.bucket != none) ++start_[place.bucket + 2];
    }
    for (std::uint32_t b = 0; b < buckets_; ++b) start_[b + 2] += start_[b + 1];
    count_ = static_cast<std::uint32_t>(proxies.size() - large_.size());
    items_.resize(2 * proxies.size());
    bounds_.resize(2 * proxies.size());
    slot_of_.resize(proxies.size());
    for (std::uint32_t i = 0; i < proxies.size(); ++i) {
      // start_[b + 1] advances from the start of bucket b to its end, where b + 1 starts.
      if (place_[i].bucket != none) put(start_[place_[i].bucket + 1]++, proxies[i], i);
    }
    for (std::uint32_t b = 1; b <= repeated; ++b) start_[buckets_ + b] = count_ + start_[b];
    for (std::uint32_t q = 0; q < start_[repeated]; ++q) {
      items_[count_ + q] = items_[q];
      bounds_.set(count_ + q, bounds_.bounds(q), bounds_.displacement(q));
    }
    first_large_ = end_ = count_ + start_[repeated];
    for (const std::uint32_t large : large_) put(end_++, proxies[large], large);
  }

  void put(std::uint32_t at, const Proxy& proxy, std::uint32_t i) {
    items_[at] = {i, proxy.body, proxy.layers, place_[i], proxy.moves};
    bounds_.set(at, proxy.bounds, proxy.displacement);
    slot_of_[i] = at;
  }

  /// Updates the bounds of the chosen proxies if they have grown by less than a cell and the others are unchanged since
  /// the layout; otherwise returns false.
  bool grow(std::span<const Proxy> proxies, std::span<const std::uint8_t> chosen) {
    if (growth_ > 0 || laid_out_.size() != proxies.size()) return false;
    Real growth = 0;  // m
    for (std::size_t i = 0; i < proxies.size(); ++i) {
      const Proxy& now = proxies[i];
      const Proxy& then = laid_out_[i];
      const bool same_displacement =
          (now.displacement.by.x == then.displacement.by.x) & (now.displacement.by.y == then.displacement.by.y);
      if (!(same_displacement & (now.body == then.body) & (now.moves == then.moves) & (now.layers == then.layers)))
        return false;
      const Vec2 low = then.bounds.low - now.bounds.low;
      const Vec2 high = now.bounds.high - then.bounds.high;
      const Real by = std::max(std::max(low.x, low.y), std::max(high.x, high.y));
      const bool same = (low.x == 0) & (low.y == 0) & (high.x == 0) & (high.y == 0);
      if (!(same | (chosen[i] != 0 && cells_per_meter_ * static_cast<double>(by) < 1))) return false;
      growth = std::max(growth, by);
    }
    growth_ = 1.001 * cells_per_meter_ * static_cast<double>(growth);
    for (std::size_t i = 0; growth > 0 && i < proxies.size(); ++i) {
      if (chosen[i] == 0) continue;
      const std::uint32_t slot = slot_of_[i];
      bounds_.set(slot, proxies[i].bounds, proxies[i].displacement);
      if (slot < start_[repeated]) bounds_.set(count_ + slot, proxies[i].bounds, proxies[i].displacement);
    }
    return true;
  }

  // Half of the neighbourhood, so that each pair of cells is tested once: the rest of its own cell and those to the
  // right, and the rows above that it reaches.
  void query_around(std::uint32_t q, std::uint32_t bucket) {
    const Place& place = items_[q].place;
    query(q, place.row, {q + 1, start_[bucket + 1 + place.right]});
    for (std::uint32_t up = 1; up <= place.above; ++up) {
      const std::uint32_t begin = (bucket + up * pitch_ - place.left) & (buckets_ - 1);
      query(q, place.row + up, {start_[begin], start_[begin + place.left + 1 + place.right]});
    }
  }

  // The large proxies behind it, and those in the cells it covers.
  void query_as_large(std::uint32_t q) {
    if (items_[q].moves) query(q, every_row, {q + 1, end_});
    query_cells(q);
  }

  // All proxies that can overlap its bounds.
  void query_cells(std::uint32_t q) {
    const Cells own = cells_of(bounds_.bounds(q));
    const double before = reach_ + growth_;
    const Cells cells{own.left - before, own.bottom - before, own.right + growth_, own.top + growth_};
    const double columns = cells.right - cells.left + 2;
    const double rows = cells.top - cells.bottom + 2;
    if (!(cells.countable() && columns < buckets_ && rows * worth_a_row < count_))
      return query(q, every_row, {0, count_});
    const std::uint32_t left = whole(cells.left);
    const std::uint32_t width = whole(cells.right) - left + 1;
    for (std::uint32_t row = whole(cells.bottom); row != whole(cells.top) + 1; ++row) {
      const std::uint32_t begin = bucket_at(left, row);
      const std::uint32_t end = begin + width;
      if (end <= buckets_ + repeated) {
        query(q, row, {start_[begin], start_[end]});
      } else {
        query(q, row, {start_[begin], count_});
        query(q, row, {0, start_[end - buckets_]});
      }
    }
  }

  void query(std::uint32_t q, std::uint32_t row, const Range& range) {
    queries_.push_back({q, range});
    query_row_.push_back(row);
  }
  void clear_queries() {
    queries_.clear();
    query_row_.clear();
  }

  /// Runs the queries and lists the hits that may collide and for which allowed(from, other) holds.
  template <class Allowed>
  void report(std::vector<Pair>& pairs, const Allowed& allowed) {
    const Item* items = items_.data();
    const Query* queries = queries_.data();
    const std::uint32_t* rows = query_row_.data();
    std::size_t count = 0;
    Pair* to = pairs.data();
    bounds_.answer(queries_, [&](std::uint32_t query, std::uint32_t other) {
      if (count == pairs.size()) {
        pairs.resize(2 * count + 1024);
        to = pairs.data();
      }
      const std::uint32_t from = queries[query].from;
      const Item& a = items[from];
      const Item& b = items[other];
      // A bucket may also hold proxies of other rows, which a query for their own row finds.
      const bool in_row = (rows[query] == every_row) | (rows[query] == b.place.row);
      to[count] = in_order(a.proxy, b.proxy);
      count += in_row && may_collide(a, b) && allowed(from, other) ? 1 : 0;
    });
    pairs.resize(count);
  }

  // Without a branch, which would be mispredicted half of the time.
  static Pair in_order(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t swapped = (a ^ b) & (0U - static_cast<std::uint32_t>(b < a));
    return {a ^ swapped, b ^ swapped};
  }

  // Rounded to the nearest, which is as good a border of cells as any: the sum has no bits for fractions, and its
  // lowest bits are those of the integer.
  static std::uint32_t whole(double x) {
    return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(x + 0x1.8p52));
  }

  /// Bounds in units of cells.
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

  /// The cell of the low corner, and the number of cells the bounds extend to the right and above; `left` is how many
  /// cells further left other proxies may start that reach them.
  struct Place {
    std::uint32_t bucket, row;
    std::uint8_t left, right, above;
  };
  Place place_in(const Cells& cells) const {
    const std::uint32_t column = whole(cells.left);
    const std::uint32_t row = whole(cells.bottom);
    const auto few = [](std::uint32_t count) { return static_cast<std::uint8_t>(count); };
    return {bucket_at(column, row), row, few(column - whole(cells.left - reach_)), few(whole(cells.right) - column),
            few(whole(cells.top) - row)};
  }

  /// The fields of a proxy that are needed when its bounds overlap another's.
  struct Item {
    std::uint32_t proxy, body;
    Layers layers;
    Place place;
    bool moves;
  };

  static constexpr std::uint32_t none = ~std::uint32_t{0};
  static constexpr std::uint32_t every_row = std::uint32_t{1} << 31U;  // farther than any row
  static constexpr std::uint32_t least_buckets = 64;
  static constexpr std::uint32_t repeated = 6;  // cells in a row that an ordinary proxy can touch
  static constexpr double farthest = 1e9;       // cells; beyond, doubles are too coarse to tell neighbours apart
  // Going to another row of cells takes as long as testing this many proxies.
  static constexpr double worth_a_row = 32;
  static constexpr std::uint32_t few_large = 64;

  std::vector<Proxy> laid_out_;
  double typical_ = 0;  // m
  double cells_per_meter_ = 0;
  double reach_ = 0;           // cells, of the largest ordinary proxy
  double growth_ = 0;          // cells, by which bounds grew since the layout
  std::uint32_t buckets_ = 0;  // a power of two
  std::uint32_t pitch_ = 0;
  std::uint32_t count_ = 0;                  // in the buckets, without copies
  std::uint32_t first_large_ = 0, end_ = 0;  // of the items; large ones follow the copies
  std::vector<Place> place_;                 // of each proxy
  std::vector<std::uint32_t> slot_of_;       // of each proxy, among the items
  std::vector<std::uint32_t> large_;
  std::vector<std::uint32_t> start_;  // of each bucket's items; one more at the end
  std::vector<Item> items_;
  BoundsTable bounds_;  // of the items
  std::vector<Query> queries_;
  std::vector<std::uint32_t> query_row_;  // of each query: hits must be in it
  PairOrder order_;
};

const MethodList<BroadPhase>::Entry grid_entry{
    {"grid", "uniform grid by counting sort: best for many bodies of like size",
     "Ericson, Real-Time Collision Detection, 7.1"},
    [] { return std::make_unique<Grid>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
