#include <gtest/gtest.h>

#include "tests/reports/invariants/holding.h"

namespace plumb {
namespace {

constexpr double dt = 0.01;
const Stepping exact{.dt = dt, .h = dt, .drift = 0, .impact_lag = 0, .epsilon = 1e-16};

TEST(BodyMomentumInvariant, HoldsBodiesToTheImpulsesShown) {
  const Scene scene = box_on_ground(0.5, {0, -10});
  const auto moved = [&](double vy) {
    return forged(dt, {{box_at({0, 0.5}, {0, -1})}, {box_at({0, 0.5}, {0, vy}), {pushing(1.1, 0)}}});
  };
  EXPECT_EQ(standing("momentum_of_bodies", scene, moved(0), exact), Standing::held);
  EXPECT_EQ(standing("momentum_of_bodies", scene, moved(2e-14), exact), Standing::held);
  const auto broken = checked("momentum_of_bodies", scene, moved(1e-12), exact).value();
  EXPECT_EQ(broken.standing, Standing::broken);
  EXPECT_EQ(broken.where, "box");
}

}  // namespace
}  // namespace plumb
