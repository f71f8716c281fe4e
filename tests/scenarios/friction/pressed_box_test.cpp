#include <gtest/gtest.h>

#include "tests/scenarios/statement_of.h"

namespace plumb::pressed_box_test {
namespace {

using statement_of::Of;

double speed(double press, double friction) {
  return *Of{"pressed-box", {{"press", press}, {"friction", friction}}, "box", Quantity::vy}
              .expectations()
              .front()
              .expected;
}

TEST(PressedBox, FallsFreelyWithoutFrictionAndNotAtAllFromTheLimitOn) {
  EXPECT_NEAR(speed(20, 0), -10, 1e-12);
  EXPECT_NEAR(speed(0.1, 0.5), -10 + 0.05, 1e-12);
  EXPECT_NEAR(speed(20, 0.4999), 0, 0.01);
  EXPECT_EQ(speed(20, 0.5001), 0);
  EXPECT_EQ(speed(100, 0.5), 0);
}

TEST(PressedBox, StopsAFrictionlessOne) {
  EXPECT_LT((Of{"pressed-box", {}, "box", Quantity::vy}.allows_at_most()), 10.0 / 20);
  EXPECT_LT((Of{"pressed-box", {{"friction", 0.2}}, "box", Quantity::vy}.allows_at_most()), 4.0 / 2);
}

}  // namespace
}  // namespace plumb::pressed_box_test
