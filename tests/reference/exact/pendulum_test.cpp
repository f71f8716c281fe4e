#include "reference/exact/pendulum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "integrate.h"
#include "reference/plane.h"
#include "scenarios/scenario.h"

namespace plumb {
namespace {

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

TEST(Pendulum, SwingsAsSmallSwingsDoWhenTheyAreSmall) {
  EXPECT_NEAR(Pendulum(1e-5, w).period(), 2 * std::numbers::pi / w, 1e-10);
  // The series 1 + a^2/16 + 11 a^4/3072 + ...
  const double a = 0.1;
  EXPECT_NEAR(Pendulum(a, w).period() * w / (2 * std::numbers::pi), 1 + a * a / 16 + 11 * a * a * a * a / 3072, 1e-8);
}

TEST(Pendulum, ComesBackAfterItsPeriodAndIsBelowAfterAQuarter) {
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
TEST(Pendulum, OfATopplingRodTurnsAsItsEnergySays) {
  const Scenario& toppling = *Catalog<Scenario>::find("rod-toppling");
  const Scene scene = toppling.scene(complete(toppling, {}));
  const auto simulation = Catalog<Engine>::find("pendulum")->build(scene, {});
  simulation->step(scene.duration);
  std::vector<BodyState> states(scene.bodies.size());
  simulation->read(states);
  const double b = std::atan2(states[1].position.x, states[1].position.y);
  // The rod has a thickness, d: I about its end is m (L^2/3 + d^2/12).
  const double stiffer = 1 + 0.01 / (4 * 16);
  const double expected = 3 * 10 / 4.0 * (std::cos(std::numbers::pi / 12) - std::cos(b)) / stiffer;
  EXPECT_NEAR(states[1].angular_velocity * states[1].angular_velocity, expected, 1e-12);
  EXPECT_NEAR(length(states[1].position), 2, 1e-14);
}

}  // namespace
}  // namespace plumb
