#include <algorithm>

#include "broad_phase/broad_phase.h"
#include "broad_phase/proxy_sizes.h"
#include "core/method_list.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Chooses anew at each call, by the proxies alone. Brute force for few; else grid or tree, whichever costs less as far
/// as measured: the grid 20 ns for each proxy, and for each large one .15 ns for every proxy that it is tested against
/// or 10 ns for every row of cells that it covers; the tree 15 ns for each proxy, which it remembers, and 110 ns more
/// if it moves.
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
    if (proxies.size() <= few) return method(brute_, "brute");
    const double typical = typical_extent(proxies);
    const auto count = static_cast<double>(proxies.size());
    double by_grid = 20 * count;
    double by_tree = 15 * count;
    for (const Proxy& proxy : proxies) {
      if (is_large(proxy, typical)) by_grid += grid_cost(proxy, typical, count);
      if (proxy.moves) by_tree += 110;
    }
    return by_grid < by_tree ? method(grid_, "grid") : method(tree_, "tree");
  }

  static constexpr std::size_t few = 192;

  // Made when first needed: before main the list may not be complete.
  static BroadPhase& method(std::unique_ptr<BroadPhase>& slot, std::string_view name) {
    if (!slot) slot = MethodList<BroadPhase>::make(name);
    return *slot;
  }

  std::unique_ptr<BroadPhase> brute_, grid_, tree_;
};

const MethodList<BroadPhase>::Entry auto_entry{
    {"auto", "brute, grid or tree, by the number and the sizes of the bodies", "measured, see benchmarks"},
    [] { return std::make_unique<Auto>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
