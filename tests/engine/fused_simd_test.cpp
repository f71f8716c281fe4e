// Lanes as the fused kernels have them: what is rounded once, and what is not.
#define IMPULSE_LANES fused_for_test
#define IMPULSE_LANES_scalar
#define IMPULSE_FUSED
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "random_shapes.h"
#include "simd.h"

namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

namespace {

Real first(const Lanes& lanes) {
  std::array<Real, lane_count> numbers{};
  lanes.store(numbers.data());
  return numbers[0];
}

TEST(FusedLanes, RoundASumOfAProductOnce) {
  RandomShapes random(1);
  int differ = 0;
  for (int i = 0; i < 1000; ++i) {
    const Real x = random.number(-2, 2);
    const Real y = random.number(-2, 2);
    const Real z = random.number(-2, 2);
    const Lanes a = Lanes::all(x);
    const Lanes b = Lanes::all(y);
    const Lanes c = Lanes::all(z);
    EXPECT_EQ(first(a * b + c), std::fma(x, y, z));
    EXPECT_EQ(first(c + a * b), std::fma(x, y, z));
    EXPECT_EQ(first(a * b - c), std::fma(x, y, -z));
    EXPECT_EQ(first(c - a * b), std::fma(-x, y, z));
    differ += first(a * b + c) != x * y + z ? 1 : 0;
  }
  EXPECT_GT(differ, 0);
}

TEST(FusedLanes, RoundTheSecondOfTwoProductsByItself) {
  RandomShapes random(2);
  for (int i = 0; i < 1000; ++i) {
    const Real x = random.number(-2, 2);
    const Real y = random.number(-2, 2);
    const Real z = random.number(-2, 2);
    const Lanes a = Lanes::all(x);
    const Lanes b = Lanes::all(y);
    const Lanes c = Lanes::all(z);
    EXPECT_EQ(first(a * b + b * c), std::fma(x, y, y * z));
    EXPECT_EQ(first(a * b - b * c), std::fma(x, y, -(y * z)));
    EXPECT_EQ(first(a * b * c + a), std::fma(x * y, z, x));
  }
}

TEST(FusedLanes, RoundAProductThatIsNotAdded) {
  const Real third = Real{1} / 3;
  const Lanes a = Lanes::all(third);
  const Lanes product = a * a;
  EXPECT_EQ(first(product), third * third);
  EXPECT_EQ(first(product + a), third * third + third);
  EXPECT_EQ(first(-(a * a)), -(third * third));
  EXPECT_EQ(first(a * a / a), third * third / third);
  EXPECT_EQ((a * a < product).bits(), 0U);
}

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
