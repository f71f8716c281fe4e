#include <gtest/gtest.h>

#include <cmath>

#include "forged_runs.h"

namespace plumb::contact_laws_test {
namespace {

constexpr double dt = 0.01;
const Stepping exact{.dt = dt, .h = dt, .drift = 0, .impact_lag = 0, .epsilon = 1e-16};
const Stepping first_order{.dt = dt, .h = dt, .drift = 0.5, .impact_lag = 1, .epsilon = 1e-16};

Trace shown(const std::vector<ContactState>& contacts, Vec velocity = {}) {
  return forged(dt, {{box_at({0, 0.5}, velocity), contacts}, {box_at({0, 0.5}, velocity), contacts}});
}

TEST(PushInvariant, AllowsPullsUpToRoundOff) {
  const Scene scene = box_on_ground();
  EXPECT_EQ(status("push", scene, shown({pushing(1), pushing(-6e-15)}), exact), CheckStatus::held);
  const auto broken = checked("push", scene, shown({pushing(1), pushing(-7e-15)}), exact).value();
  EXPECT_EQ(broken.status, CheckStatus::broken);
  EXPECT_EQ(broken.where, "ground - box");
}

TEST(ConeInvariant, LimitsFrictionToItsCoefficient) {
  const Scene scene = box_on_ground(0.5);
  EXPECT_EQ(status("cone", scene, shown({pushing(2, -1)}), exact), CheckStatus::held);
  EXPECT_EQ(status("cone", scene, shown({pushing(2, -1 - 1e-14)}), exact), CheckStatus::held);
  EXPECT_EQ(status("cone", scene, shown({pushing(2, -1 - 2e-14)}), exact), CheckStatus::broken);
}

TEST(ConeInvariant, LetsAFirstOrderMethodUseTheNormalImpulseOfTheStepBefore) {
  const Scene scene = box_on_ground(0.5);
  const auto falling_off = [](double tangent) {
    return forged(dt, {{box_at({0, 0.5}), {pushing(3, 1)}}, {box_at({0, 0.5}), {pushing(2, tangent)}}});
  };
  EXPECT_EQ(status("cone", scene, falling_off(1.499), first_order), CheckStatus::held);
  EXPECT_EQ(status("cone", scene, falling_off(1.501), first_order), CheckStatus::broken);
  EXPECT_EQ(status("cone", scene, falling_off(1.499), exact), CheckStatus::broken);
}

TEST(ComplementarityInvariant, ForbidsAPushWithoutTouch) {
  const Scene scene = box_on_ground();
  const auto apart = [](double gap) {
    return forged(dt, {{box_at({0, 0.5})}, {box_at({0, 0.5 + gap}), {pushing(1)}}});
  };
  Stepping with_gap = exact;
  with_gap.skin = 0.01;
  // Twice the gap, plus how far 1 N s moves 1 kg in 0.01 s.
  EXPECT_EQ(status("complementarity", scene, apart(0.0299), with_gap), CheckStatus::held);
  EXPECT_EQ(status("complementarity", scene, apart(0.0301), with_gap), CheckStatus::broken);
}

TEST(ComplementarityInvariant, AllowsForTheSpinThatAPushAtACornerGives) {
  const Scene scene = box_on_ground();
  ContactState corner = pushing(1);
  corner.point = {0.5, 0};
  const auto apart = [&](double gap) { return forged(dt, {{box_at({0, 0.5})}, {box_at({0, 0.5 + gap}), {corner}}}); };
  // 1 m/s, and at an arm of about (.5, -.5) 1 N s x .5 m / (1/6) kg m^2 = 3 rad/s: 1 + 3 x .72 m/s.
  EXPECT_EQ(status("complementarity", scene, apart(0.031), exact), CheckStatus::held);
  EXPECT_EQ(status("complementarity", scene, apart(0.033), exact), CheckStatus::broken);
}

TEST(ComplementarityInvariant, AllowsForAThirdBodyThatStopsTheMotionThatAPushStarted) {
  Scene scene = box_on_ground();
  scene.bodies.push_back(scene.bodies[1]);
  scene.bodies[2].name = "box above";
  const auto boxes = [](double lower) {
    auto states = box_at({0, lower});
    states.push_back({.position = {0, lower + 1}});
    return states;
  };
  ContactState above = pushing(1);
  above.a = 1;
  above.b = 2;
  above.point = {0, 1};
  const auto apart = [&](double gap) { return forged(dt, {{boxes(0.5)}, {boxes(0.5 + gap), {pushing(1), above}}}); };
  // Each changes the velocity of the lower box by 1 m/s.
  EXPECT_EQ(status("complementarity", scene, apart(0.0199), exact), CheckStatus::held);
  EXPECT_EQ(status("complementarity", scene, apart(0.0201), exact), CheckStatus::broken);
}

TEST(StickingInvariant, ForbidsSlidingWithUnusedFriction) {
  const Scene scene = box_on_ground(0.5);
  // The impulse itself changes a speed by hypot(1, 0.25) (1 + 0.5^2 6) m/s at the contact, 0.5 m from the centre.
  const auto sliding = [&](double speed, double tangent) { return shown({pushing(1, tangent)}, {speed, 0}); };
  const double tolerance = std::hypot(1, 0.25) * (1 + 6 * 0.25);
  EXPECT_EQ(status("sticking", scene, sliding(0.99 * tolerance, 0.25), exact), CheckStatus::held);
  EXPECT_EQ(status("sticking", scene, sliding(1.01 * tolerance, 0.25), exact), CheckStatus::broken);
  EXPECT_EQ(status("sticking", scene, sliding(100, 0.5), exact), CheckStatus::held);
}

}  // namespace
}  // namespace plumb::contact_laws_test
