#include "broad_phase/aabb_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "../random_shapes.h"
#include "../real_literal.h"

namespace impulse::aabb_tree_test {
namespace {

using ItemPairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

ItemPairs pairs_in(AabbTree& tree) {
  ItemPairs pairs;
  tree.visit_pairs([&](std::uint32_t a, std::uint32_t b) {
    EXPECT_TRUE(pairs.insert({std::min(a, b), std::max(a, b)}).second) << "visited twice";
  });
  return pairs;
}

Aabb unit_at(Vec2 p) { return {p, p + Vec2{1, 1}}; }

TEST(AabbTree, VisitsEachOverlappingPairOnceThroughoutItsLife) {
  RandomShapes random(1);
  AabbTree tree;
  std::vector<std::uint32_t> leaves;
  for (std::uint32_t round = 0; round < 400; ++round) {
    if (leaves.size() > 100 || (!leaves.empty() && random.number(0, 1) < 0.3_r)) {
      const auto victim = static_cast<std::size_t>(random.number(0, static_cast<double>(leaves.size()) - 0.01));
      tree.remove(leaves[victim]);
      leaves.erase(leaves.begin() + static_cast<std::ptrdiff_t>(victim));
    } else {
      leaves.push_back(tree.insert(unit_at(random.point(5)), round, round % 4 != 0));
    }
    ItemPairs expected;
    for (const std::uint32_t a : leaves) {
      for (const std::uint32_t b : leaves) {
        const bool moves = tree.item(a) % 4 != 0 || tree.item(b) % 4 != 0;
        if (tree.item(a) < tree.item(b) && moves && overlap(tree.bounds(a), tree.bounds(b))) {
          expected.insert({tree.item(a), tree.item(b)});
        }
      }
    }
    ASSERT_EQ(pairs_in(tree), expected) << round;
  }
}

// Sorted input is the worst case without rotations: the tree would become a list of 4096.
TEST(AabbTree, StaysShortForAnyOrderOfInsertion) {
  AabbTree tree;
  for (int i = 0; i < 4096; ++i) tree.insert(unit_at({2 * static_cast<Real>(i), 0}), 0, true);
  EXPECT_LE(tree.height(), 4 * 12);
}

TEST(AabbTree, CanBeEmptiedAndFilledAgain) {
  AabbTree tree;
  EXPECT_TRUE(pairs_in(tree).empty());
  const std::uint32_t leaf = tree.insert(unit_at({0, 0}), 7, true);
  EXPECT_EQ(tree.height(), 1);
  tree.remove(leaf);
  EXPECT_EQ(tree.height(), 0);
  tree.insert(unit_at({0, 0}), 1, true);
  tree.insert(unit_at({0.5_r, 0}), 2, true);
  EXPECT_EQ(pairs_in(tree).size(), 1U);
}

}  // namespace
}  // namespace impulse::aabb_tree_test
