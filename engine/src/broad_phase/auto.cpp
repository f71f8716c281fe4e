#include <algorithm>

#include "broad_phase/bounds_table.h"
#include "broad_phase/broad_phase.h"
#include "core/method_list.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Tests every proxy against every later one: nothing to keep, nothing to build, and the pairs come out sorted. Kernels
/// test many at a time, except for a handful of proxies, where filling the table would cost more than the tests.
class Brute : public BroadPhase {
 public:
  void find_pairs(std::span<const Proxy> proxies, std::vector<Pair>& pairs) override {
    pairs.clear();
    const auto count = static_cast<std::uint32_t>(proxies.size());
    if (count <= handful) return test_one_by_one(proxies, pairs);
    bounds_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) bounds_.set(i, proxies[i].bounds, proxies[i].displacement);
    for (std::uint32_t i = 0; i < count; ++i) {
      for (const std::uint32_t j : bounds_.within_reach(proxies[i].bounds, proxies[i].displacement, {{i + 1, count}})) {
        if (may_collide(proxies[i], proxies[j])) pairs.push_back({i, j});
      }
    }
  }

 private:
  static constexpr std::uint32_t handful = 6;

  static void test_one_by_one(std::span<const Proxy> proxies, std::vector<Pair>& pairs) {
    for (std::uint32_t i = 0; i < proxies.size(); ++i) {
      for (std::uint32_t j = i + 1; j < proxies.size(); ++j) {
        const Proxy& a = proxies[i];
        const Proxy& b = proxies[j];
        if (may_collide(a, b) && within_reach(a, b)) pairs.push_back({i, j});
      }
    }
  }

  BoundsTable bounds_;
};

/// Chooses a method anew at each call, from the proxies alone. Brute force for few; otherwise grid or tree, whichever
/// is cheaper by these measured costs. Grid: 20 ns for each proxy, and for each large one .15 ns for every proxy it is
/// tested against or 10 ns for every row of cells it covers. Tree: 15 ns for each proxy, which it remembers, and 110 ns
/// more for each that moves.
class Auto : public BroadPhase {
 public:
  void find_pairs(std::span<const Proxy> proxies, std::vector<Pair>& pairs) override {
    choose(proxies).find_pairs(proxies, pairs);
  }
  void find_pairs_of(std::span<const Proxy> proxies, std::span<const std::uint8_t> chosen,
                     std::vector<Pair>& pairs) override {
    choose(proxies).find_pairs_of(proxies, chosen, pairs);
  }

 private:
  static double grid_cost(const Proxy& large, double typical, double count) {
    const double height = static_cast<double>(large.bounds.high.y) - static_cast<double>(large.bounds.low.y);
    const double by_rows = 10 * (height / typical + 3);
    const double by_all = .15 * count;
    return by_rows < by_all ? by_rows : by_all;
  }

  BroadPhase& choose(std::span<const Proxy> proxies) {
    if (proxies.size() <= few) return brute_;
    const double typical = typical_extent(proxies);
    const auto count = static_cast<double>(proxies.size());
    double by_grid = 20 * count;
    double by_tree = 15 * count;
    for (const Proxy& proxy : proxies) {
      if (is_large(proxy, typical)) by_grid += grid_cost(proxy, typical, count);
      if (proxy.moves) by_tree += 110;
    }
    return by_grid < by_tree ? made(grid_, "grid") : made(tree_, "tree");
  }

  static constexpr std::size_t few = 192;

  // Made on first use: the list of methods may be incomplete before main.
  static BroadPhase& made(std::unique_ptr<BroadPhase>& method, std::string_view name) {
    if (!method) method = MethodList<BroadPhase>::make(name);
    return *method;
  }

  Brute brute_;
  std::unique_ptr<BroadPhase> grid_, tree_;
};

const MethodList<BroadPhase>::Entry brute_entry{{"brute", "tests every pair of bounds: best for up to some 200 bodies",
                                                 "the article's broad phase, each pair once"},
                                                [] { return std::make_unique<Brute>(); }};

const MethodList<BroadPhase>::Entry auto_entry{
    {"auto", "brute, grid or tree, by the number and the sizes of the bodies", "measured, see benchmarks"},
    [] { return std::make_unique<Auto>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
