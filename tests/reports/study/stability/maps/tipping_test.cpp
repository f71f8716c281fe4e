#include <gtest/gtest.h>

#include <cmath>

#include "bracket.h"
#include "scenarios/parts.h"

namespace plumb {
namespace {

TEST(TippingMap, FindsTheAngleOfTheDiagonal) {
  const double angle = middle(bracket("tipping", "impulse", 0.5, 5, 59, "stands"));
  EXPECT_NEAR(angle, std::atan(0.5) / degree, 0.5);
}

}  // namespace
}  // namespace plumb
