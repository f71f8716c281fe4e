#include <gtest/gtest.h>

#include <cmath>

#include "holding.h"

namespace plumb {
namespace {

constexpr double dt = 0.01;
const Stepping exact{.dt = dt, .h = dt, .drift = 0, .impact_lag = 0, .epsilon = 1e-16};

Trace shown(const std::vector<ContactState>& contacts, Vec velocity = {}) {
  return forged(dt, {{box_at({0, 0.5}, velocity), contacts}, {box_at({0, 0.5}, velocity), contacts}});
}

TEST(StickingInvariant, ForbidsToSlideWithFrictionToSpare) {
  const Scene scene = box_on_ground(0.5);
  // The impulse itself changes a speed by hypot(1, 0.25) (1 + 0.5^2 6) m/s at the contact, 0.5 m from the centre.
  const auto sliding = [&](double speed, double tangent) { return shown({pushing(1, tangent)}, {speed, 0}); };
  const double allowed = std::hypot(1, 0.25) * (1 + 6 * 0.25);
  EXPECT_EQ(status("sticking", scene, sliding(0.99 * allowed, 0.25), exact), CheckStatus::held);
  EXPECT_EQ(status("sticking", scene, sliding(1.01 * allowed, 0.25), exact), CheckStatus::broken);
  EXPECT_EQ(status("sticking", scene, sliding(100, 0.5), exact), CheckStatus::held);
}

}  // namespace
}  // namespace plumb
