#include <algorithm>

#include "broad_phase/aabb_tree.h"
#include "broad_phase/broad_phase.h"
#include "broad_phase/pair_order.h"
#include "core/method_list.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

// NaN bounds overlap nothing, but would corrupt every box above them.
constexpr bool ordered(const Aabb& box) { return box.low.x <= box.high.x && box.low.y <= box.high.y; }

/// A dynamic tree of boxes that is kept from call to call. Its leaves are fat AABBs, so that a proxy that moves a
/// little can stay where it is.
class Tree : public BroadPhase {
 public:
  void find_pairs(std::span<const Proxy> proxies, std::vector<Pair>& pairs) override {
    pairs.clear();
    update(proxies);
    tree_.visit_pairs([&](std::uint32_t a, std::uint32_t b) {
      if (within_reach(proxies[a], proxies[b]) && may_collide(proxies[a], proxies[b])) {
        pairs.push_back({std::min(a, b), std::max(a, b)});
      }
    });
    order_.sort(proxies.size(), pairs);
  }

 private:
  // A proxy as the tree knows it.
  struct Known {
    std::uint32_t body = 0;
    std::uint16_t part = 0;
    bool moves = false;
    std::uint32_t leaf = 0;
  };

  static bool same(const Known& known, const Proxy& proxy) {
    return known.body == proxy.body && known.part == proxy.part && known.moves == proxy.moves;
  }

  // Both lists are sorted by (body, part), so one pass over both finds the proxies that are new or gone. All removals
  // come before all insertions, which keeps the tree balanced.
  void update(std::span<const Proxy> proxies) {
    next_.clear();
    std::size_t old = 0;
    for (std::uint32_t i = 0; i < proxies.size(); ++i) {
      while (old < known_.size() && before(known_[old], proxies[i])) forget(known_[old++]);
      std::uint32_t leaf = AabbTree::none;
      if (old < known_.size() && !after(known_[old], proxies[i])) {
        leaf = keep_or_remove(known_[old++], proxies[i], i);
      }
      next_.push_back({proxies[i].body, proxies[i].part, proxies[i].moves, leaf});
    }
    while (old < known_.size()) forget(known_[old++]);
    for (std::uint32_t i = 0; i < proxies.size(); ++i) {
      if (next_[i].leaf == AabbTree::none && ordered(proxies[i].bounds))
        next_[i].leaf = tree_.insert(fat(proxies[i]), i, proxies[i].moves);
    }
    known_.swap(next_);
  }

  static bool before(const Known& known, const Proxy& proxy) {
    return known.body != proxy.body ? known.body < proxy.body : known.part < proxy.part;
  }
  static bool after(const Known& known, const Proxy& proxy) {
    return known.body != proxy.body ? known.body > proxy.body : known.part > proxy.part;
  }

  std::uint32_t keep_or_remove(const Known& known, const Proxy& proxy, std::uint32_t index) {
    if (known.leaf != AabbTree::none && same(known, proxy) && within(proxy.bounds, tree_.bounds(known.leaf)) &&
        !loose(proxy, known)) {
      tree_.set_item(known.leaf, index);
      return known.leaf;
    }
    forget(known);
    return AabbTree::none;
  }

  void forget(const Known& known) {
    if (known.leaf != AabbTree::none) tree_.remove(known.leaf);
  }

  // A tenth of the mean side on every side: of the order of what a body moves in a few steps.
  static Aabb fat(const Proxy& proxy) {
    const Vec2 size = proxy.bounds.high - proxy.bounds.low;
    return grown(proxy.bounds, proxy.moves ? (size.x + size.y) / 20 : 0);
  }

  // Whether the bounds have shrunk so much that the fat ones overlap too many others.
  bool loose(const Proxy& proxy, const Known& known) const {
    const Vec2 size = proxy.bounds.high - proxy.bounds.low;
    const Aabb& held = tree_.bounds(known.leaf);
    const Vec2 fat_size = held.high - held.low;
    return fat_size.x + fat_size.y > 2 * (size.x + size.y);
  }

  AabbTree tree_;
  std::vector<Known> known_;
  std::vector<Known> next_;
  PairOrder order_;
};

const MethodList<BroadPhase>::Entry tree_entry{
    {"tree", "dynamic tree of bounding boxes: best for many bodies of mixed size",
     "Catto, Dynamic Bounding Volume Hierarchies, GDC 2019"},
    [] { return std::make_unique<Tree>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
