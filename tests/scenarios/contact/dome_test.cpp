#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/scenarios/statement_of.h"

namespace plumb::dome_test {
namespace {

using statement_of::Of;

double expected(const Parameters& changes, Quantity quantity) {
  return *Of{"dome", changes, "disc", quantity}.expectations().back().expected;
}

double leaving_speed(double share, double degrees) {
  const double cosine = share * std::cos(degrees * std::numbers::pi / 180);
  return std::sqrt(10 * 2 * cosine) * cosine;
}

// At the moment it leaves, v^2 = g R cos a, and vx stays after that. The cosine follows from energy: without friction
// v^2 = 2 g R (cos0 - cos), and of a disc that rolls 4/3 g R (cos0 - cos).
TEST(Dome, LosesASmoothDiscAtTwoThirdsOfTheCosine) {
  for (const double degrees : {10.0, 20.0, 45.0}) {
    EXPECT_NEAR(expected({{"angle", degrees}}, Quantity::vx), leaving_speed(2.0 / 3, degrees), 1e-9);
    EXPECT_EQ(expected({{"angle", degrees}}, Quantity::angular_velocity), 0);
  }
}

// However rough, it slips at last; the difference to rolling all the way vanishes with 1/mu.
TEST(Dome, LosesAVeryRoughDiscAtFourSeventhsOfTheCosine) {
  const double rolled = leaving_speed(4.0 / 7, 20);
  const double ten = expected({{"friction", 10}}, Quantity::vx) - rolled;
  const double twenty = expected({{"friction", 20}}, Quantity::vx) - rolled;
  EXPECT_LT(std::abs(ten), 0.01);
  EXPECT_LT(std::abs(twenty), 0.6 * std::abs(ten));
}

// What never leaves, or a hoop: w^2 of one half of a slider's in place of two thirds.
TEST(Dome, StopsASmoothDiscThatIsTakenForARollingOne) {
  const Of speed{"dome", {}, "disc", Quantity::vx};
  for (const Stepping& stated : statement_of::all()) {
    if (stated.order == 1) continue;  // their tolerance is larger: half a step of a motion that grows
    EXPECT_LT(speed.allows(stated), leaving_speed(2.0 / 3, 20) - leaving_speed(4.0 / 7, 20));
  }
}

}  // namespace
}  // namespace plumb::dome_test
