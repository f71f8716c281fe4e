#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenarios/statement_of.h"

namespace plumb::first_impact_test {
namespace {

using statement_of::Of;

constexpr double cos45 = 0.7071067811865476;

// mu (1+e) vn along the wall, and 2/r times that of spin.
TEST(ObliqueDisc, StopsAFrictionlessOne) {
  const double slips = 0.1 * 1.6 * 6 * cos45;
  EXPECT_LT((Of{"oblique-disc", {}, "disc", Quantity::vx}.allows_at_most()), slips / 100);
  EXPECT_LT((Of{"oblique-disc", {}, "disc", Quantity::angular_velocity}.allows_at_most()), 4 * slips / 4);
  const double grips = (6 * cos45 + 1) / 3;
  EXPECT_LT((Of{"oblique-disc", {{"friction", 0.9}}, "disc", Quantity::vx}.allows_at_most()), grips / 4);
}

// A hoop keeps half of the slip instead of a third: its spin changes by half as much per impulse.
TEST(ObliqueDisc, StopsAHoop) {
  EXPECT_LT((Of{"oblique-disc", {}, "disc", Quantity::angular_velocity}.allows_at_most()),
            2 * 0.1 * 1.6 * 6 * cos45 / 2);
  const double slip = 6 * cos45 + 1;
  EXPECT_LT((Of{"oblique-disc", {{"friction", 0.9}}, "disc", Quantity::vx}.allows_at_most()), slip * (1. / 2 - 1. / 3));
}

// The box has the spin 6 c J/m; with the inertia of a disc of its size, m/8, it would have 8 c J/m.
TEST(CornerImpact, StopsABoxOfWrongInertia) {
  EXPECT_LT((Of{"corner-impact", {}, "box", Quantity::angular_velocity}.allows_at_most()), 3.29 * (1. / 3) / 4);
  EXPECT_LT((Of{"corner-impact", {}, "box", Quantity::vy}.allows_at_most()), 0.05 * 2);
}

TEST(CornerImpact, DoesNotTakeASlopForALeverArm) {
  Stepping stated = statement_of::positions_first();
  const Of spin{"corner-impact", {}, "box", Quantity::angular_velocity};
  const double before = spin.allows(stated);
  stated.slop = 0.1;
  EXPECT_EQ(spin.allows(stated), before);
}

}  // namespace
}  // namespace plumb::first_impact_test
