#include <gtest/gtest.h>

#include "tests/scenarios/statement_of.h"

namespace plumb::stacks_test {
namespace {

using statement_of::Of;

// The top of ten boxes that has slid off to the side by half a box.
TEST(Stacking, StopsATowerThatLeansByHalfABox) {
  EXPECT_LT((Of{"stacking", {}, "box 10", Quantity::x}.allows_at_most()), 0.5);
}

TEST(Stacking, GrantsNoCreepOnLevelGround) {
  Stepping stated = statement_of::skinned();
  const Of x{"stacking", {}, "box 10", Quantity::x};
  const double before = x.allows(stated);
  stated.creep = 0.17;
  EXPECT_EQ(x.allows(stated), before);
}

// A skin moves boxes apart; it does not tilt them.
TEST(Stacking, TakesTheTiltFromTheSlopAlone) {
  Stepping stated = statement_of::skinned();
  const Of angle{"stacking", {}, "box 10", Quantity::angle};
  const double before = angle.allows(stated);
  stated.skin = 1;
  EXPECT_EQ(angle.allows(stated), before);
}

TEST(Arch, StopsACrownThatHasComeDownByItsThickness) {
  EXPECT_LT((Of{"arch", {}, "stone 10", Quantity::y}.allows_at_most()), 1.2 / 2);
}

// Items that hang where they started, with no force on them: 1.17 m/s after .117 s.
TEST(Tumbler, StopsItemsThatDoNotFallAndItemsOutsideTheDrum) {
  const Of falls{"tumbler", {}, "item 1", Quantity::vy};
  EXPECT_LT(*falls.expectations().front().expected, -1);
  EXPECT_LT(falls.allows_at_most(), 0.01);
  EXPECT_LT((Of{"tumbler", {}, "item 1", Quantity::x}.allows_at_most()), 0.03);
}

}  // namespace
}  // namespace plumb::stacks_test
