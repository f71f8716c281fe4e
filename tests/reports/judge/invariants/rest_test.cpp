#include <gtest/gtest.h>

#include "holding.h"

namespace plumb {
namespace {

constexpr double dt = 0.01;
const Stepping first_order{.dt = dt, .h = dt, .drift = 0.5, .impact_lag = 1, .gap = 0.005};

Trace lying(Vec by) {
  std::vector<Moment> moments(150, {box_at({0, 0.5})});
  moments.resize(300, {box_at({by.x, 0.5 + by.y})});
  return forged(dt, moments);
}

TEST(RestInvariant, ForbidsToCreepWhatHasComeToRest) {
  const Scene scene = box_on_ground(0.5, {0, -10});
  EXPECT_EQ(status("rest", scene, lying({0.0049, 0}), first_order), CheckStatus::held);
  EXPECT_EQ(status("rest", scene, lying({0.0051, 0}), first_order), CheckStatus::broken);
  EXPECT_EQ(status("rest", scene, lying({0, -0.0051}), first_order), CheckStatus::broken);
  Stepping creeping = first_order;
  creeping.creep = 0.001;  // m/s, over 1.99 s
  EXPECT_EQ(status("rest", scene, lying({0.0054, 0}), creeping), CheckStatus::held);
}

TEST(RestInvariant, LetsRoundThingsRoll) {
  Scene scene = box_on_ground(0.5, {0, -10});
  scene.bodies[1].shapes = {{Circle{}, scene.bodies[1].shapes[0].surface}};
  EXPECT_FALSE(checked("rest", scene, lying({1, 0}), first_order).has_value());
}

}  // namespace
}  // namespace plumb
