#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "scenarios/integrate.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::joint_stop_test {
namespace {

using statement_of::Of;

// A rod of 2 m falls from level: q'' = (3/4) g cos q. It reaches every limit long before the end, and its weight
// presses it on the stop from then on, as all limits are above the vertical.
TEST(JointStop, IsReachedLongBeforeTheEnd) {
  for (const double degrees : {5.0, 60.0, 80.0}) {
    const double limit = degrees * std::acos(-1) / 180;
    const auto rate = [](const std::array<double, 2>& s) {
      return std::array<double, 2>{s[1], 0.75 * 10 * std::cos(s[0])};
    };
    EXPECT_GT(integrated(std::array<double, 2>{0, 0}, 1.5, 1000, rate)[0], limit);
    EXPECT_GT(std::cos(limit), 0);
  }
}

TEST(JointStop, LeavesTheRodOnItsCircle) {
  for (const double degrees : {5.0, 60.0, 80.0}) {
    const Parameters changes{{"limit", degrees}};
    const double x = *Of{"joint-stop", changes, "rod", Quantity::x}.expectations().front().expected;
    const double y = *Of{"joint-stop", changes, "rod", Quantity::y}.expectations().front().expected;
    const double angle = *Of{"joint-stop", changes, "rod", Quantity::angle}.expectations().front().expected;
    EXPECT_NEAR(std::hypot(x, y), 1, 1e-12);
    EXPECT_NEAR(std::atan2(y, x), angle, 1e-12);
    EXPECT_NEAR(angle, -degrees * std::acos(-1) / 180, 1e-12);
  }
}

// One that rebounds or passes is farther off than a hundredth of a radian at almost every moment.
TEST(JointStop, StopsAHingeWithoutALimit) {
  EXPECT_LT((Of{"joint-stop", {}, "rod", Quantity::angle}.allows_at_most()), 0.01);
}

// Of 5 mm, a metre from the hinge, and of 2 degrees: a hinge that rests 3 degrees past its limit is wrong, and so is
// one of 2 degrees that states no such slop.
TEST(JointStop, AllowsTheAngleThatAHingeStatesToLeavePastItsLimitAndNoMore) {
  const Of angle{"joint-stop", {}, "rod", Quantity::angle};
  constexpr double degree = std::numbers::pi / 180;
  Stepping stated = statement_of::skinned();
  EXPECT_LT(angle.allows(stated), 2 * degree);
  stated.angular_slop = 2 * degree;
  EXPECT_GT(angle.allows(stated), 2 * degree);
  EXPECT_LT(angle.allows(stated), 3 * degree);
}

}  // namespace
}  // namespace plumb::joint_stop_test
