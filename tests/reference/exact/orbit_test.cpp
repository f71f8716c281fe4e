#include "reference/exact/flight.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scenarios/integrate.h"
#include "scenarios/scene/vec.h"

namespace plumb::orbit_test {
namespace {

constexpr double k = 12;

std::array<double, 4> pull(const std::array<double, 4>& y) {
  const double r = std::hypot(y[0], y[1]);
  return {y[2], y[3], -k * y[0] / (r * r * r), -k * y[1] / (r * r * r)};
}

TEST(Orbit, AgreesWithRungeKutta) {
  for (const Vec velocity : {Vec{0, 2}, Vec{0.5, 1.1}, Vec{-1, 2.1}}) {
    std::array<double, 4> y{3, 0, velocity.x, velocity.y};
    constexpr int steps = 40000;
    for (int i = 0; i < steps; ++i) y = runge_kutta(y, 20.0 / steps, pull);
    const Orbit::State state = Orbit({3, 0}, velocity, k).at(20);
    EXPECT_NEAR(state.position.x, y[0], 3e-9);
    EXPECT_NEAR(state.position.y, y[1], 3e-9);
    EXPECT_NEAR(state.velocity.x, y[2], 3e-9);
    EXPECT_NEAR(state.velocity.y, y[3], 3e-9);
  }
}

TEST(Orbit, KeepsEnergyAngularMomentumAndApseLine) {
  const Orbit orbit({3, 0}, {0.5, 1.1}, k);
  const auto invariants = [](const Orbit::State& s) {
    const double r = length(s.position);
    const double momentum = cross(s.position, s.velocity);
    const Vec apse = momentum * (-perpendicular(s.velocity)) - (k / r) * s.position;  // Laplace's vector
    return std::array<double, 4>{dot(s.velocity, s.velocity) / 2 - k / r, momentum, apse.x, apse.y};
  };
  const std::array<double, 4> start = invariants(orbit.at(0));
  for (const double t : {0.3, 1.0, 5.0, 77.0}) {
    const std::array<double, 4> now = invariants(orbit.at(t));
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(now[i], start[i], 1e-11) << t << ' ' << i;
  }
}

TEST(Orbit, ClosesAfterKeplersPeriod) {
  const Orbit orbit({3, 0}, {0.5, 1.1}, k);
  EXPECT_NEAR(length(orbit.at(orbit.period()).position - Vec{3, 0}), 0, 1e-13);
  EXPECT_GT(length(orbit.at(orbit.period() / 2).position - Vec{3, 0}), 1);
}

TEST(Orbit, OfACircleIsACircle) {
  const Orbit orbit({3, 0}, {0, 2}, k);
  EXPECT_DOUBLE_EQ(orbit.semi_major_axis(), 3);
  const double t = 1.3;
  EXPECT_NEAR(orbit.at(t).position.x, 3 * std::cos(2 * t / 3), 1e-14);
  EXPECT_NEAR(orbit.at(t).position.y, 3 * std::sin(2 * t / 3), 1e-14);
}

}  // namespace
}  // namespace plumb::orbit_test
