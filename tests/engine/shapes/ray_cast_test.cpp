#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../random_shapes.h"
#include "../real_literal.h"
#include "impulse/shape.h"
#include "shapes/distance.h"

namespace impulse::ray_cast_test {
namespace {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

void expect_hit(const Shape& shape, Vec2 from, Vec2 to, Real fraction, Vec2 normal) {
  RayHit hit;
  ASSERT_TRUE(ray_cast(shape, from, to, hit));
  EXPECT_NEAR(hit.fraction, fraction, 4 * epsilon);
  EXPECT_NEAR(hit.normal.x, normal.x, 4 * epsilon);
  EXPECT_NEAR(hit.normal.y, normal.y, 4 * epsilon);
  EXPECT_NEAR(length(hit.point - (from + hit.fraction * (to - from))), 0, 4 * epsilon);
}

void expect_miss(const Shape& shape, Vec2 from, Vec2 to) {
  RayHit hit{0.5_r, {1, 2}, {3, 4}};
  EXPECT_FALSE(ray_cast(shape, from, to, hit));
  EXPECT_EQ(hit.point, (Vec2{1, 2})) << "a miss must not change the hit";
}

TEST(RayCast, EntersEachShapeAtItsSurface) {
  expect_hit(Shape::circle(1, {0, 1}), {-3, 1}, {1, 1}, 0.5_r, {-1, 0});
  expect_hit(Shape::box({1, 1}), {0, 5}, {0, -3}, 0.5_r, {0, 1});
  const std::vector<Vec2> triangle{{0, 0}, {2, 0}, {0, 2}};
  expect_hit(Shape::polygon(triangle), {2, 2}, {0, 0}, 0.5_r, {std::sqrt(0.5_r), std::sqrt(0.5_r)});
  expect_hit(Shape::capsule({-1, 0}, {1, 0}, 0.5_r), {0.5_r, 2.5_r}, {0.5_r, -1.5_r}, 0.5_r, {0, 1});
  expect_hit(Shape::capsule({-1, 0}, {1, 0}, 0.5_r), {3, 0}, {0, 0}, 0.5_r, {1, 0});
  expect_hit(Shape::half_space({0, 1}, 1), {0, 3}, {4, -1}, 0.5_r, {0, 1});
}

TEST(RayCast, MissesShapesBesideItBehindItOrTooFarAway) {
  const Shape disc = Shape::circle(1);
  expect_miss(disc, {-3, 1.01_r}, {3, 1.01_r});
  expect_miss(disc, {3, 0}, {5, 0});
  expect_miss(disc, {-3, 0}, {-1.01_r, 0});
  const Shape box = Shape::box({1, 1});
  expect_miss(box, {-3, 1.01_r}, {3, 1.01_r});
  expect_miss(box, {3, 0}, {5, 0});
  expect_miss(box, {-3, 0}, {-1.01_r, 0});
  expect_miss(box, {-3, 0}, {-3, 0});
  expect_miss(Shape::half_space({0, 1}, 1), {0, 2}, {3, 2});
}

TEST(RayCast, FindsNothingFromInside) {
  expect_miss(Shape::circle(1), {0.5_r, 0}, {3, 0});
  expect_miss(Shape::box({1, 1}), {0.5_r, 0}, {3, 0});
  expect_miss(Shape::capsule({-1, 0}, {1, 0}, 0.5_r), {1.2_r, 0}, {-3, 0});
  expect_miss(Shape::half_space({0, 1}, 1), {0, 0}, {0, -3});
}

TEST(RayCast, HitsASegmentFromBothSidesButAChainFromItsFreeSideOnly) {
  const Shape segment = Shape::segment({1, 0}, {-1, 0});
  expect_hit(segment, {0, 1}, {0, -1}, 0.5_r, {0, 1});
  expect_hit(segment, {0, -1}, {0, 1}, 0.5_r, {0, -1});
  expect_miss(segment, {1.01_r, 1}, {1.01_r, -1});
  const std::vector<Vec2> points{{1, 0}, {-1, 0}};
  const Shape link = Shape::chain(points, false)[0];
  expect_hit(link, {0, 1}, {0, -1}, 0.5_r, {0, 1});
  expect_miss(link, {0, -1}, {0, 1});
}

// The hit lies on the surface, the ray is outside before it, and a ray that misses stays outside.
TEST(RayCast, AgreesWithContainsAlongRandomRays) {
  RandomShapes random(1);
  int hits = 0;
  for (int i = 0; i < 6000; ++i) {
    const Shape shape = random.shape(all_shape_types[static_cast<std::size_t>(i) % 6]);
    const Vec2 from = random.point(3);
    const Vec2 to = random.point(3);
    if (shape.contains(from)) continue;
    RayHit hit;
    const bool found = ray_cast(shape, from, to, hit);
    hits += found ? 1 : 0;
    const Real until = found ? hit.fraction - 1e-4_r : 1;
    for (int k = 0; k <= 50; ++k) {
      const Vec2 p = from + until * static_cast<Real>(k) / 50 * (to - from);
      ASSERT_FALSE(shape.contains(p)) << i;
    }
    if (!found) continue;
    EXPECT_LT(dot(hit.normal, to - from), 0);
    EXPECT_NEAR(length(hit.normal), 1, 8 * epsilon);
    const Gap gap = distance(shape, {}, Shape::circle(1e-3_r), {hit.point + 2e-3_r * hit.normal, {}});
    EXPECT_NEAR(gap.distance, 1e-3_r, 64 * epsilon) << i;
  }
  EXPECT_GT(hits, 1000);
}

TEST(RayCast, IsPreciseFromFarAway) {
  RayHit hit;
  ASSERT_TRUE(ray_cast(Shape::circle(1), {-1000, 0.5_r}, {1000, 0.5_r}, hit));
  EXPECT_NEAR(hit.point.x, -std::sqrt(0.75_r), 1000 * epsilon);  // the rounding error of 1000
}

}  // namespace
}  // namespace impulse::ray_cast_test
