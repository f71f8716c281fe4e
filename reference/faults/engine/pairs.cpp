// Broad phases that find too few pairs, or too many.

#include <algorithm>
#include <cmath>

#include "reference/faults/engine/faulty.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// What a right one finds, tampered with.
class SpoiltPairs : public BroadPhase {
 public:
  void find_pairs(std::span<const Proxy> proxies, std::vector<Pair>& pairs) final {
    if (!right_) right_ = MethodList<BroadPhase>::make("brute");
    right_->find_pairs(proxies, pairs);
    spoil(proxies, pairs);
  }

 private:
  virtual void spoil(std::span<const Proxy> proxies, std::vector<Pair>& pairs) = 0;
  std::unique_ptr<BroadPhase> right_;
};

/// A grid that enters a body only in the cell of its lower left corner. What is larger than a cell is kept apart, as
/// grids do, and found.
class CellBorders : public SpoiltPairs {
  static constexpr Real cell = 2;  // m

  static bool large(const Proxy& one) { return !(one.bounds.high.x - one.bounds.low.x <= cell); }
  static bool same_cell(const Proxy& a, const Proxy& b) {
    return std::floor(a.bounds.low.x / cell) == std::floor(b.bounds.low.x / cell) &&
           std::floor(a.bounds.low.y / cell) == std::floor(b.bounds.low.y / cell);
  }
  void spoil(std::span<const Proxy> proxies, std::vector<Pair>& pairs) override {
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
     .spoils = "auto"},
    [] { return std::make_unique<CellBorders>(); }};

/// Sort and unique as printed: what is found from either side stays.
class Doubled : public SpoiltPairs {
  void spoil(std::span<const Proxy>, std::vector<Pair>& pairs) override {
    const std::vector<Pair> once = pairs;
    pairs.insert(pairs.end(), once.begin(), once.end());
    std::sort(pairs.begin(), pairs.end());
  }
};
const Faulty<BroadPhase> doubled{
    {.name = "pairs-doubled", .about = "pairs found twice are kept", .source = "row 14", .spoils = "auto"},
    [] { return std::make_unique<Doubled>(); }};

/// The last body of all is left out, as by a loop that ends one too early.
class LastLeftOut : public SpoiltPairs {
  void spoil(std::span<const Proxy> proxies, std::vector<Pair>& pairs) override {
    std::erase_if(pairs, [&](const Pair& pair) { return pair.second + 1 == proxies.size() && pair.first > 0; });
  }
};
const Faulty<BroadPhase> last_left_out{
    {.name = "pairs-of-last-lost", .about = "the last body meets the first alone", .spoils = "auto"},
    [] { return std::make_unique<LastLeftOut>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
