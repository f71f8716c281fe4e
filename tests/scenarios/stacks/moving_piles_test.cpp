#include <gtest/gtest.h>

#include <cmath>

#include "scenarios/scenario.h"

namespace plumb::moving_piles_test {
namespace {

// Without friction the pyramid falls along the slope with g sin a; at the angle of friction, tan a = mu, it coasts,
// that is stands still.
TEST(SlidingPyramid, SlidesFreelyWithoutFrictionAndHardlyAtTheAngleOfFriction) {
  const Scenario& scenario = *Catalog<Scenario>::find("sliding-pyramid");
  const auto slid = [&](double angle, double friction, double excess = 0) {
    const Parameters p = complete(scenario, {{"angle", angle}, {"friction", friction}, {"excess", excess}});
    const Scene scene = scenario.scene(p);
    const Vec start = scene.bodies[1].position;
    const auto all = scenario.expectations(p);
    return std::hypot(*all[0].expected - start.x, *all[1].expected - start.y);
  };
  const double degree = std::acos(-1) / 180;
  constexpr double duration = 1.5;
  EXPECT_NEAR(slid(30, 0), 10 * 0.5 / 2 * duration * duration, 1e-12);
  EXPECT_NEAR(slid(12, 0.2), 5 * duration * duration * std::abs(std::sin(12 * degree) - 0.2 * std::cos(12 * degree)),
              1e-12);
  EXPECT_LT(slid(12, 0.2), 0.2);
  EXPECT_EQ(slid(20, 0.1, 0.9), slid(20, 0.1)) << "the friction of sticking is too little to hold it";
}

}  // namespace
}  // namespace plumb::moving_piles_test
