#include "reference/exact/roll.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumb {
namespace {

// Coulomb's law step by step; a step in which the slip would change its sign ends where it is zero.
Roll::State integrate(const Roll::Case& c, double until) {
  const double h = until / 1000;
  Roll::State now{0, c.speed, 0, c.spin};
  bool slips = c.speed + c.spin * c.radius != 0;
  for (double left = until; left > 0;) {
    const double slip = slips ? now.speed + now.spin * c.radius : 0;
    const double hold = -c.drive / (1 + c.shape);
    const bool rolls = slip == 0 && std::abs(hold) <= c.static_friction * c.load;
    const double against = slip == 0 ? c.drive : slip;
    const double friction = rolls ? hold : -std::copysign(c.dynamic_friction * c.load, against);
    const double a = c.drive + friction;
    const double alpha = friction * c.shape / c.radius;
    double step = std::min(h, left);
    const double change = a + alpha * c.radius;
    slips = !rolls;
    if (slip != 0 && slip * (slip + change * step) <= 0) {
      step = -slip / change;
      slips = false;
    }
    now = {now.distance + step * (now.speed + step * a / 2), now.speed + step * a,
           now.angle + step * (now.spin + step * alpha / 2), now.spin + step * alpha};
    left -= step;
  }
  return now;
}

TEST(Roll, AgreesWithCoulombsLawStepByStep) {
  const Roll::Case thrown{.speed = 6, .radius = 0.5, .load = 10, .static_friction = 0.3, .dynamic_friction = 0.2};
  Roll::Case backspin = thrown;
  backspin.spin = 30;
  Roll::Case uphill = thrown;
  uphill.drive = -3;
  Roll::Case steep = thrown;
  steep.drive = 15;
  Roll::Case hoop = uphill;
  hoop.shape = 1;
  for (const Roll::Case& c : {thrown, backspin, uphill, steep, hoop}) {
    for (const double t : {0.2, 1.0, 3.0}) {
      const Roll::State expected = integrate(c, t);
      const Roll::State state = Roll(c).at(t);
      EXPECT_NEAR(state.distance, expected.distance, 1e-9 * 100) << c.drive << ' ' << c.spin << ' ' << t;
      EXPECT_NEAR(state.speed, expected.speed, 1e-9 * 50);
      EXPECT_NEAR(state.angle, expected.angle, 1e-9 * 100);
      EXPECT_NEAR(state.spin, expected.spin, 1e-9 * 50);
    }
  }
}

TEST(Roll, SlipsUntilVOverThreeMuGThenKeepsTwoThirds) {
  const Roll roll({.speed = 6, .radius = 0.5, .load = 10, .static_friction = 0.2, .dynamic_friction = 0.2});
  EXPECT_DOUBLE_EQ(roll.grip(), 1);
  EXPECT_DOUBLE_EQ(roll.at(1).speed, 4);
  EXPECT_DOUBLE_EQ(roll.at(5).speed, 4);
  EXPECT_DOUBLE_EQ(roll.at(5).spin, -8);
}

TEST(Roll, GoesDownASlopeWithTwoThirdsIffFrictionHolds) {
  const double angle = 0.4;
  const auto on_slope = [angle](double mu) {
    return Roll({.radius = 0.5,
                 .drive = 10 * std::sin(angle),
                 .load = 10 * std::cos(angle),
                 .static_friction = mu,
                 .dynamic_friction = mu});
  };
  const double limit = std::tan(angle) / 3;
  EXPECT_NEAR(on_slope(limit * 1.001).at(1).speed, 20.0 / 3 * std::sin(angle), 1e-14);
  const double weak = limit / 2;
  EXPECT_NEAR(on_slope(weak).at(1).speed, 10 * (std::sin(angle) - weak * std::cos(angle)), 1e-14);
  EXPECT_NEAR(on_slope(weak).at(1).spin, -2 * weak * 10 * std::cos(angle) / 0.5, 1e-14);
}

TEST(Roll, NeverGripsWithoutFriction) {
  const Roll ice({.speed = 6, .radius = 0.5, .load = 10});
  EXPECT_EQ(ice.grip(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(ice.at(9).speed, 6);
}

}  // namespace
}  // namespace plumb
