#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "scenarios/integrate.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::arc_bowl_test {
namespace {

using statement_of::Of;

constexpr double swings = 2.5;  // m, the radius on which the disc's centre moves
constexpr double pi = 3.14159265358979323846;

double expected_x(double degrees, double kink, std::size_t reading) {
  return *Of{"arc-bowl", {{"angle", degrees}, {"kink", kink}}, "disc", Quantity::x}.expectations().at(reading).expected;
}

// (3/2) m (R - r)^2 q'' = -m g (R - r) sin q: with ever smaller kinks the segments are an arc, and the difference is of
// first order in the kinks.
TEST(ArcBowl, TendsToAPendulumOnItsArc) {
  for (const double degrees : {21.0, 60.0}) {
    const auto all = Of{"arc-bowl", {{"angle", degrees}}, "disc", Quantity::x}.expectations();
    for (const std::size_t reading : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
      const auto rate = [](const std::array<double, 2>& s) {
        return std::array<double, 2>{s[1], -10 / (1.5 * swings) * std::sin(s[0])};
      };
      const double angle =
          integrated(std::array<double, 2>{-degrees * pi / 180, 0}, *all[reading].time, 10000, rate)[0];
      const double arc = swings * std::sin(angle);
      const double coarse = expected_x(degrees, 3, reading) - arc;
      const double fine = expected_x(degrees, 0.5, reading) - arc;
      EXPECT_LT(std::abs(fine), 0.02) << degrees;
      if (reading == 1) {
        EXPECT_LT(std::abs(fine), std::abs(coarse) / 3) << "where it turns back";
      }
    }
  }
}

// The period grows with the amplitude as 1/agm(1, cos(a/2)): the duration is three quarters of it.
TEST(ArcBowl, LastsLongerForALargerAmplitude) {
  const Scenario& family = *Catalog<Scenario>::find("arc-bowl");
  const auto duration = [&](double degrees) { return family.scene(complete(family, {{"angle", degrees}})).duration; };
  const double small = 0.75 * 2 * pi * std::sqrt(1.5 * swings / 10);
  EXPECT_NEAR(duration(10), small * (1 + std::pow(10 * pi / 180, 2) / 16), 1.0 / 60);
  EXPECT_NEAR(duration(60), small * 1.0732, 1.0 / 60);
}

// One that slides without friction swings faster by sqrt(3/2).
TEST(ArcBowl, StopsADiscThatSlides) {
  EXPECT_LT((Of{"arc-bowl", {}, "disc", Quantity::x}.allows(statement_of::accurate())), 0.1);
  EXPECT_LT((Of{"arc-bowl", {}, "disc", Quantity::angle}.allows_at_most()), 2);
}

}  // namespace
}  // namespace plumb::arc_bowl_test
