// Broad phases that find too few pairs, or too many.

#include <algorithm>
#include <cmath>

#include "reference/faults/engine/faulty.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// The pairs of the right broad phase, changed.
class MutatedPairs : public BroadPhase {
 public:
  void find_pairs(std::span<const Proxy> proxies, std::vector<Pair>& pairs) final {
    if (!right_) right_ = MethodList<BroadPhase>::make("brute");
    right_->find_pairs(proxies, pairs);
    mutate(proxies, pairs);
  }

 private:
  virtual void mutate(std::span<const Proxy> proxies, std::vector<Pair>& pairs) = 0;
  std::unique_ptr<BroadPhase> right_;
};

/// A grid that enters a body only in the cell of its lower left corner. Bodies larger than a cell are kept separately,
/// as grids do, and found.
class CellBorders : public MutatedPairs {
  static constexpr Real cell = 2;  // m

  static bool large(const Proxy& one) { return !(one.bounds.high.x - one.bounds.low.x <= cell); }
  static bool same_cell(const Proxy& a, const Proxy& b) {
    return std::floor(a.bounds.low.x / cell) == std::floor(b.bounds.low.x / cell) &&
           std::floor(a.bounds.low.y / cell) == std::floor(b.bounds.low.y / cell);
  }
  void mutate(std::span<const Proxy> proxies, std::vector<Pair>& pairs) override {
    std::erase_if(pairs, [&](const Pair& pair) {
      const Proxy& a = proxies[pair.first];
      const Proxy& b = proxies[pair.second];
      return !large(a) && !large(b) && !same_cell(a, b);
    });
  }
};
const Faulty<BroadPhase> cell_borders{
    {.name = "pairs-lost-at-borders",
     .about = "a body is entered in one cell of the grid alone and missed across its border",
     .mutates = "auto"},
    [] { return std::make_unique<CellBorders>(); }};

/// Sort and unique as printed: pairs found from both sides stay.
class Doubled : public MutatedPairs {
  void mutate(std::span<const Proxy>, std::vector<Pair>& pairs) override {
    const std::vector<Pair> once = pairs;
    pairs.insert(pairs.end(), once.begin(), once.end());
    std::sort(pairs.begin(), pairs.end());
  }
};
const Faulty<BroadPhase> doubled{{.name = "pairs-doubled",
                                  .about = "pairs found twice are kept",
                                  .source = "the article, part 2",
                                  .mutates = "auto"},
                                 [] { return std::make_unique<Doubled>(); }};

/// The last body is left out, as by a loop that ends one too early.
class LastLeftOut : public MutatedPairs {
  void mutate(std::span<const Proxy> proxies, std::vector<Pair>& pairs) override {
    std::erase_if(pairs, [&](const Pair& pair) { return pair.second + 1 == proxies.size() && pair.first > 0; });
  }
};
const Faulty<BroadPhase> last_left_out{
    {.name = "pairs-of-last-lost", .about = "the last body meets the first alone", .mutates = "auto"},
    [] { return std::make_unique<LastLeftOut>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
