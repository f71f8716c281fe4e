#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "scenarios/integrate.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::rail_stop_test {
namespace {

using statement_of::Of;

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
}  // namespace plumb::rail_stop_test
