#include "reports/judge/contact_region.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scenarios/scene/vec.h"

namespace plumb::contact_region_test {
namespace {

const Outline box{.points = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
const Outline ground{.halfspace = HalfSpace{{0, 1}, -1}};

Interval across(const std::vector<Vec>& region, Vec direction) { return *range_along(direction, {.points = region}); }

TEST(RegionNear, IsTheStripOfABoxThatTheGroundMayReach) {
  const Interval high = across(region_near(box, ground, 0.1), {0, 1});
  EXPECT_DOUBLE_EQ(high.low, -1);
  EXPECT_DOUBLE_EQ(high.high, -0.9);
  EXPECT_TRUE(region_near(placed(box, {0, 5}, 0), ground, 0.1).empty());
}

TEST(RegionNear, HoldsEveryPointWithinReach) {
  const Outline other = placed(box, {1.5, 2.05}, 0.3);
  const std::vector<Vec> region = region_near(box, other, 0.2);
  ASSERT_FALSE(region.empty());
  for (double x = -1; x <= 1; x += 0.05) {
    for (double y = -1; y <= 1; y += 0.05) {
      if (gap_between({.points = {{x, y}}}, other) > 0.2) continue;
      EXPECT_LE(gap_between({.points = {{x, y}}}, {.points = region}), 1e-12) << x << ", " << y;
    }
  }
}

TEST(RegionNear, KeepsAPointWithinReachOnly) {
  const Outline point{.points = {{1.3, 0}}};
  EXPECT_EQ(region_near(point, box, 0.31).size(), 1u);
  EXPECT_TRUE(region_near(point, box, 0.29).empty());
}

TEST(IsFlatIn, AsksForACorner) {
  EXPECT_TRUE(is_flat_in(ground, {}));
  const Outline thin{.points = {{0, 1.2}}};
  EXPECT_TRUE(is_flat_in(box, region_near(box, thin, 0.3)));
  EXPECT_FALSE(is_flat_in(box, region_near(box, placed(thin, {0.9, 0}, 0), 0.3)));
}

TEST(DirectionTo, IsThatOfTheNearestPoints) {
  const Vec down = direction_to(placed(box, {0, 3}, 0), ground).value();
  EXPECT_EQ(down, (Vec{0, -1}));
  const Vec corner = direction_to({.points = {{4, 5}}}, box).value();
  EXPECT_NEAR(corner.x, -0.6, 1e-12);
  EXPECT_NEAR(corner.y, -0.8, 1e-12);
  EXPECT_FALSE(direction_to(box, placed(box, {1, 0}, 0)).has_value());
}

}  // namespace
}  // namespace plumb::contact_region_test
