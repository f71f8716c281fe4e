#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <variant>

#include "scenarios/scenario.h"

namespace plumb::held_test {
namespace {

const Scenario& family(const char* name) { return *Catalog<Scenario>::find(name); }

// theta'' = -g/L sin theta, by the classical Runge-Kutta method. Returns the angle at the time.
double swung(double length, double angle, double time) {
  constexpr int steps = 20000;
  const double h = time / steps;
  double a = angle;
  double w = 0;
  const auto pull = [&](double at) { return -10 / length * std::sin(at); };
  for (int i = 0; i < steps; ++i) {
    const double w1 = w, f1 = pull(a);
    const double w2 = w + h / 2 * f1, f2 = pull(a + h / 2 * w1);
    const double w3 = w + h / 2 * f2, f3 = pull(a + h / 2 * w2);
    const double w4 = w + h * f3, f4 = pull(a + h * w3);
    a += h / 6 * (w1 + 2 * w2 + 2 * w3 + w4);
    w += h / 6 * (f1 + 2 * f2 + 2 * f3 + f4);
  }
  return a;
}

TEST(RodPendulum, HasARodForAPeriodOfTwoSecondsAtAnyAmplitude) {
  for (const double degrees : {5.0, 60.0, 120.0}) {
    const Scene scene = family("rod-pendulum").scene(complete(family("rod-pendulum"), {{"angle", degrees}}));
    const double length = std::get<Distance>(scene.joints[0]).length;
    const double angle = degrees * std::acos(-1) / 180;
    EXPECT_NEAR(swung(length, angle, 0.5), 0, 1e-9) << degrees;
    EXPECT_NEAR(swung(length, angle, 1), -angle, 1e-9) << degrees;
  }
}

// In the limit of a vertical rail the sled falls freely; on a level one it keeps its velocity.
TEST(Slider, FallsFreelyOnAVerticalRailAndCoastsOnALevelOne) {
  const auto end = [](double angle, double speed) {
    const auto all = family("slider").expectations(complete(family("slider"), {{"angle", angle}, {"speed", speed}}));
    return std::pair{*all[0].expected, *all[1].expected};
  };
  EXPECT_NEAR(end(90, 0).second, -20, 1e-12);
  EXPECT_NEAR(end(90, 3).second, 6 - 20, 1e-12);
  EXPECT_NEAR(end(0, 3).first, 6, 1e-12);
  EXPECT_NEAR(end(0, 3).second, 0, 1e-12);
}

}  // namespace
}  // namespace plumb::held_test
