#include "impulse/shape.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "../random_shapes.h"
#include "../real_literal.h"

namespace impulse::shape_test {
namespace {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
constexpr Real inf = std::numeric_limits<Real>::infinity();

TEST(Shape, RejectsSizesThatAreNotPositiveAndFinite) {
  for (const Real bad : {0_r, -1_r, nan, inf}) {
    EXPECT_THROW(Shape::circle(bad), std::invalid_argument);
    EXPECT_THROW(Shape::box({bad, 1}), std::invalid_argument);
    EXPECT_THROW(Shape::box({1, bad}), std::invalid_argument);
    EXPECT_THROW(Shape::capsule({0, 0}, {1, 0}, bad), std::invalid_argument);
  }
  for (const Real bad : {nan, inf}) {
    EXPECT_THROW(Shape::circle(1, {bad, 0}), std::invalid_argument);
    EXPECT_THROW(Shape::box({1, 1}, {0, bad}), std::invalid_argument);
    EXPECT_THROW(Shape::box({1, 1}, {}, bad), std::invalid_argument);
    EXPECT_THROW(Shape::segment({0, 0}, {bad, 0}), std::invalid_argument);
    EXPECT_THROW(Shape::half_space({bad, 1}, 0), std::invalid_argument);
    EXPECT_THROW(Shape::half_space({0, 1}, bad), std::invalid_argument);
  }
  EXPECT_THROW(Shape::segment({1, 2}, {1, 2}), std::invalid_argument);
  EXPECT_THROW(Shape::capsule({1, 2}, {1, 2}, 1), std::invalid_argument);
  EXPECT_THROW(Shape::half_space({0, 0}, 1), std::invalid_argument);
}

TEST(Shape, NamesTheInvalidSize) {
  try {
    Shape::circle(-2);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("the radius of a circle must be positive and finite, not -2"));
  }
}

TEST(Polygon, IsTheConvexHullOfItsPointsInAnyOrder) {
  const std::vector<Vec2> points{{1, 1}, {0.5_r, 0.5_r}, {0, 0}, {1, 0}, {0.5_r, 0}, {0, 1}, {1, 1}};
  const Shape square = Shape::polygon(points);
  ASSERT_EQ(square.count(), 4);
  const std::vector<Vec2> outline{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<Vec2> normals{{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(square.vertex(i), outline[static_cast<std::size_t>(i)]);
    EXPECT_EQ(square.normal(i), normals[static_cast<std::size_t>(i)]);
  }
  EXPECT_EQ(square.centroid(), (Vec2{0.5_r, 0.5_r}));
}

TEST(Polygon, RejectsPointsWithoutArea) {
  const auto polygon = [](std::vector<Vec2> points) { return Shape::polygon(points); };
  EXPECT_THROW(polygon({}), std::invalid_argument);
  EXPECT_THROW(polygon({{0, 0}, {1, 0}}), std::invalid_argument);
  EXPECT_THROW(polygon({{0, 0}, {1, 0}, {0, 0}}), std::invalid_argument);
  EXPECT_THROW(polygon({{0, 0}, {1, 1}, {2, 2}, {5, 5}}), std::invalid_argument);
  EXPECT_THROW(polygon({{0, 0}, {1000, 0}, {500, 0.5_r}}), std::invalid_argument);
  EXPECT_THROW(polygon({{0, 0}, {1, 0}, {nan, 1}}), std::invalid_argument);
  EXPECT_NO_THROW(polygon({{0, 0}, {1000, 0}, {500, 2}}));
}

TEST(Polygon, HasAtMostEightVertices) {
  std::vector<Vec2> points = ring(9, 1);
  EXPECT_THROW(Shape::polygon(points), std::invalid_argument);
  points.pop_back();
  EXPECT_EQ(Shape::polygon(points).count(), 8);
}

// The sign of a x + b y + c is exact, even if normalizing the normal would round it.
TEST(HalfSpace, ContainsExactlyWhereItsEquationIsNotPositive) {
  for (int a = -3; a <= 3; ++a) {
    for (int b = -3; b <= 3; ++b) {
      if (a == 0 && b == 0) continue;
      for (int c = -4; c <= 4; ++c) {
        const Shape shape = Shape::half_space({static_cast<Real>(a), static_cast<Real>(b)}, static_cast<Real>(-c));
        for (int x = -5; x <= 5; ++x) {
          for (int y = -5; y <= 5; ++y) {
            ASSERT_EQ(shape.contains({static_cast<Real>(x), static_cast<Real>(y)}), a * x + b * y + c <= 0);
          }
        }
      }
    }
  }
}

TEST(HalfSpace, NormalizesItsNormal) {
  const Shape shape = Shape::half_space({3, 4}, 10);
  EXPECT_NEAR(shape.normal(0).x, 0.6_r, epsilon);
  EXPECT_NEAR(shape.normal(0).y, 0.8_r, epsilon);
  EXPECT_EQ(shape.offset(), 2);
}

TEST(HalfSpace, IsBoundedOnlyByItsBoundary) {
  const Aabb floor = Shape::half_space({0, 1}, 2).bounds({{5, 1}, {}});
  EXPECT_EQ(floor.high.y, 3);
  EXPECT_EQ(floor.low, (Vec2{-Shape::unbounded, -Shape::unbounded}));
  EXPECT_EQ(floor.high.x, Shape::unbounded);
  const Aabb slope = Shape::half_space({1, 1}, 0).bounds({});
  EXPECT_EQ(slope.high, (Vec2{Shape::unbounded, Shape::unbounded}));
}

TEST(Shape, BoundsAreTightAroundTheRotatedShape) {
  const Pose pose{{10, -5}, Rotation(0.7_r)};
  RandomShapes random(1);
  for (const ShapeType type : all_shape_types) {
    if (type == ShapeType::half_space) continue;
    for (int i = 0; i < 100; ++i) {
      const Shape shape = random.shape(type);
      Vec2 low{inf, inf};
      Vec2 high{-inf, -inf};
      for (int k = 0; k < shape.count(); ++k) {
        const Vec2 v = to_world(pose, shape.vertex(k));
        low = min(low, v);
        high = max(high, v);
      }
      const Aabb box = shape.bounds(pose);
      const Real r = shape.radius();
      EXPECT_NEAR(box.low.x, low.x - r, 32 * epsilon);
      EXPECT_NEAR(box.low.y, low.y - r, 32 * epsilon);
      EXPECT_NEAR(box.high.x, high.x + r, 32 * epsilon);
      EXPECT_NEAR(box.high.y, high.y + r, 32 * epsilon);
    }
  }
}

TEST(Shape, ContainsItsBoundary) {
  EXPECT_TRUE(Shape::circle(5).contains({3, 4}));
  EXPECT_FALSE(Shape::circle(5).contains({3.0001_r, 4}));
  EXPECT_TRUE(Shape::box({1, 2}, {1, 0}).contains({2, 2}));
  EXPECT_FALSE(Shape::box({1, 2}, {1, 0}).contains({2.0001_r, 2}));
  EXPECT_TRUE(Shape::capsule({-1, 0}, {1, 0}, 0.5_r).contains({1.5_r, 0}));
  EXPECT_TRUE(Shape::capsule({-1, 0}, {1, 0}, 0.5_r).contains({0.3_r, -0.5_r}));
  EXPECT_FALSE(Shape::capsule({-1, 0}, {1, 0}, 0.5_r).contains({1.4_r, 0.4_r}));
  EXPECT_FALSE(Shape::segment({-1, 0}, {1, 0}).contains({0, 0}));
}

TEST(Shape, ExtentReachesTheFarthestPoint) {
  EXPECT_EQ(Shape::circle(1, {3, 4}).extent(), 6);
  EXPECT_EQ(Shape::box({3, 4}).extent(), 5);
  EXPECT_EQ(Shape::capsule({-1, 0}, {3, 4}, 0.5_r).extent(), 5.5_r);
  EXPECT_EQ(Shape::half_space({0, 1}, 0).extent(), Shape::unbounded);
}

TEST(Shape, MovedTranslatesEverything) {
  const Vec2 by{2, -3};
  RandomShapes random(2);
  for (const ShapeType type : all_shape_types) {
    const Shape shape = random.shape(type);
    const Shape moved = shape.moved(by);
    for (int i = 0; i < 200; ++i) {
      const Vec2 p = random.point(1.5);
      // Skip points on the boundary, where rounding decides.
      if (shape.contains(p + Vec2{1e-4_r, 0}) != shape.contains(p - Vec2{1e-4_r, 0})) continue;
      EXPECT_EQ(moved.contains(p + by), shape.contains(p));
    }
  }
  EXPECT_EQ(Shape::half_space({0, 2}, 4).moved(by).offset(), -1);
  const std::vector<Vec2> points{{2, 0}, {1, 0}, {0, 0}, {-1, 0}};
  const Shape link = Shape::chain(points, false)[1].moved(by);
  EXPECT_EQ(link.ghost_before(), (Vec2{4, -3}));
  EXPECT_EQ(link.ghost_after(), (Vec2{1, -3}));
}

TEST(Chain, KnowsItsNeighboursAndItsFreeSide) {
  const std::vector<Vec2> ground{{2, 0}, {1, 0}, {0, 1}};
  const std::vector<Shape> open = Shape::chain(ground, false);
  ASSERT_EQ(open.size(), 2U);
  EXPECT_TRUE(open[0].in_chain());
  EXPECT_EQ(open[0].normal(0), (Vec2{0, 1}));  // it runs towards -x, with the sky above
  EXPECT_EQ(open[0].ghost_before(), (Vec2{1, 0}));
  EXPECT_EQ(open[0].ghost_after(), (Vec2{0, 1}));
  EXPECT_EQ(open[1].ghost_before(), (Vec2{2, 0}));
  EXPECT_EQ(open[1].ghost_after(), (Vec2{1, 0}));

  const std::vector<Shape> loop = Shape::chain(ground, true);
  ASSERT_EQ(loop.size(), 3U);
  EXPECT_EQ(loop[2].vertex(1), ground[0]);
  EXPECT_EQ(loop[0].ghost_before(), ground[2]);
  EXPECT_EQ(loop[2].ghost_after(), ground[1]);
  EXPECT_FALSE(Shape::segment({0, 0}, {1, 0}).in_chain());
}

TEST(Chain, RejectsTooFewPointsAndRepeatedOnes) {
  const std::vector<Vec2> points{{0, 0}, {1, 0}, {1, 0}};
  const std::span<const Vec2> all(points);
  EXPECT_THROW(Shape::chain(all.first(1), false), std::invalid_argument);
  EXPECT_THROW(Shape::chain(all.first(2), true), std::invalid_argument);
  EXPECT_THROW(Shape::chain(all, false), std::invalid_argument);
  EXPECT_NO_THROW(Shape::chain(all.first(2), false));
}

void expect_mass(const MassData& found, double mass, double inertia, Vec2 center) {
  EXPECT_NEAR(found.mass, mass, 8 * static_cast<double>(epsilon) * mass);
  EXPECT_NEAR(found.inertia, inertia, 8 * static_cast<double>(epsilon) * inertia);
  EXPECT_NEAR(found.center.x, center.x, 8 * epsilon);
  EXPECT_NEAR(found.center.y, center.y, 8 * epsilon);
}

constexpr double exact_pi = 3.14159265358979323846;

// The demo of the article's author gives it m r^2, which is the inertia of a hoop.
TEST(Mass, OfADiscIsHalfOfAHoopsInertia) {
  expect_mass(Shape::circle(2, {1, -1}).mass(3), 12 * exact_pi, 12 * exact_pi * 4 / 2, {1, -1});
}

TEST(Mass, OfABoxIsThatOfTheTextbook) {
  // m (w^2 + h^2) / 12 with w = 2, h = 4; rotation changes nothing.
  expect_mass(Shape::box({1, 2}, {5, 5}, 0.7_r).mass(2), 16, 16.0 * 20 / 12, {5, 5});
}

TEST(Mass, OfARightTriangleIsThatOfTheTextbook) {
  // Legs 3 and 6: the centre is at a third of each, and the inertia about it is m (b^2 + h^2) / 18.
  const std::vector<Vec2> points{{1, 1}, {4, 1}, {1, 7}};
  expect_mass(Shape::polygon(points).mass(2), 18, 18.0 * 45 / 18, {2, 3});
}

TEST(Mass, OfARegularHexagonIsThatOfTheTextbook) {
  // Side s: area 3 sqrt(3)/2 s^2, inertia m s^2 5/12.
  const std::vector<Vec2> points = ring(6, 2);
  const double mass = 1.5 * 1.7320508075688772 * 4;
  expect_mass(Shape::polygon(points).mass(1), mass, mass * 4 * 5 / 12, {0, 0});
}

TEST(Mass, OfABoxAndOfThePolygonWithItsCornersAgree) {
  const Shape box = Shape::box({0.5_r, 1.5_r}, {2, 1}, 0.4_r);
  const std::vector<Vec2> corners{box.vertex(0), box.vertex(1), box.vertex(2), box.vertex(3)};
  const MassData expected = box.mass(1);
  const MassData found = Shape::polygon(corners).mass(1);
  EXPECT_NEAR(found.mass, expected.mass, 32 * epsilon);
  EXPECT_NEAR(found.inertia, expected.inertia, 32 * epsilon);
  EXPECT_NEAR(length(found.center - expected.center), 0, 32 * epsilon);
}

// Integrates the second moment numerically, over strips across the capsule's axis.
TEST(Mass, OfACapsuleMatchesItsIntegral) {
  constexpr double r = 0.5;
  constexpr double half = 1.5;
  double area = 0;
  double moment = 0;
  constexpr int strips = 200000;
  const double dx = 2 * (half + r) / strips;
  for (int i = 0; i < strips; ++i) {
    const double x = -half - r + (i + 0.5) * dx;
    const double over = std::max(0.0, std::abs(x) - half);
    const double h = std::sqrt(r * r - over * over);
    area += 2 * h * dx;
    moment += (2 * h * x * x + 2 * h * h * h / 3) * dx;
  }
  const MassData found = Shape::capsule({-1.5_r, 2}, {1.5_r, 2}, 0.5_r).mass(3);
  // At the round ends the height starts like a square root, so the error of the midpoint rule is of order dx^1.5.
  EXPECT_NEAR(found.mass, 3 * area, 1e-6);
  EXPECT_NEAR(found.inertia, 3 * moment, 4e-6);
  EXPECT_EQ(found.center, (Vec2{0, 2}));
}

// The masses of a polygon's two halves add up to that of the whole by the parallel-axis theorem.
TEST(Mass, OfPartsAddsUpByTheParallelAxisTheorem) {
  const std::vector<Vec2> lower{{0, 0}, {3, 0}, {3, 1}, {0, 1}};
  const std::vector<Vec2> upper{{0, 1}, {3, 1}, {2, 3}};
  const std::vector<Vec2> whole{{0, 0}, {3, 0}, {3, 1}, {2, 3}, {0, 1}};
  const MassData a = Shape::polygon(lower).mass(1);
  const MassData b = Shape::polygon(upper).mass(1);
  const MassData sum = Shape::polygon(whole).mass(1);
  const Real mass = a.mass + b.mass;
  const Vec2 center = (a.mass * a.center + b.mass * b.center) / mass;
  const Real inertia =
      a.inertia + a.mass * length_squared(a.center - center) + b.inertia + b.mass * length_squared(b.center - center);
  expect_mass(sum, static_cast<double>(mass), static_cast<double>(inertia), center);
}

TEST(Mass, IsAsPreciseFarFromTheFramesOrigin) {
  const std::vector<Vec2> near{{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  std::vector<Vec2> far = near;
  for (Vec2& p : far) p += Vec2{4096, 4096};
  EXPECT_EQ(Shape::polygon(far).mass(1).inertia, Shape::polygon(near).mass(1).inertia);
}

TEST(Mass, IsZeroForShapesWithoutAreaOrDensity) {
  EXPECT_EQ(Shape::segment({0, 0}, {1, 0}).mass(5).mass, 0);
  EXPECT_EQ(Shape::half_space({0, 1}, 0).mass(5).mass, 0);
  EXPECT_EQ(Shape::circle(1).mass(0).mass, 0);
  EXPECT_EQ(Shape::circle(1).mass(0).inertia, 0);
}

TEST(Mass, RejectsADensityThatIsNegativeOrNotFinite) {
  EXPECT_THROW(Shape::circle(1).mass(-1), std::invalid_argument);
  EXPECT_THROW(Shape::circle(1).mass(std::numeric_limits<Real>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(Shape::segment({0, 0}, {1, 0}).mass(std::numeric_limits<Real>::infinity()), std::invalid_argument);
}

}  // namespace
}  // namespace impulse::shape_test
