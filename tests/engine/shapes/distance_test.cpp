#include "shapes/distance.h"

#include <gtest/gtest.h>

#include <limits>

#include "../random_shapes.h"
#include "../real_literal.h"
#include "narrow_phase/collide.h"

namespace impulse::distance_test {
namespace {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
constexpr Pose origin{};

TEST(Distance, OfSimpleCasesIsTheGeometricOne) {
  const Shape disc = Shape::circle(1);
  const Shape box = Shape::box({1, 1});
  const Shape rod = Shape::capsule({-1, 0}, {1, 0}, 0.5_r);
  EXPECT_EQ(distance(disc, origin, disc, {{3, 4}, {}}).distance, 3);
  EXPECT_EQ(distance(box, origin, box, {{5, 6}, {}}).distance, 5);
  EXPECT_EQ(distance(box, origin, box, {{0, 2.5_r}, {}}).distance, 0.5_r);
  EXPECT_EQ(distance(rod, origin, rod, {{5, 4}, {}}).distance, 4);
  EXPECT_EQ(distance(Shape::half_space({0, 2}, 2), origin, disc, {{7, 4}, {}}).distance, 2);
  EXPECT_EQ(distance(disc, {{7, 4}, {}}, Shape::half_space({0, 2}, 2), origin).normal, (Vec2{0, -1}));
}

TEST(Distance, IsZeroIfShapesTouchCrossOrContainEachOther) {
  const Shape box = Shape::box({1, 1});
  const Shape rod = Shape::segment({-1, 0}, {1, 0});
  EXPECT_EQ(distance(box, origin, box, {{2, 0.5_r}, {}}).distance, 0);
  EXPECT_EQ(distance(box, origin, Shape::circle(0.1_r), origin).distance, 0);
  EXPECT_EQ(distance(rod, origin, rod, {{}, Rotation(pi / 2)}).distance, 0);
  EXPECT_EQ(distance(rod, origin, rod, {{2, 0}, {}}).distance, 0);
  EXPECT_EQ(distance(rod, origin, rod, {{2.5_r, 0}, {}}).distance, 0.5_r);  // collinear
  EXPECT_EQ(distance(rod, origin, rod, {{0, 1}, {}}).distance, 1);
}

// collide() computes the same distance by another algorithm, in which faces count as parallel up to 1/128 rad.
TEST(Distance, AgreesWithTheSeparationOfManifolds) {
  RandomShapes random(1);
  int apart = 0;
  for (int i = 0; i < 20000; ++i) {
    const ShapeType type_a = all_shape_types[static_cast<std::size_t>(i) % 6];
    const ShapeType type_b = all_shape_types[static_cast<std::size_t>(i) / 6 % 6];
    if (type_a == type_b && (type_a == ShapeType::segment || type_a == ShapeType::half_space)) continue;
    const Shape a = random.shape(type_a);
    const Shape b = random.shape(type_b);
    const Pose pose_a = random.pose(2);
    const Pose pose_b = random.pose(2);
    const Manifold m = collide(a, pose_a, b, pose_b, 1e6_r);
    ASSERT_GT(m.count, 0) << i;
    Real least = m.points[0].separation;
    if (m.count == 2) least = std::min(least, m.points[1].separation);
    const Gap gap = distance(a, pose_a, b, pose_b);
    ASSERT_NEAR(gap.distance, std::max(least, Real{0}),
                100 * epsilon + 3.1e-5_r * (gap.distance + a.radius() + b.radius()))
        << i;
    apart += gap.distance > 0 ? 1 : 0;
  }
  EXPECT_GT(apart, 5000);
}

TEST(Distance, GivesTheNearestPointsAndTheDirectionBetweenThem) {
  RandomShapes random(2);
  for (int i = 0; i < 10000; ++i) {
    const Shape a = random.shape(all_shape_types[static_cast<std::size_t>(i) % 6]);
    const Shape b = random.shape(all_shape_types[static_cast<std::size_t>(i) / 6 % 5]);
    const Pose pose_a = random.pose(2);
    const Pose pose_b = random.pose(2);
    const Gap gap = distance(a, pose_a, b, pose_b);
    if (gap.distance == 0) continue;
    constexpr Real rounding = 64 * epsilon;
    ASSERT_NEAR(length(gap.normal), 1, rounding);
    ASSERT_NEAR(length(gap.b - gap.a), gap.distance, rounding);
    ASSERT_NEAR(dot(gap.b - gap.a, gap.normal), gap.distance, rounding);
    // A small step out of the surface leaves the shape; one into it enters the shape, unless that has no area.
    const Vec2 before = to_local(pose_a, gap.a + 100 * rounding * gap.normal);
    const Vec2 behind = to_local(pose_a, gap.a - 100 * rounding * gap.normal);
    ASSERT_FALSE(a.contains(before)) << i;
    if (a.type() == ShapeType::circle || a.type() == ShapeType::half_space) {
      ASSERT_TRUE(a.contains(behind)) << i;
    }
    const Gap reverse = distance(b, pose_b, a, pose_a);
    ASSERT_NEAR(reverse.distance, gap.distance, rounding);
  }
}

}  // namespace
}  // namespace impulse::distance_test
