#include "impulse/math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "../real_literal.h"

namespace impulse::math_test {
namespace {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
constexpr Real quarter_turn = pi / 2;

// The error of `value` against a reference in long double, in units of the reference's last place.
long double error_in_ulp(Real value, long double truth) {
  const Real near = static_cast<Real>(truth);
  const Real ulp = std::nextafter(std::abs(near), std::numeric_limits<Real>::infinity()) - std::abs(near);
  return std::abs(static_cast<long double>(value) - truth) / static_cast<long double>(ulp);
}

long double worst_error_in_ulp(Real range) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<Real> angles(-range, range);
  long double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    const Real angle = angles(random);
    const SinCos of = sin_cos(angle);
    worst = std::max(worst, error_in_ulp(of.sin, std::sin(static_cast<long double>(angle))));
    worst = std::max(worst, error_in_ulp(of.cos, std::cos(static_cast<long double>(angle))));
  }
  return worst;
}

TEST(SinCos, IsWithinOneUnitInTheLastPlace) {
  EXPECT_LT(worst_error_in_ulp(1), 1);
  EXPECT_LT(worst_error_in_ulp(10), 1);
  EXPECT_LT(worst_error_in_ulp(1e3_r), 1);
  EXPECT_LT(worst_error_in_ulp(1e5_r), 1);
  EXPECT_LT(worst_error_in_ulp(1e6_r), 1);
}

TEST(SinCos, IsAsPreciseNearMultiplesOfAQuarterTurn) {
  for (int n = 1; n < 60000; ++n) {
    const Real angle = static_cast<Real>(n) * quarter_turn;
    const SinCos of = sin_cos(angle);
    ASSERT_LT(error_in_ulp(of.sin, std::sin(static_cast<long double>(angle))), 1) << n;
    ASSERT_LT(error_in_ulp(of.cos, std::cos(static_cast<long double>(angle))), 1) << n;
  }
}

// Beyond the exact range an angle is only known to half of its last bit, and so are its sine and cosine.
TEST(SinCos, OfAHugeAngleIsPreciseToTheRoundingOfTheAngle) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<Real> angles(1e6_r, 1e9_r);
  for (int i = 0; i < 10000; ++i) {
    const Real angle = angles(random);
    const double tolerance = static_cast<double>(epsilon) * (static_cast<double>(angle) / 2 + 1);
    const SinCos of = sin_cos(angle);
    ASSERT_NEAR(of.sin, static_cast<double>(std::sin(static_cast<long double>(angle))), tolerance);
    ASSERT_NEAR(of.cos, static_cast<double>(std::cos(static_cast<long double>(angle))), tolerance);
  }
}

TEST(SinCos, IsExactAtZeroOddAndEven) {
  EXPECT_EQ(sin_cos(0).sin, 0);
  EXPECT_EQ(sin_cos(0).cos, 1);
  for (const Real angle : {0.1_r, 0.785398_r, 2_r, 40_r, 12345.678_r}) {
    EXPECT_EQ(sin_cos(angle).sin, -sin_cos(-angle).sin);
    EXPECT_EQ(sin_cos(angle).cos, sin_cos(-angle).cos);
  }
}

TEST(SinCos, OfAnAngleThatIsNotFiniteIsNotANumber) {
  for (const Real angle : {std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::infinity(),
                           -std::numeric_limits<Real>::infinity()}) {
    EXPECT_TRUE(std::isnan(sin_cos(angle).sin));
    EXPECT_TRUE(std::isnan(sin_cos(angle).cos));
  }
}

TEST(Cross, IsAntisymmetricAndFollowsTheRightHand) {
  EXPECT_EQ(cross(Vec2{1, 0}, Vec2{0, 1}), 1);
  EXPECT_EQ(cross(Vec2{3, -2}, Vec2{5, 7}), -cross(Vec2{5, 7}, Vec2{3, -2}));
  EXPECT_EQ(cross(Vec2{3, -2}, Vec2{3, -2}), 0);
}

// v = w x r: the right rim of a wheel that rotates counter-clockwise moves up.
TEST(Cross, OfASpinAndAnArmIsTheVelocityOfTheRim) {
  EXPECT_EQ(cross(2_r, Vec2{3, 0}), (Vec2{0, 6}));
  EXPECT_EQ(cross(2_r, Vec2{0, 3}), (Vec2{-6, 0}));
  EXPECT_EQ(cross(Vec2{3, 4}, 2_r), -cross(2_r, Vec2{3, 4}));
}

// Torque times angular velocity and force times velocity are the same power if torque = r x F. The article prints
// r x omega, which is not a scalar.
TEST(Cross, OfAnArmAndAForceIsTheTorque) {
  const Vec2 arm{2, 1};
  const Vec2 force{-3, 5};
  const Real spin = 7;
  EXPECT_EQ(cross(arm, force) * spin, dot(force, cross(spin, arm)));
}

TEST(Perpendicular, IsAQuarterTurnCounterClockwise) {
  EXPECT_EQ(perpendicular({1, 0}), (Vec2{0, 1}));
  EXPECT_EQ(perpendicular({3, -4}), cross(1_r, Vec2{3, -4}));
}

TEST(Normalized, KeepsTheZeroVector) {
  EXPECT_EQ(normalized({0, 0}), (Vec2{0, 0}));
  EXPECT_EQ(normalized({0, -5}), (Vec2{0, -1}));
}

// The article's constructor writes m01 twice and swaps the columns, which would rotate x to -y.
TEST(Mat22, RotatesXToYByNinetyDegrees) {
  const Mat22 turn(quarter_turn);
  const Vec2 x = turn * Vec2{1, 0};
  const Vec2 y = turn * Vec2{0, 1};
  EXPECT_NEAR(x.x, 0, epsilon);
  EXPECT_NEAR(x.y, 1, epsilon);
  EXPECT_NEAR(y.x, -1, epsilon);
  EXPECT_NEAR(y.y, 0, epsilon);
}

TEST(Mat22, HasTheRotatedAxesAsColumns) {
  const Mat22 turn(0.3_r);
  EXPECT_EQ(turn * Vec2({1, 0}), turn.x);
  EXPECT_EQ(turn * Vec2({0, 1}), turn.y);
  EXPECT_EQ(turn.y, perpendicular(turn.x));
  const Rotation same(0.3_r);
  EXPECT_EQ(turn * Vec2({2, 5}), same * Vec2({2, 5}));
}

// A body stores its angle and computes the matrix from it in each step, so the matrix cannot drift.
TEST(Mat22, StaysOrthonormalOverAMillionSteps) {
  constexpr Real tolerance = sizeof(Real) == 8 ? 1e-15_r : 2e-7_r;  // a few roundings of numbers up to 1
  Real angle = 0;
  for (int i = 0; i < 1000000; ++i) {
    angle += 0.01_r;
    const Mat22 turn(angle);
    const Mat22 one = turn.transposed() * turn;
    ASSERT_NEAR(one.x.x, 1, tolerance);
    ASSERT_NEAR(one.y.y, 1, tolerance);
    ASSERT_NEAR(one.x.y, 0, tolerance);
    ASSERT_NEAR(turn.determinant(), 1, tolerance);
  }
}

TEST(Mat22, SolvesLinearSystemsAndGivesZeroForSingularOnes) {
  const Mat22 m({2, 1}, {-1, 4});
  EXPECT_EQ(m * m.solve({1, 14}), (Vec2{1, 14}));
  EXPECT_EQ(Mat22({1, 2}, {2, 4}).solve({1, 1}), (Vec2{0, 0}));
}

TEST(Pose, RelativeIsTheChangeOfBasis) {
  const Pose a{{3, -2}, Rotation(0.7_r)};
  const Pose b{{-1, 5}, Rotation(-1.9_r)};
  const Vec2 local{0.25_r, 1.5_r};
  const Vec2 there = to_local(a, to_world(b, local));
  const Vec2 same = to_world(relative(a, b), local);
  EXPECT_NEAR(there.x, same.x, 20 * epsilon);
  EXPECT_NEAR(there.y, same.y, 20 * epsilon);
}

TEST(Aabb, OverlapIncludesTouching) {
  const Aabb unit{{0, 0}, {1, 1}};
  EXPECT_TRUE(overlap(unit, {{1, 1}, {2, 2}}));
  EXPECT_FALSE(overlap(unit, {{1 + 2 * epsilon, 0}, {2, 1}}));
  EXPECT_TRUE(contains(unit, {1, 0}));
  EXPECT_FALSE(contains(grown(unit, -epsilon), {1, 0}));
}

}  // namespace
}  // namespace impulse::math_test
