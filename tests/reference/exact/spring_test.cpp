#include "reference/exact/spring.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "integrate.h"

namespace plumb {
namespace {

TEST(Oscillator, AgreesWithRungeKutta) {
  for (const double damping : {0.0, 1.0}) {
    std::array<double, 2> y{0.7, -1.5};
    constexpr int steps = 4000;
    for (int i = 0; i < steps; ++i) {
      y = runge_kutta(y, 3.0 / steps, [damping](const std::array<double, 2>& now) {
        return std::array<double, 2>{now[1], -(50 * now[0] + damping * now[1]) / 2};
      });
    }
    const Oscillator::State state = Oscillator(0.7, -1.5, 2, 50, damping).at(3);
    EXPECT_NEAR(state.stretch, y[0], 1e-9);
    EXPECT_NEAR(state.speed, y[1], 4e-9);
  }
}

TEST(Oscillator, ComesBackAfterItsPeriod) {
  const Oscillator swing(1, 0, 2, 50, 0);
  EXPECT_DOUBLE_EQ(swing.frequency(), 5);
  EXPECT_NEAR(swing.at(2 * std::numbers::pi / 5).stretch, 1, 1e-14);
  EXPECT_NEAR(swing.at(std::numbers::pi / 10).stretch, 0, 1e-14);
}

TEST(Oscillator, KeepsItsEnergyWithoutDampingAndOnlyThen) {
  const auto energy = [](const Oscillator& o, double t) {
    return 25 * o.at(t).stretch * o.at(t).stretch + o.at(t).speed * o.at(t).speed;
  };
  const Oscillator free(1, 2, 2, 50, 0);
  const Oscillator damped(1, 2, 2, 50, 1);
  EXPECT_NEAR(energy(free, 7), energy(free, 0), 1e-12);
  EXPECT_LT(energy(damped, 7), energy(damped, 1));
}

}  // namespace
}  // namespace plumb
