#include <gtest/gtest.h>

#include "holding.h"

namespace plumb {
namespace {

constexpr double dt = 0.01;
const Stepping exact{.dt = dt, .h = dt, .drift = 0, .impact_lag = 0};
const Stepping first_order{.dt = dt, .h = dt, .drift = 0.5, .impact_lag = 1, .gap = 0.005};

TEST(OverlapInvariant, AllowsTheGapAndTheWayOfAHitNoticedLate) {
  const Scene scene = box_on_ground();
  const auto sunk = [](double depth) {
    return forged(dt, {{box_at({0, 0.6}, {0, -2})}, {box_at({0, 0.5 - depth}, {0, 0})}});
  };
  EXPECT_EQ(status("overlap", scene, sunk(0.0249), first_order), CheckStatus::held);
  const auto broken = checked("overlap", scene, sunk(0.0251), first_order).value();
  EXPECT_EQ(broken.status, CheckStatus::broken);
  EXPECT_EQ(broken.where, "context - box");
  EXPECT_EQ(status("overlap", scene, sunk(0.0001), exact), CheckStatus::broken);
}

}  // namespace
}  // namespace plumb
