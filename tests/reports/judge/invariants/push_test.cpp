#include <gtest/gtest.h>

#include "holding.h"

namespace plumb {
namespace {

constexpr double dt = 0.01;
const Stepping exact{.dt = dt, .h = dt, .drift = 0, .impact_lag = 0, .epsilon = 1e-16};

Trace shown(const std::vector<ContactState>& contacts, Vec velocity = {}) {
  return forged(dt, {{box_at({0, 0.5}, velocity), contacts}, {box_at({0, 0.5}, velocity), contacts}});
}

TEST(PushInvariant, ForbidsPullingByMoreThanRoundOff) {
  const Scene scene = box_on_ground();
  EXPECT_EQ(status("push", scene, shown({pushing(1), pushing(-6e-15)}), exact), CheckStatus::held);
  const auto broken = checked("push", scene, shown({pushing(1), pushing(-7e-15)}), exact).value();
  EXPECT_EQ(broken.status, CheckStatus::broken);
  EXPECT_EQ(broken.where, "context - box");
}

}  // namespace
}  // namespace plumb
