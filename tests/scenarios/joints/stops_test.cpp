#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

#include "scenarios/integrate.h"
#include "scenarios/scenario.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::stops_test {
namespace {

using statement_of::Of;

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

// A rod of 2 m falls from level: q'' = (3/4) g cos q. It reaches every limit long before the end, and its weight
// presses it on the stop from then on, as all limits are above the vertical.
TEST(JointStop, IsReachedLongBeforeTheEnd) {
  for (const double degrees : {5.0, 60.0, 80.0}) {
    const double limit = degrees * std::acos(-1) / 180;
    const auto rate = [](const std::array<double, 2>& s) {
      return std::array<double, 2>{s[1], 0.75 * 10 * std::cos(s[0])};
    };
    EXPECT_GT(integrated(std::array<double, 2>{0, 0}, 1.5, 1000, rate)[0], limit);
    EXPECT_GT(std::cos(limit), 0);
  }
}

TEST(JointStop, LeavesTheRodOnItsCircle) {
  for (const double degrees : {5.0, 60.0, 80.0}) {
    const Parameters changes{{"limit", degrees}};
    const double x = *Of{"joint-stop", changes, "rod", Quantity::x}.expectations().front().expected;
    const double y = *Of{"joint-stop", changes, "rod", Quantity::y}.expectations().front().expected;
    const double angle = *Of{"joint-stop", changes, "rod", Quantity::angle}.expectations().front().expected;
    EXPECT_NEAR(std::hypot(x, y), 1, 1e-12);
    EXPECT_NEAR(std::atan2(y, x), angle, 1e-12);
    EXPECT_NEAR(angle, -degrees * std::acos(-1) / 180, 1e-12);
  }
}

// One that rebounds or passes is farther off than a hundredth of a radian at almost every moment.
TEST(JointStop, StopsAHingeWithoutALimit) {
  EXPECT_LT((Of{"joint-stop", {}, "rod", Quantity::angle}.allows_at_most()), 0.01);
}

// Of 5 mm, a metre from the hinge, and of 2 degrees: a hinge that rests 3 degrees past its limit is wrong, and so is
// one of 2 degrees that states no such slop.
TEST(JointStop, AllowsTheAngleThatAHingeStatesToLeavePastItsLimitAndNoMore) {
  const Of angle{"joint-stop", {}, "rod", Quantity::angle};
  constexpr double degree = std::numbers::pi / 180;
  Stepping stated = statement_of::skinned();
  EXPECT_LT(angle.allows(stated), 2 * degree);
  stated.angular_slop = 2 * degree;
  EXPECT_GT(angle.allows(stated), 2 * degree);
  EXPECT_LT(angle.allows(stated), 3 * degree);
}

// The stop as an impact without a rebound, in an integration in small steps.
TEST(RailStop, AgreesWithAnIntegrationOfTheWayToTheStop) {
  for (const auto& [slope, w, beyond] : {std::array{30.0, 0.0, 1.5}, std::array{10.0, 4.0, 1.5},
                                         std::array{60.0, 1.0, 1.9}, std::array{5.0, 0.05, 1.2}}) {
    const Parameters changes{{"slope", slope}, {"spring", w}, {"beyond", beyond}};
    const double angle = slope * std::numbers::pi / 180;
    const auto rate = [&, w = w, beyond = beyond](const std::array<double, 2>& y) {
      return std::array<double, 2>{y[1], 10 * std::sin(angle) + w * w * (beyond - y[0])};
    };
    const auto places = Of{"rail-stop", changes, "slider", Quantity::x}.expectations();
    const auto speeds = Of{"rail-stop", changes, "slider", Quantity::speed}.expectations();
    const double t = *places.front().time;
    const auto then = integrated<2>({0, 0}, t, 2000, rate);
    EXPECT_NEAR(*places.front().expected, then[0] * std::cos(angle), 1e-9) << slope;
    EXPECT_NEAR(*speeds.front().expected, then[1], 1e-9) << slope;
    EXPECT_NEAR((integrated<2>({0, 0}, t / 0.8, 2000, rate)[0]), 1, 1e-9) << "the stop is at 1 m";
    EXPECT_EQ(*speeds.back().expected, 0);
  }
}

// Without a stop the slider is metres farther at the end; one with e = 1 is still in motion.
TEST(RailStop, StopsASliderThatPassesOrRebounds) {
  EXPECT_LT((Of{"rail-stop", {}, "slider", Quantity::y}.allows_at_most()), 0.03);
  EXPECT_LT((Of{"rail-stop", {}, "slider", Quantity::speed}.allows_at_most()), 0.01);
}

}  // namespace
}  // namespace plumb::stops_test
