#include <gtest/gtest.h>

#include "tests/reports/invariants/holding.h"

// Those that are told from the states alone, energy aside.
namespace plumb {
namespace {

constexpr double dt = 0.01;
const Stepping first_order{.dt = dt, .h = dt, .drift = 0.5, .impact_lag = 1, .gap = 0.005};
const Stepping exact{.dt = dt, .h = dt, .drift = 0, .impact_lag = 0};

Scene two_boxes() {
  const Surface surface{.density = 1};
  return {.gravity = {},
          .bodies = {{.name = "a", .shapes = {{Box{}, surface}}},
                     {.name = "b", .position = {3, 0}, .shapes = {{Box{}, surface}}}}};
}

Trace after_a_push(Vec a, Vec b, double spin = 0) {
  return forged(dt, {{{{}, {.position = {3, 0}}}},
                     {{{.velocity = a, .angular_velocity = spin}, {.position = {3, 0}, .velocity = b}}}});
}

TEST(MomentumInvariant, IsBrokenByAnUnequalPush) {
  Stepping rounded = exact;
  rounded.epsilon = 1e-3;  // three roundings of 2 kg m/s
  EXPECT_EQ(standing("momentum", two_boxes(), after_a_push({1, 0}, {-1, 0}), exact), Standing::held);
  EXPECT_EQ(standing("momentum", two_boxes(), after_a_push({1, 0}, {-1.005, 0}), rounded), Standing::held);
  EXPECT_EQ(standing("momentum", two_boxes(), after_a_push({1, 0}, {-1.007, 0}), rounded), Standing::broken);
}

TEST(MomentumInvariant, SeesAPushThatTurnsTheWhole) {
  EXPECT_EQ(standing("angular_momentum", two_boxes(), after_a_push({1, 0}, {-1, 0}), exact), Standing::held);
  EXPECT_EQ(standing("momentum", two_boxes(), after_a_push({0, 1}, {0, -1}), exact), Standing::held);
  EXPECT_EQ(standing("angular_momentum", two_boxes(), after_a_push({0, 1}, {0, -1}), exact), Standing::broken);
  // 3 m apart: I = 1/6 turns against it.
  EXPECT_EQ(standing("angular_momentum", two_boxes(), after_a_push({0, 1}, {0, -1}, 18), {.epsilon = 1e-15}),
            Standing::held);
}

TEST(MomentumInvariant, SaysNothingWhereSomethingImmovableIs) {
  const Scene scene = box_on_ground();
  const Trace trace = forged(dt, {{box_at({0, 5})}, {box_at({0, 5})}});
  EXPECT_FALSE(checked("momentum", scene, trace, exact).has_value());
}

TEST(OverlapInvariant, AllowsTheGapAndTheWayOfAHitNoticedLate) {
  const Scene scene = box_on_ground();
  const auto sunk = [](double depth) {
    return forged(dt, {{box_at({0, 0.6}, {0, -2})}, {box_at({0, 0.5 - depth}, {0, 0})}});
  };
  EXPECT_EQ(standing("overlap", scene, sunk(0.0249), first_order), Standing::held);
  const auto broken = checked("overlap", scene, sunk(0.0251), first_order).value();
  EXPECT_EQ(broken.standing, Standing::broken);
  EXPECT_EQ(broken.where, "ground - box");
  EXPECT_EQ(standing("overlap", scene, sunk(0.0001), exact), Standing::broken);
}

Trace lying(Vec by) {
  std::vector<Moment> moments(150, {box_at({0, 0.5})});
  moments.resize(300, {box_at({by.x, 0.5 + by.y})});
  return forged(dt, moments);
}

TEST(RestInvariant, ForbidsToCreepWhatHasComeToRest) {
  const Scene scene = box_on_ground(0.5, {0, -10});
  EXPECT_EQ(standing("rest", scene, lying({0.0049, 0}), first_order), Standing::held);
  EXPECT_EQ(standing("rest", scene, lying({0.0051, 0}), first_order), Standing::broken);
  EXPECT_EQ(standing("rest", scene, lying({0, -0.0051}), first_order), Standing::broken);
  Stepping creeping = first_order;
  creeping.creep = 0.001;  // m/s, over 1.99 s
  EXPECT_EQ(standing("rest", scene, lying({0.0054, 0}), creeping), Standing::held);
}

TEST(RestInvariant, LetsRoundThingsRoll) {
  Scene scene = box_on_ground(0.5, {0, -10});
  scene.bodies[1].shapes = {{Circle{}, scene.bodies[1].shapes[0].surface}};
  EXPECT_FALSE(checked("rest", scene, lying({1, 0}), first_order).has_value());
}

}  // namespace
}  // namespace plumb
