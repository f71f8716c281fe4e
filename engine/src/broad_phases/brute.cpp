#include "broad_phase.h"
#include "method_list.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

// Every proxy against every later one: nothing to keep, nothing to build, and the pairs come out sorted.
class Brute : public BroadPhase {
 public:
  void find_pairs(std::span<const Proxy> proxies, std::vector<Pair>& pairs) override {
    pairs.clear();
    const auto count = static_cast<std::uint32_t>(proxies.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      for (std::uint32_t j = i + 1; j < count; ++j) {
        if (overlap(proxies[i].bounds, proxies[j].bounds) && may_collide(proxies[i], proxies[j])) {
          pairs.push_back({i, j});
        }
      }
    }
  }
};

const MethodList<BroadPhase>::Entry entry{
    {"brute", "tests every pair of bounds: best for a few dozen bodies", "the article's broad phase, each pair once"},
    [] { return std::make_unique<Brute>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
