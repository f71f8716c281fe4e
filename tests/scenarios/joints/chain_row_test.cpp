#include <gtest/gtest.h>

#include "tests/scenarios/statement_of.h"

namespace plumb::chain_row_test {
namespace {

using statement_of::Of;

TEST(ChainRow, HasAChainOfEachLength) {
  const Scenario& family = *Catalog<Scenario>::find("chain-row");
  const Scene scene = family.scene(complete(family, {}));
  EXPECT_EQ(scene.joints.size(), 55u);
  EXPECT_EQ(*Of({"chain-row", {}, "link 10 of 10", Quantity::y}).expectations().front().expected, -9.5 * 0.4);
  EXPECT_EQ(*Of({"chain-row", {}, "link 1 of 1", Quantity::y}).expectations().front().expected, -0.5 * 0.4);
}

// A link that is let go falls by 45 m.
TEST(ChainRow, StopsAChainThatBreaks) {
  EXPECT_LT((Of{"chain-row", {}, "link 10 of 10", Quantity::y}.allows_at_most()), 0.1);
}

// Box2D 3 lets the longest chain sag by 7.036 mm.
TEST(ChainRow, KnowsHowFarAChainOnSpringsSags) {
  const Of last{"chain-row", {}, "link 10 of 10", Quantity::y};
  Stepping stated = statement_of::soft();
  const double with = last.allows(stated);
  stated.joint_frequency = 0;
  EXPECT_NEAR(with - last.allows(stated), 0.007036, 1e-6);
}

}  // namespace
}  // namespace plumb::chain_row_test
