#include <gtest/gtest.h>

#include <cmath>

#include "scenarios/parts.h"
#include "tests/reports/stability/maps/bracket.h"

namespace plumb {
namespace {

TEST(TippingMap, FindsTheAngleOfTheDiagonal) {
  const double angle = middle(bracket("tipping", "impulse", 0.5, 5, 59, "stands"));
  EXPECT_NEAR(angle, std::atan(0.5) / degree, 0.5);
}

}  // namespace
}  // namespace plumb
