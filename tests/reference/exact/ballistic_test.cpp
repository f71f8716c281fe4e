#include "reference/exact/ballistic.h"

#include <gtest/gtest.h>

#include "integrate.h"
#include "reference/plane.h"

namespace plumb {
namespace {

const BodyState start{.position = {1, 2}, .angle = 0.3, .velocity = {3, 4}, .angular_velocity = -5};

BodyState at(double t) {
  BodyState state;
  Ballistic({start}, {{0.5, -10}}).at(t, {&state, 1});
  return state;
}

TEST(Ballistic, AgreesWithRungeKutta) {
  std::array<double, 6> y{1, 2, 0.3, 3, 4, -5};
  constexpr int steps = 1000;
  for (int i = 0; i < steps; ++i) {
    y = runge_kutta(y, 2.0 / steps, [](const std::array<double, 6>& now) {
      return std::array<double, 6>{now[3], now[4], now[5], 0.5, -10, 0};
    });
  }
  const BodyState state = at(2);
  EXPECT_NEAR(state.position.x, y[0], 1e-9 * 10);
  EXPECT_NEAR(state.position.y, y[1], 1e-9 * 10);
  EXPECT_NEAR(state.angle, y[2], 1e-9 * 10);
  EXPECT_NEAR(state.velocity.x, y[3], 1e-9 * 10);
  EXPECT_NEAR(state.velocity.y, y[4], 1e-9 * 10);
  EXPECT_EQ(state.angular_velocity, -5);
}

TEST(Ballistic, KeepsTheEnergyPerMass) {
  const auto energy = [](const BodyState& s) {
    return dot(s.velocity, s.velocity) / 2 - dot(Vec{0.5, -10}, s.position);
  };
  for (const double t : {0.1, 1.0, 7.0}) EXPECT_NEAR(energy(at(t)), energy(start), 1e-12 * 2500);
}

TEST(Ballistic, StartsWhereItStarts) {
  EXPECT_EQ(at(0).position, start.position);
  EXPECT_EQ(at(0).velocity, start.velocity);
}

}  // namespace
}  // namespace plumb
