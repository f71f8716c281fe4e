#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenarios/statement_of.h"

namespace plumb::moving_walls_test {
namespace {

using statement_of::Of;

double leaves(double paddle, double ball, double e) {
  return *Of{"paddle", {{"paddle", paddle}, {"ball", ball}, {"restitution", e}}, "ball", Quantity::vx}
              .expectations()
              .front()
              .expected;
}

TEST(Paddle, IsAWallAtRestSeenByOneWhoMoves) {
  for (const double e : {0.0, 0.8, 1.0}) {
    EXPECT_NEAR(leaves(0, 5, e), 5 * e, 1e-12);
    EXPECT_NEAR(leaves(2, 3, e), 2 + leaves(0, 5, e), 1e-12);
    EXPECT_NEAR(leaves(-1, 6, e), -1 + leaves(0, 5, e), 1e-12);
  }
}

// An engine that takes a kinematic body for one at rest is off by V in the approach and in the velocity after it.
TEST(Paddle, StopsAPaddleThatCountsAsAtRest) {
  EXPECT_LT((Of{"paddle", {}, "ball", Quantity::vx}.allows_at_most()), 2.0 / 1000);
}

// Small steps, each with its reflections; off by what a step moves, 2 v dt an impact.
TEST(ClosingWalls, AgreeWithSmallSteps) {
  const double ball = 6;
  const double walls = 0.7;
  double place = -0.3;
  double velocity = ball;
  constexpr double dt = 1e-6;
  const int steps = static_cast<int>(std::lround(1.05 / dt));
  for (int i = 0; i < steps; ++i) {
    place += velocity * dt;
    const double room = 2 - 0.25 - walls * (i + 1) * dt;
    if (std::abs(place) > room && place * velocity > 0) velocity = -velocity + (velocity > 0 ? -2 : 2) * walls;
  }
  EXPECT_NEAR(*(Of{"closing-walls", {}, "ball", Quantity::vx}.expectations().front().expected), velocity, 1e-9);
  EXPECT_NEAR(*(Of{"closing-walls", {}, "ball", Quantity::x}.expectations().front().expected), place, 1e-4);
  EXPECT_NEAR(std::abs(velocity), ball + 3 * 2 * walls, 1e-9);
}

}  // namespace
}  // namespace plumb::moving_walls_test
