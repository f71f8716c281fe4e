#include <algorithm>

#include "broad_phase.h"
#include "method_list.h"
#include "proxy_sizes.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Chooses anew at each call, by the proxies alone. Brute force for few; else grid or tree, whichever costs less as far
/// as measured: the grid 20 ns for each proxy and .15 ns more for each large one that it is tested against; the tree
/// 15 ns for each proxy, which it remembers, and 110 ns more if it moves.
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
  BroadPhase& choose(std::span<const Proxy> proxies) {
    if (proxies.size() <= few) return method(brute_, "brute");
    const double typical = typical_extent(proxies);
    const auto large = static_cast<std::size_t>(std::count_if(
        proxies.begin(), proxies.end(), [typical](const Proxy& proxy) { return is_large(proxy, typical); }));
    const auto movers = static_cast<std::size_t>(
        std::count_if(proxies.begin(), proxies.end(), [](const Proxy& proxy) { return proxy.moves; }));
    return proxies.size() * (33 + large) < 730 * movers ? method(grid_, "grid") : method(tree_, "tree");
  }

  static constexpr std::size_t few = 192;

  // Made when first needed: before main the list may not be complete.
  static BroadPhase& method(std::unique_ptr<BroadPhase>& slot, std::string_view name) {
    if (!slot) slot = MethodList<BroadPhase>::make(name);
    return *slot;
  }

  std::unique_ptr<BroadPhase> brute_, grid_, tree_;
};

const MethodList<BroadPhase>::Entry entry{
    {"auto", "brute, grid or tree, by the number and the sizes of the bodies", "measured, see benchmarks"},
    [] { return std::make_unique<Auto>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
