#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenarios/statement_of.h"

namespace plumb::sliding_test {
namespace {

using statement_of::Of;

// Symplectic Euler on a body that touches the ground only from the second step on: it falls for one step, and the
// impact has the friction that was missing.
double speed_of_a_late_contact(double v, double mu, double time, double h) {
  double fall = 0;
  const int steps = static_cast<int>(std::lround(time / h));
  for (int i = 0; i < steps; ++i) {
    fall += 10 * h;
    if (i == 0) continue;
    v -= mu * fall;
    fall = 0;
  }
  return v;
}

TEST(Sliding, IsAsFastIfItsContactIsFoundLate) { EXPECT_NEAR(speed_of_a_late_contact(12, 0.4, 1, 1.0 / 60), 8, 1e-12); }

// Friction off by 2 % of itself, in the scenario with the least friction.
TEST(MixingRules, StopFrictionThatIsTwoPercentOff) {
  EXPECT_LT((Of{"mixing-rules", {}, "box", Quantity::vx}.allows_at_most()), 0.02 * 4);
  EXPECT_LT((Of{"mixing-rules", {{"rule", 5}}, "box", Quantity::vx}.allows_at_most()), 0.02 * 1.6);
}

TEST(Slope, StopsAFrictionlessBoxAndOneThatSticks) {
  const double angle = (std::atan(0.5) * 180 / 3.141592653589793) + 1;
  const Of slides{"slope", {{"angle", angle}, {"friction", 0.5}}, "box", Quantity::speed};
  EXPECT_LT(slides.allows_at_most(), 0.39 / 20);
}

// It turns by .38 rad in a second.
TEST(Tipping, StopsABoxThatDoesNotTip) {
  EXPECT_LT((Of{"tipping", {}, "box", Quantity::angle}.allows_at_most()), 0.379 / 5);
}

// A ladder of 38 degrees has turned by .087 rad when its top leaves the wall.
TEST(Ladder, StopsOneThatDoesNotSlide) {
  const Of angle{"ladder", {{"angle", 38}}, "ladder", Quantity::angle};
  EXPECT_LT(angle.allows_at_most(), 0.0865 / 2);
}

TEST(FlushTiles, StopABoxThatAnInnerEdgeSlowsByATenth) {
  EXPECT_LT((Of{"flush-tiles", {}, "box", Quantity::vx}.allows_at_most()), 4 / 10.);
}

}  // namespace
}  // namespace plumb::sliding_test
