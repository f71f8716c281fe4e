#include "reference/exact/line.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "scenarios/integrate.h"

namespace plumb::bounce_test {
namespace {

constexpr double g = 10;

std::array<double, 2> fall(std::array<double, 2> y, double h) {
  return runge_kutta(y, h, [](const std::array<double, 2>& now) { return std::array<double, 2>{now[1], -g}; });
}

// Small steps. A step that ends below the floor is bisected until it ends on it; there the speed is reversed.
std::array<double, 2> integrate(double height, double speed, double e, double until) {
  std::array<double, 2> y{height, speed};
  constexpr double h = 1e-3;
  for (double t = 0; t < until;) {
    double step = std::min(h, until - t);
    std::array<double, 2> next = fall(y, step);
    if (next[0] < 0) {
      double low = 0, high = step;
      for (int i = 0; i < 60; ++i) {
        step = (low + high) / 2;
        (fall(y, step)[0] < 0 ? high : low) = step;
      }
      step = low;
      next = fall(y, step);
      next[1] *= -e;
    }
    y = next;
    t += step;
  }
  return y;
}

TEST(Bounce, AgreesWithAnIntegrationThatFindsEachImpact) {
  for (const double e : {0.5, 0.8, 1.0}) {
    for (const double t : {0.5, 1.0, 2.0, 2.5}) {
      const std::array<double, 2> expected = integrate(4, 0, e, t);
      const Bounce::State state = Bounce(4, 0, g, e).at(t);
      EXPECT_NEAR(state.height, expected[0], 4e-9) << e << ' ' << t;
      EXPECT_NEAR(state.speed, expected[1], 9e-9) << e << ' ' << t;
    }
  }
}

TEST(Bounce, AgreesWithTheIntegrationWhenThrown) {
  const std::array<double, 2> expected = integrate(1, 6, 0.7, 2.4);
  const Bounce::State state = Bounce(1, 6, g, 0.7).at(2.4);
  EXPECT_NEAR(state.height, expected[0], 1e-9);
  EXPECT_NEAR(state.speed, expected[1], 6e-9);
}

TEST(Bounce, ReachesItsApexHalfwayBetweenImpacts) {
  const Bounce bounce(4, 0, g, 0.8);
  for (int n = 1; n <= 5; ++n) {
    const Bounce::State top = bounce.at((bounce.impact(n) + bounce.impact(n + 1)) / 2);
    EXPECT_NEAR(top.height, std::pow(0.64, n) * 4, 1e-13);
    EXPECT_NEAR(top.height, bounce.apex(n), 1e-13);
    EXPECT_NEAR(top.speed, 0, 1e-13);
  }
}

TEST(Bounce, RestsAtTheEndOfTheSeries) {
  const Bounce bounce(4, 0, g, 0.5);
  EXPECT_DOUBLE_EQ(bounce.rest(), 3 * std::sqrt(0.8));
  EXPECT_NEAR(bounce.impact(60), bounce.rest(), 1e-14);
  EXPECT_GT(bounce.at(bounce.rest() - 1e-3).height, 0);
  EXPECT_EQ(bounce.at(bounce.rest() + 1e-12).height, 0);
  EXPECT_EQ(bounce.at(100).speed, 0);
}

TEST(Bounce, NeverRestsWhenNothingIsLost) {
  const Bounce bounce(4, 0, g, 1);
  EXPECT_EQ(bounce.rest(), std::numeric_limits<double>::infinity());
  for (const double t : {1.0, 10.0, 100.0}) {
    const Bounce::State now = bounce.at(t);
    EXPECT_NEAR(g * now.height + now.speed * now.speed / 2, 40, 1e-11);
  }
}

TEST(Bounce, StaysDownWhenAllIsLost) {
  const Bounce bounce(4, 0, g, 0);
  EXPECT_DOUBLE_EQ(bounce.rest(), std::sqrt(0.8));
  EXPECT_EQ(bounce.at(0.9).height, 0);
}

}  // namespace
}  // namespace plumb::bounce_test
