#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenarios/statement_of.h"

namespace plumb::pendulums_test {
namespace {

using statement_of::Of;

// w^2 = 3 g/(2 L) = 7.5: a rod of 2 m let go level turns by .9 rad in half a second.
TEST(Pendulum, StopsARodThatDoesNotSwing) {
  EXPECT_LT((Of{"pendulum", {}, "rod", Quantity::angle, 1.0}.allows_at_most()), 0.9 / 5);
}

// By half of gravity it has turned by half as much.
TEST(Pendulum, StopsHalfGravity) {
  EXPECT_LT((Of{"pendulum", {}, "rod", Quantity::angle, 1.0}.allows_at_most()), 0.45 / 3);
}

TEST(RodToppling, StopsARodThatStandsStill) {
  const double early = 0.2618 * (std::cosh(1.936 / 6) - 1);
  EXPECT_LT((Of{"rod-toppling", {}, "rod", Quantity::angle, 0.5}.allows_at_most()), early / 2);
  EXPECT_LT((Of{"rod-toppling", {}, "rod", Quantity::angle}.allows_at_most()), 0.643 / 5);
}

// m/2 g L is what the swing exchanges.
TEST(Pendulum, StopsASecondOrderHingeThatLosesAThousandthOfItsEnergy) {
  EXPECT_LT((Of{"pendulum", {}, "", Quantity::energy}.allows(statement_of::accurate())), 2 * 0.002);
}

// Symplectic Euler, both ways round: x is half a step off, v is exact but for the phase of second order.
TEST(Spring, AllowsWhatSymplecticEulerDoes) {
  constexpr double w = 4;
  constexpr double h = 1.0 / 60;
  double v = 0;
  double x = 1;
  for (int i = 0; i < 300; ++i) {
    v -= w * w * x * h;
    x += v * h;
  }
  const Stepping stated = statement_of::skinned();
  const double error = std::abs(x - std::cos(5 * w));
  const double of_speed = std::abs(v + w * std::sin(5 * w));
  const double of_energy = std::abs(v * v + w * w * (x * x - 1)) / (w * w);
  const Of place{"spring", {}, "disc", Quantity::x};
  const Of speed{"spring", {}, "disc", Quantity::vx};
  const Of energy{"spring", {}, "", Quantity::energy};
  EXPECT_LT(error, place.allows(stated));
  EXPECT_LT(of_speed, speed.allows(stated));
  EXPECT_LT(of_energy * 1.5707963, energy.allows(stated));
}

TEST(Spring, StopsATenthOfTheEnergyAndAFrozenDisc) {
  EXPECT_LT((Of{"spring", {}, "", Quantity::energy}.allows_at_most()), 0.1 * 1.57);
  EXPECT_LT((Of{"spring", {}, "disc", Quantity::vx}.allows_at_most()), 3.65 / 20);
}

}  // namespace
}  // namespace plumb::pendulums_test
