#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "scenarios/integrate.h"
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

}  // namespace
}  // namespace plumb::driven_test
