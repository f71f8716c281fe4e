#include "shapes/hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "../random_shapes.h"
#include "../real_literal.h"

namespace impulse::hull_test {
namespace {

TEST(ConvexHull, TurnsLeftEverywhereAndContainsAllPoints) {
  RandomShapes random(1);
  constexpr Real rounding = 16 * std::numeric_limits<Real>::epsilon();
  for (int round = 0; round < 500; ++round) {
    std::vector<Vec2> points = random.points(20, 1);
    for (std::size_t i = 1; i < 10; ++i) points[i] = (points[i + 10] + points[0]) / 2;
    const std::vector<Vec2> hull = convex_hull(points);
    ASSERT_GE(hull.size(), 3U);
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Vec2 a = hull[i];
      const Vec2 b = hull[(i + 1) % hull.size()];
      const Vec2 c = hull[(i + 2) % hull.size()];
      ASSERT_GT(cross(b - a, c - b), 0);
      for (const Vec2 p : points) ASSERT_GE(cross(normalized(b - a), p - a), -rounding);
    }
  }
}

TEST(ConvexHull, DoesNotDependOnTheOrderOfThePoints) {
  RandomShapes random(2);
  std::vector<Vec2> points = random.points(30, 1);
  const std::vector<Vec2> hull = convex_hull(points);
  std::reverse(points.begin(), points.end());
  EXPECT_EQ(convex_hull(points), hull);
}

TEST(ConvexHull, OmitsCornersThatAreOnlyRounding) {
  std::vector<Vec2> points(64);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Real part = static_cast<Real>(i) / 64;
    const bool on_edge = i % 2 == 0;
    points[i] = on_edge ? Vec2{3 * part, -std::numeric_limits<Real>::epsilon()} : Vec2{3 * part, part};
  }
  points.insert(points.end(), {{0, 0}, {3, 0}, {3, 1}, {0, 1}});
  EXPECT_EQ(convex_hull(points).size(), 4U);
}

TEST(Width, IsTheLeastBetweenParallelLines) {
  const std::vector<Vec2> box{{0, 0}, {5, 0}, {5, 2}, {0, 2}};
  EXPECT_EQ(width(box), 2);
  EXPECT_EQ(diameter(std::vector<Vec2>{{0, 0}, {3, 4}, {1, 1}}), 5);
}

}  // namespace
}  // namespace impulse::hull_test
