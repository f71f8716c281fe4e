#include <algorithm>

#include "broad_phase.h"
#include "method_list.h"
#include "proxy_sizes.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Chooses anew at each call, by the proxies alone: brute force for few; the grid where no more than 8 + count / 64 of
/// them are large (each of those is tested against all); for some hundred of mixed sizes brute force again, unless most
/// stand still, which a tree remembers; else the tree.
class Auto : public BroadPhase {
 public:
  void find_pairs(std::span<const Proxy> proxies, std::vector<Pair>& pairs) override {
    choose(proxies).find_pairs(proxies, pairs);
  }

 private:
  BroadPhase& choose(std::span<const Proxy> proxies) {
    if (proxies.size() <= few) return method(brute_, "brute");
    const double typical = typical_extent(proxies);
    const auto large = static_cast<std::size_t>(std::count_if(
        proxies.begin(), proxies.end(), [typical](const Proxy& proxy) { return is_large(proxy, typical); }));
    if (large <= 8 + proxies.size() / 64) return method(grid_, "grid");
    const auto movers = static_cast<std::size_t>(
        std::count_if(proxies.begin(), proxies.end(), [](const Proxy& proxy) { return proxy.moves; }));
    const bool by_force = proxies.size() <= some && 2 * movers >= proxies.size();
    return by_force ? method(brute_, "brute") : method(tree_, "tree");
  }

  // Where the curves of cost cross: brute force against the grid (2 to 5 us), and against a tree of movers (80 us).
  static constexpr std::size_t few = 192;
  static constexpr std::size_t some = 768;

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
