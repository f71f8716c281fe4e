#include <gtest/gtest.h>

#include "tests/scenarios/statement_of.h"

namespace plumb::classical_test {
namespace {

using statement_of::Of;

Scene scene_of(const char* name) {
  const Scenario& family = *Catalog<Scenario>::find(name);
  return family.scene(complete(family, {}));
}

TEST(TowerRow, HasATowerOfEachHeight) {
  EXPECT_EQ(scene_of("tower-row").bodies.size(), 1u + 18 * 19 / 2);
  EXPECT_EQ(*Of({"tower-row", {}, "box 18 of 18", Quantity::y}).expectations().front().expected, 17.5 * 0.5);
}

// A tower that falls lies on the ground.
TEST(TowerRow, StopsATowerThatFalls) {
  EXPECT_LT((Of{"tower-row", {}, "box 18 of 18", Quantity::y}.allows_at_most()), 17.5 * 0.5 / 10);
  EXPECT_LT((Of{"tower-row", {}, "box 1 of 1", Quantity::y}.allows_at_most()), 0.25);
}

// Each box starts above the one below it, and all gaps close.
TEST(SettlingTower, ClosesEveryGap) {
  const Scene scene = scene_of("settling-tower");
  for (int k = 1; k <= 10; ++k) {
    const std::string name = "box " + std::to_string(k);
    const double rests = *Of({"settling-tower", {}, name, Quantity::y}).expectations().front().expected;
    EXPECT_NEAR(scene.bodies[static_cast<std::size_t>(k)].position.y - rests, k * 0.02, 1e-12);
  }
}

// Boxes that keep bouncing do so with up to sqrt(2 g k gap).
TEST(SettlingTower, StopsBoxesThatBounceOrHang) {
  EXPECT_LT((Of{"settling-tower", {}, "box 10", Quantity::speed}.allows_at_most()), 0.2);
  EXPECT_LT((Of{"settling-tower", {}, "box 1", Quantity::y}.allows(statement_of::accurate())), 0.02 / 10);
}

}  // namespace
}  // namespace plumb::classical_test
