#include <gtest/gtest.h>

#include "holding.h"

namespace plumb {
namespace {

constexpr double dt = 0.01;
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
  EXPECT_EQ(status("momentum", two_boxes(), after_a_push({1, 0}, {-1, 0}), exact), CheckStatus::held);
  EXPECT_EQ(status("momentum", two_boxes(), after_a_push({1, 0}, {-1.005, 0}), rounded), CheckStatus::held);
  EXPECT_EQ(status("momentum", two_boxes(), after_a_push({1, 0}, {-1.007, 0}), rounded), CheckStatus::broken);
}

TEST(MomentumInvariant, SeesAPushThatTurnsTheWhole) {
  EXPECT_EQ(status("angular_momentum", two_boxes(), after_a_push({1, 0}, {-1, 0}), exact), CheckStatus::held);
  EXPECT_EQ(status("momentum", two_boxes(), after_a_push({0, 1}, {0, -1}), exact), CheckStatus::held);
  EXPECT_EQ(status("angular_momentum", two_boxes(), after_a_push({0, 1}, {0, -1}), exact), CheckStatus::broken);
  // 3 m apart: I = 1/6 turns against it.
  EXPECT_EQ(status("angular_momentum", two_boxes(), after_a_push({0, 1}, {0, -1}, 18), {.epsilon = 1e-15}),
            CheckStatus::held);
}

TEST(MomentumInvariant, SaysNothingWhereSomethingImmovableIs) {
  const Scene scene = box_on_ground();
  const Trace trace = forged(dt, {{box_at({0, 5})}, {box_at({0, 5})}});
  EXPECT_FALSE(checked("momentum", scene, trace, exact).has_value());
}

}  // namespace
}  // namespace plumb
