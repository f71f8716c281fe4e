#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenarios/statement_of.h"

namespace plumb::line_test {
namespace {

using statement_of::Of;

// Equal masses swap velocities: after three impacts the heavy block flies off as fast as it came and the light one
// rests.
TEST(PiBilliard, CountsTheImpactsOfEqualBlocks) {
  const Of heavy{"pi-billiard", {{"digits", 0}}, "heavy", Quantity::vx};
  const Of light{"pi-billiard", {{"digits", 0}}, "light", Quantity::vx};
  EXPECT_NEAR(*heavy.expectations().front().expected, 2, 1e-12);
  EXPECT_NEAR(*light.expectations().front().expected, 0, 1e-12);
  // After two impacts they have 0 and 2. What was once allowed: a heavy block that has lost a fifth of its energy.
  EXPECT_LT(heavy.allows_at_most(), 2 - 1.797);
  EXPECT_LT(heavy.allows_at_most(), 2 - 2 * std::sqrt(0.99));
}

// One impact more or less turns the state by 2 q or changes the light block's sign.
TEST(PiBilliard, TellsThirtyOneImpactsFromThirtyIfTheyComeOneByOne) {
  const Stepping stated = statement_of::accurate();
  const Of heavy{"pi-billiard", {{"digits", 1}}, "heavy", Quantity::vx};
  const Of light{"pi-billiard", {{"digits", 1}}, "light", Quantity::vx};
  EXPECT_LT(heavy.allows(stated), 1e-6);
  EXPECT_LT(light.allows(stated), 1e-6);
  EXPECT_GT(std::abs(*light.expectations().front().expected), 0.1);
}

TEST(PiBilliard, AllowsAMethodThatMayMissACountNoMoreThanTheLastSector) {
  const Of heavy{"pi-billiard", {{"digits", 1}}, "heavy", Quantity::vx};
  EXPECT_LT(heavy.allows(statement_of::skinned()), 0.01);
}

// e = .9 instead of 1: 4 m/s of approach, of which three quarters change the left disc.
TEST(HeadOn, StopsATenthLessRestitution) {
  EXPECT_LT((Of{"head-on", {{"restitution", 1}}, "left", Quantity::vx}.allows_at_most()), 0.1 * 4 * 0.75 / 100);
}

// Discs that stay where they meet would be off by twice this.
TEST(HeadOn, StopsDiscsThatPassThroughEachOther) {
  EXPECT_LT((Of{"head-on", {}, "left", Quantity::x}.allows_at_most()), 1.5 * 4 * 0.75 / 10);
}

}  // namespace
}  // namespace plumb::line_test
