#include <gtest/gtest.h>

#include <cmath>

#include "bracket.h"
#include "scenarios/parts.h"

namespace plumb::friction_test {
namespace {

TEST(SlopeMap, FindsTheAngleOfFriction) {
  for (const double mu : {0.2, 0.5, 0.8}) {
    const double angle = middle(bracket("slope", "impulse", mu, 1, 46, "sticks"));
    EXPECT_NEAR(angle, std::atan(mu) / degree, 0.1) << mu;
  }
}

TEST(TippingMap, FindsTheAngleOfTheDiagonal) {
  const double angle = middle(bracket("tipping", "impulse", 0.5, 5, 59, "stands"));
  EXPECT_NEAR(angle, std::atan(0.5) / degree, 0.5);
}

}  // namespace
}  // namespace plumb::friction_test
