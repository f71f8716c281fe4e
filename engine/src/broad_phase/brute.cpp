#include "broad_phase/bounds_table.h"
#include "broad_phase/broad_phase.h"
#include "core/method_list.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

// Every proxy against every later one: nothing to keep, nothing to build, and the pairs come out sorted. Many at a
// time, unless they are a handful, which cost less than the laying out.
class Brute : public BroadPhase {
 public:
  void find_pairs(std::span<const Proxy> proxies, std::vector<Pair>& pairs) override {
    pairs.clear();
    const auto count = static_cast<std::uint32_t>(proxies.size());
    if (count <= handful) return meet_one_by_one(proxies, pairs);
    bounds_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) bounds_.set(i, proxies[i].bounds, proxies[i].way);
    for (std::uint32_t i = 0; i < count; ++i) {
      for (const std::uint32_t j : bounds_.within_reach(proxies[i].bounds, proxies[i].way, {{i + 1, count}})) {
        if (may_collide(proxies[i], proxies[j])) pairs.push_back({i, j});
      }
    }
  }

 private:
  static constexpr std::uint32_t handful = 6;

  static void meet_one_by_one(std::span<const Proxy> proxies, std::vector<Pair>& pairs) {
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

const MethodList<BroadPhase>::Entry brute_entry{{"brute", "tests every pair of bounds: best for up to some 200 bodies",
                                                 "the article's broad phase, each pair once"},
                                                [] { return std::make_unique<Brute>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
