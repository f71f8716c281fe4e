#include <gtest/gtest.h>

#include "holding.h"

namespace plumb {
namespace {

constexpr double dt = 0.01;
const Stepping exact{.dt = dt, .h = dt, .drift = 0, .impact_lag = 0, .epsilon = 1e-16};
const Stepping first_order{.dt = dt, .h = dt, .drift = 0.5, .impact_lag = 1, .epsilon = 1e-16};

Trace shown(const std::vector<ContactState>& contacts, Vec velocity = {}) {
  return forged(dt, {{box_at({0, 0.5}, velocity), contacts}, {box_at({0, 0.5}, velocity), contacts}});
}

TEST(ConeInvariant, HoldsFrictionToItsCoefficient) {
  const Scene scene = box_on_ground(0.5);
  EXPECT_EQ(status("cone", scene, shown({pushing(2, -1)}), exact), CheckStatus::held);
  EXPECT_EQ(status("cone", scene, shown({pushing(2, -1 - 1e-14)}), exact), CheckStatus::held);
  EXPECT_EQ(status("cone", scene, shown({pushing(2, -1 - 2e-14)}), exact), CheckStatus::broken);
}

TEST(ConeInvariant, LetsAFirstOrderMethodTakeThePushOfTheStepBefore) {
  const Scene scene = box_on_ground(0.5);
  const auto falling_off = [](double tangent) {
    return forged(dt, {{box_at({0, 0.5}), {pushing(3, 1)}}, {box_at({0, 0.5}), {pushing(2, tangent)}}});
  };
  EXPECT_EQ(status("cone", scene, falling_off(1.499), first_order), CheckStatus::held);
  EXPECT_EQ(status("cone", scene, falling_off(1.501), first_order), CheckStatus::broken);
  EXPECT_EQ(status("cone", scene, falling_off(1.499), exact), CheckStatus::broken);
}

}  // namespace
}  // namespace plumb
