#include "reference/exact/oscillation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/integrate.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/vec.h"

namespace plumb::oscillation_test {
namespace {

namespace spring_tests {

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

TEST(Oscillator, ReturnsAfterItsPeriod) {
  const Oscillator swing(1, 0, 2, 50, 0);
  EXPECT_DOUBLE_EQ(swing.frequency(), 5);
  EXPECT_NEAR(swing.at(2 * std::numbers::pi / 5).stretch, 1, 1e-14);
  EXPECT_NEAR(swing.at(std::numbers::pi / 10).stretch, 0, 1e-14);
}

TEST(Oscillator, KeepsItsEnergyOnlyWithoutDamping) {
  const auto energy = [](const Oscillator& o, double t) {
    return 25 * o.at(t).stretch * o.at(t).stretch + o.at(t).speed * o.at(t).speed;
  };
  const Oscillator free(1, 2, 2, 50, 0);
  const Oscillator damped(1, 2, 2, 50, 1);
  EXPECT_NEAR(energy(free, 7), energy(free, 0), 1e-12);
  EXPECT_LT(energy(damped, 7), energy(damped, 1));
}

}  // namespace spring_tests

namespace pendulum_tests {

constexpr double w = 2.3;

TEST(Pendulum, AgreesWithRungeKutta) {
  for (const double angle : {0.01, 1.0, -1.6, 3.0}) {
    std::array<double, 2> y{angle, 0};
    constexpr int steps = 40000;
    for (int i = 0; i < steps; ++i) {
      y = runge_kutta(y, 6.0 / steps, [](const std::array<double, 2>& now) {
        return std::array<double, 2>{now[1], -w * w * std::sin(now[0])};
      });
    }
    const Pendulum::State state = Pendulum(angle, w).at(6);
    EXPECT_NEAR(state.angle, y[0], 3e-9) << angle;
    EXPECT_NEAR(state.speed, y[1], 6e-9) << angle;
  }
}

TEST(Pendulum, HasTheSmallAngleFrequencyAtSmallAmplitudes) {
  EXPECT_NEAR(Pendulum(1e-5, w).period(), 2 * std::numbers::pi / w, 1e-10);
  // The series 1 + a^2/16 + 11 a^4/3072 + ...
  const double a = 0.1;
  EXPECT_NEAR(Pendulum(a, w).period() * w / (2 * std::numbers::pi), 1 + a * a / 16 + 11 * a * a * a * a / 3072, 1e-8);
}

TEST(Pendulum, ReturnsAfterItsPeriodAndIsAtTheBottomAfterAQuarter) {
  const Pendulum swing(2.5, w);
  EXPECT_NEAR(swing.at(swing.period()).angle, 2.5, 1e-13);
  EXPECT_NEAR(swing.at(swing.period() / 2).angle, -2.5, 1e-13);
  EXPECT_NEAR(swing.at(swing.period() / 4).angle, 0, 1e-13);
  EXPECT_NEAR(swing.at(swing.period() / 4).speed, -2 * w * std::sin(1.25), 1e-13);
}

TEST(Pendulum, KeepsItsEnergy) {
  const Pendulum swing(3.1, w);
  const auto energy = [&swing](double t) {
    return swing.at(t).speed * swing.at(t).speed / 2 - w * w * std::cos(swing.at(t).angle);
  };
  for (const double t : {0.5, 1.5, 2.0, 9.0}) EXPECT_NEAR(energy(t), energy(0), 1e-12);
}

// w^2 = (3 g/L)(cos b0 - cos b) of a toppling rod, b from the vertical.
TEST(Pendulum, OfATopplingRodHasTheAngularVelocityFromEnergy) {
  const Scenario& toppling = *Catalog<Scenario>::find("rod-toppling");
  const Scene scene = toppling.scene(complete(toppling, {}));
  const auto simulation = Catalog<Engine>::find("pendulum")->build(scene, {});
  simulation->step(scene.duration);
  std::vector<BodyState> states(scene.bodies.size());
  simulation->read(states);
  const double b = std::atan2(states[1].position.x, states[1].position.y);
  // The rod has a thickness d: I about its end is m (L^2/3 + d^2/12).
  const double stiffer = 1 + 0.01 / (4 * 16);
  const double expected = 3 * 10 / 4.0 * (std::cos(std::numbers::pi / 12) - std::cos(b)) / stiffer;
  EXPECT_NEAR(states[1].angular_velocity * states[1].angular_velocity, expected, 1e-12);
  EXPECT_NEAR(length(states[1].position), 2, 1e-14);
}

}  // namespace pendulum_tests

}  // namespace
}  // namespace plumb::oscillation_test
