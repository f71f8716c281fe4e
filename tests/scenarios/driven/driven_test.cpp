#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "scenarios/integrate.h"
#include "scenarios/scenario.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::driven_test {
namespace {

using statement_of::Of;

double expected(const char* body, Quantity quantity, std::size_t moment) {
  return *(Of{"slider-crank", {}, body, quantity}.expectations()[moment].expected);
}

// The rod, at its tilt, reaches from the piston back to the crank's pin; and its speed is the slope of the way.
TEST(SliderCrank, KeepsTheLengthOfItsRod) {
  for (const std::size_t moment : {0u, 1u}) {
    const double angle = 0.3 + 3 * (moment == 0 ? 1.5 : 3.0);
    const double x = expected("piston", Quantity::x, moment);
    const double tilt = expected("rod", Quantity::angle, moment);
    EXPECT_NEAR(x - 1.6 * std::cos(tilt), 0.5 * std::cos(angle), 1e-12);
    EXPECT_NEAR(-1.6 * std::sin(tilt), 0.5 * std::sin(angle), 1e-12);
  }
}

TEST(SliderCrank, HasTheSpeedThatMovesThePiston) {
  const auto at = [](double turn) {
    return *(Of{"slider-crank", {{"turn", turn}}, "piston", Quantity::x}.expectations()[1].expected);
  };
  constexpr double small = 1e-5;  // rad/s more or less for 3 s is 1e-5 s later or earlier at 3 rad/s
  EXPECT_NEAR((at(3 + small) - at(3 - small)) / (2 * small), expected("piston", Quantity::vx, 1), 1e-7);
}

TEST(SliderCrank, StopsARodThatTurnsWithTheCrank) {
  EXPECT_LT((Of{"slider-crank", {}, "piston", Quantity::x}.allows(statement_of::accurate())), 0.001);
  EXPECT_LT((Of{"slider-crank", {}, "piston", Quantity::x}.allows_at_most()), 0.5 / 2);
}

// Newton's law in the plane: the rail pushes across itself only, as hard as it takes to stay on it, 2 W r'.
TEST(TurningRail, AgreesWithAnIntegrationInThePlane) {
  constexpr double turn = 2;
  const auto rate = [](const std::array<double, 5>& y) {  // x, y, vx, vy, t
    const double c = std::cos(turn * y[4]);
    const double s = std::sin(turn * y[4]);
    const double push = 2 * turn * (y[2] * c + y[3] * s);
    return std::array<double, 5>{y[2], y[3], -push * s, push * c, 1};
  };
  const auto end = integrated(std::array<double, 5>{0.5, 0, 0, turn * 0.5, 0}, 1, 5000, rate);
  EXPECT_NEAR(*(Of{"turning-rail", {}, "bead", Quantity::x}.expectations().front().expected), end[0], 1e-9);
  EXPECT_NEAR(*(Of{"turning-rail", {}, "bead", Quantity::y}.expectations().front().expected), end[1], 1e-9);
  EXPECT_NEAR(*(Of{"turning-rail", {}, "bead", Quantity::speed}.expectations().front().expected),
              std::hypot(end[2], end[3]), 1e-9);
}

// One that stays where it is, or flies off on its tangent, is half a metre and more away.
TEST(TurningRail, StopsABeadThatDoesNotSlide) {
  EXPECT_LT((Of{"turning-rail", {}, "bead", Quantity::y}.allows_at_most()), (0.5 * std::cosh(2) - 0.5) / 2);
}

// In steps of a microsecond, by the law alone: friction of mu s g against the slip, never past it.
TEST(Conveyor, AgreesWithFrictionInSmallSteps) {
  const Scenario& scenario = *Catalog<Scenario>::find("conveyor");
  for (const Variant& variant : scenario.variants) {
    const Parameters p = complete(scenario, variant.changes);
    constexpr double h = 1e-6;
    const double most = 0.3 * p.at("scale") * 10 * h;
    double x = 0;
    double v = 0;
    const auto all = scenario.expectations(p);
    int step = 0;
    for (const std::size_t moment : {0u, 2u}) {  // vx and x at each
      for (; step < static_cast<int>(std::lround(*all[moment].time / h)); ++step) {
        const double after = v + std::clamp(p.at("speed") - v, -most, most);
        x += h * (v + after) / 2;
        v = after;
      }
      EXPECT_NEAR(*all[moment].expected, v, 1e-5) << variant.label;
      EXPECT_NEAR(*all[moment + 1].expected, x, 1e-5) << variant.label;
    }
  }
}

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
}  // namespace plumb::driven_test
