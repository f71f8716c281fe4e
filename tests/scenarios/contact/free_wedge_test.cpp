#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/scenarios/statement_of.h"

namespace plumb::free_wedge_test {
namespace {

using statement_of::Of;

double expected(double angle, double ratio, const std::string& body, Quantity quantity) {
  return *Of{"free-wedge", {{"angle", angle}, {"ratio", ratio}}, body, quantity}.expectations().front().expected;
}

// After a second: horizontal momentum, energy (the box has fallen by vy t/2), and the box still on the slope.
TEST(FreeWedge, KeepsMomentumAndEnergyAndTheBoxOnTheSlope) {
  for (const double degrees : {20.0, 30.0, 40.0}) {
    for (const double ratio : {1.0, 2.0, 50.0}) {
      const double back = expected(degrees, ratio, "wedge", Quantity::vx);
      const double vx = expected(degrees, ratio, "box", Quantity::vx);
      const double vy = expected(degrees, ratio, "box", Quantity::vy);
      EXPECT_NEAR(ratio * back + vx, 0, 1e-12);
      EXPECT_NEAR((ratio * back * back + vx * vx + vy * vy) / 2, 10 * -vy / 2, 1e-12);
      EXPECT_NEAR(vy, -(vx - back) * std::tan(degrees * std::numbers::pi / 180), 1e-12);
    }
  }
}

TEST(FreeWedge, StopsAWedgeThatCountsAsFixed) {
  const double fixed = 10 * 0.5 * std::sqrt(0.75);  // g sin cos t
  const Of speed{"free-wedge", {}, "box", Quantity::vx};
  EXPECT_LT(speed.allows(statement_of::accurate()), std::abs(fixed - *speed.expectations().front().expected) / 10);
  EXPECT_LT((Of{"free-wedge", {}, "wedge", Quantity::vx}.allows_at_most()), -expected(30, 2, "wedge", Quantity::vx));
}

}  // namespace
}  // namespace plumb::free_wedge_test
