#include <gtest/gtest.h>

#include "forged_runs.h"

namespace plumb::positions_test {
namespace {

constexpr double dt = 0.01;
const Stepping exact{.dt = dt, .h = dt, .drift = 0, .impact_lag = 0};
const Stepping first_order{.dt = dt, .h = dt, .drift = 0.5, .impact_lag = 1, .skin = 0.005};

TEST(OverlapInvariant, AllowsTheGapAndTheDistanceBeforeAnImpactIsNoticed) {
  const Scene scene = box_on_ground();
  const auto sunk = [](double depth) {
    return forged(dt, {{box_at({0, 0.6}, {0, -2})}, {box_at({0, 0.5 - depth}, {0, 0})}});
  };
  EXPECT_EQ(status("overlap", scene, sunk(0.0249), first_order), CheckStatus::held);
  const auto broken = checked("overlap", scene, sunk(0.0251), first_order).value();
  EXPECT_EQ(broken.status, CheckStatus::broken);
  EXPECT_EQ(broken.where, "ground - box");
  EXPECT_EQ(status("overlap", scene, sunk(0.0001), exact), CheckStatus::broken);
}

// An impact at 2 m/s that is noticed late may leave an overlap of 2.5 cm, which may only shrink, whatever speed the box
// had once.
TEST(OverlapInvariant, ForgetsTheSpeedOfAnEarlierImpact) {
  const Scene scene = box_on_ground();
  const auto sinking = [](double first, double second) {
    return forged(dt, {{box_at({0, 0.505}, {0, -2})},
                       {box_at({0, 0.5 - first})},
                       {box_at({0, 0.5 - first})},
                       {box_at({0, 0.5 - first})},
                       {box_at({0, 0.5 - second})}});
  };
  EXPECT_EQ(status("overlap", scene, sinking(0.02, 0.02), first_order), CheckStatus::held);
  EXPECT_EQ(status("overlap", scene, sinking(0.02, 0.01), first_order), CheckStatus::held);
  EXPECT_EQ(status("overlap", scene, sinking(0.02, 0.021), first_order), CheckStatus::broken);
}

TEST(OverlapInvariant, IsTestedOnlyWhereBodiesTouch) {
  const auto at = [](double y) { return forged(dt, {{box_at({0, y})}, {box_at({0, y})}}); };
  EXPECT_TRUE(is_evidence(checked("overlap", box_on_ground(), at(0.5), first_order).value()));
  EXPECT_FALSE(is_evidence(checked("overlap", box_on_ground(), at(0.6), first_order).value()));
}

Trace lying(Vec by) {
  std::vector<Moment> moments(150, {box_at({0, 0.5})});
  moments.resize(300, {box_at({by.x, 0.5 + by.y})});
  return forged(dt, moments);
}

TEST(RestInvariant, ForbidsBodiesAtRestToCreep) {
  const Scene scene = box_on_ground(0.5, {0, -10});
  EXPECT_EQ(status("rest", scene, lying({0.0049, 0}), first_order), CheckStatus::held);
  EXPECT_EQ(status("rest", scene, lying({0.0051, 0}), first_order), CheckStatus::broken);
  EXPECT_EQ(status("rest", scene, lying({0, -0.0051}), first_order), CheckStatus::broken);
  Stepping creeping = first_order;
  creeping.creep = 0.001;  // m/s, over 1.99 s
  EXPECT_EQ(status("rest", scene, lying({0.0054, 0}), creeping), CheckStatus::held);
}

// A spring under a box closes or opens as its load shifts.
TEST(RestInvariant, LetsContactsThatAreSpringsMoveByTheirDepth) {
  const Scene scene = box_on_ground(0.5, {0, -10});
  const auto sunk = [](double by) {
    std::vector<Moment> moments(150, {box_at({0, 0.494})});
    moments.resize(300, {box_at({by, 0.494})});
    return forged(dt, moments);
  };
  Stepping springs = first_order;
  EXPECT_EQ(status("rest", scene, sunk(0.0055), springs), CheckStatus::broken);
  springs.contact_frequency = 30;
  EXPECT_EQ(status("rest", scene, sunk(0.0055), springs), CheckStatus::held);
  EXPECT_EQ(status("rest", scene, sunk(0.0065), springs), CheckStatus::broken);
}

TEST(RestInvariant, LetsBodiesSlideWhereFrictionAllButHoldsThem) {
  const auto tilted = [](double slope) { return box_on_ground(0.5, {10 * slope, -10}); };
  EXPECT_TRUE(checked("rest", tilted(0.499), lying({}), first_order).has_value());
  EXPECT_FALSE(checked("rest", tilted(0.501), lying({}), first_order).has_value());
  EXPECT_EQ(status("rest", tilted(0.499), lying({0.01, 0}), first_order), CheckStatus::broken);
}

TEST(RestInvariant, LetsRoundBodiesRoll) {
  Scene scene = box_on_ground(0.5, {0, -10});
  scene.bodies[1].shapes = {{Circle{}, scene.bodies[1].shapes[0].surface}};
  EXPECT_FALSE(checked("rest", scene, lying({1, 0}), first_order).has_value());
}

}  // namespace
}  // namespace plumb::positions_test
