#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "../random_shapes.h"
#include "../real_literal.h"
#include "impulse/shape.h"

namespace impulse {
namespace {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

void expect_near(const MassData& found, double mass, double inertia, Vec2 center) {
  EXPECT_NEAR(found.mass, mass, 8 * static_cast<double>(epsilon) * mass);
  EXPECT_NEAR(found.inertia, inertia, 8 * static_cast<double>(epsilon) * inertia);
  EXPECT_NEAR(found.center.x, center.x, 8 * epsilon);
  EXPECT_NEAR(found.center.y, center.y, 8 * epsilon);
}

constexpr double exact_pi = 3.14159265358979323846;

// The author's demo gives it m r^2, which is a hoop's.
TEST(Mass, OfADiscIsHalfOfAHoopsInertia) {
  expect_near(Shape::circle(2, {1, -1}).mass(3), 12 * exact_pi, 12 * exact_pi * 4 / 2, {1, -1});
}

TEST(Mass, OfABoxIsTheTextbooks) {
  // m (w^2 + h^2) / 12 with w = 2, h = 4; turning it changes nothing.
  expect_near(Shape::box({1, 2}, {5, 5}, 0.7_r).mass(2), 16, 16.0 * 20 / 12, {5, 5});
}

TEST(Mass, OfARightTriangleIsTheTextbooks) {
  // Legs 3 and 6: centre at a third of each, m (b^2 + h^2) / 18 about it.
  const std::vector<Vec2> points{{1, 1}, {4, 1}, {1, 7}};
  expect_near(Shape::polygon(points).mass(2), 18, 18.0 * 45 / 18, {2, 3});
}

TEST(Mass, OfARegularHexagonIsTheTextbooks) {
  // Side s: area 3 sqrt(3)/2 s^2, inertia m s^2 5/12.
  const std::vector<Vec2> points = ring(6, 2);
  const double mass = 1.5 * 1.7320508075688772 * 4;
  expect_near(Shape::polygon(points).mass(1), mass, mass * 4 * 5 / 12, {0, 0});
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

// A capsule in strips across its axis: a numerical integral of the second moment.
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
  // The midpoint rule's error at the round ends, where the height starts like a square root: dx^1.5.
  EXPECT_NEAR(found.mass, 3 * area, 1e-6);
  EXPECT_NEAR(found.inertia, 3 * moment, 4e-6);
  EXPECT_EQ(found.center, (Vec2{0, 2}));
}

// Cut in two, a polygon's parts give the whole by the parallel-axis theorem.
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
  expect_near(sum, static_cast<double>(mass), static_cast<double>(inertia), center);
}

TEST(Mass, IsAsPreciseFarFromTheFramesOrigin) {
  const std::vector<Vec2> near{{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  std::vector<Vec2> far = near;
  for (Vec2& p : far) p += Vec2{4096, 4096};
  EXPECT_EQ(Shape::polygon(far).mass(1).inertia, Shape::polygon(near).mass(1).inertia);
}

TEST(Mass, IsNothingForShapesWithoutAreaAndWithoutDensity) {
  EXPECT_EQ(Shape::segment({0, 0}, {1, 0}).mass(5).mass, 0);
  EXPECT_EQ(Shape::half_space({0, 1}, 0).mass(5).mass, 0);
  EXPECT_EQ(Shape::circle(1).mass(0).mass, 0);
  EXPECT_EQ(Shape::circle(1).mass(0).inertia, 0);
}

TEST(Mass, RefusesADensityThatIsNegativeOrNotFinite) {
  EXPECT_THROW(Shape::circle(1).mass(-1), std::invalid_argument);
  EXPECT_THROW(Shape::circle(1).mass(std::numeric_limits<Real>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(Shape::segment({0, 0}, {1, 0}).mass(std::numeric_limits<Real>::infinity()), std::invalid_argument);
}

}  // namespace
}  // namespace impulse
