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

// An impulse is the change of a velocity, which is rounded by its size.
TEST(PushInvariant, AllowsForTheRoundingOfTheMomentumThatTouches) {
  const Scene scene = box_on_ground();
  const auto fast = [](double push) { return shown({pushing(push)}, {10, 0}); };
  EXPECT_EQ(status("push", scene, fast(-6e-14), exact), CheckStatus::held);
  EXPECT_EQ(status("push", scene, fast(-8e-14), exact), CheckStatus::broken);
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

TEST(ConeInvariant, IsNotTestedByAContactWhoseIterationsEndWithoutAPush) {
  const Scene scene = box_on_ground(0.5);
  Stepping iterated = first_order;
  iterated.iterations = 8;
  const auto slipping = shown({pushing(1e-17, 0.5)});
  const InvariantCheck check = checked("cone", scene, slipping, iterated).value();
  EXPECT_EQ(check.status, CheckStatus::held);
  EXPECT_FALSE(is_evidence(check));
  EXPECT_EQ(status("cone", scene, slipping, first_order), CheckStatus::broken);
  EXPECT_EQ(status("cone", scene, shown({pushing(0.1, 0.5)}), iterated), CheckStatus::broken);
}

TEST(ContactInvariants, AreTestedByRealPushesOnly) {
  const Scene scene = box_on_ground(0.5, {0, -10});
  Stepping in_parts = exact;
  in_parts.h = dt / 10;
  for (const char* name : {"push", "cone", "complementarity", "sticking"}) {
    EXPECT_TRUE(is_evidence(checked(name, scene, shown({pushing(0.1)}), in_parts).value())) << name;
    EXPECT_FALSE(is_evidence(checked(name, scene, shown({pushing(0)}), in_parts).value())) << name;
  }
}

TEST(ComplementarityInvariant, ForbidsAPushWithoutTouch) {
  const Scene scene = box_on_ground();
  const auto apart = [](double gap, double push, double before, double after) {
    return forged(dt, {{box_at({0, 0.5}, {0, before})}, {box_at({0, 0.5 + gap}, {0, after}), {pushing(push)}}});
  };
  Stepping with_gap = exact;
  with_gap.skin = 0.01;
  // Twice the gap, however strong the push.
  for (const double push : {1.0, 1000.0}) {
    EXPECT_EQ(status("complementarity", scene, apart(0.0199, push, 0, 0), with_gap), CheckStatus::held);
    EXPECT_EQ(status("complementarity", scene, apart(0.0201, push, 0, 0), with_gap), CheckStatus::broken);
  }
  // At 1 m/s before and 1 m/s after, it may be anywhere within 2 cm.
  EXPECT_EQ(status("complementarity", scene, apart(0.0199, 2, -1, 1), exact), CheckStatus::held);
  EXPECT_EQ(status("complementarity", scene, apart(0.0201, 2, -1, 1), exact), CheckStatus::broken);
}

// A box that lies on the ground, and one that falls on it at 1 m/s. Both are at rest after the step.
Trace struck_from_above(double gap, double speed, Vec point) {
  const auto boxes = [](double lower, double falls) {
    auto states = box_at({0, lower});
    states.push_back({.position = {0, lower + 1}, .velocity = {0, -falls}});
    return states;
  };
  ContactState above = pushing(1);
  above.a = 1;
  above.b = 2;
  above.point = point;
  return forged(dt, {{boxes(0.5, speed)}, {boxes(0.5 + gap, 0), {pushing(1), above}}});
}

Scene two_on_ground() {
  Scene scene = box_on_ground();
  scene.bodies.push_back(scene.bodies[1]);
  scene.bodies[2].name = "box above";
  scene.bodies[2].position = {0, 1.5};
  return scene;
}

TEST(ComplementarityInvariant, AllowsForAnImpactOfAThirdBody) {
  const Scene scene = two_on_ground();
  // It changes the velocity of the lower box by 1 m/s; the push itself shows in the velocities.
  EXPECT_EQ(status("complementarity", scene, struck_from_above(0.0099, 1, {0, 1}), exact), CheckStatus::held);
  EXPECT_EQ(status("complementarity", scene, struck_from_above(0.0101, 1, {0, 1}), exact), CheckStatus::broken);
  // A load is no impact.
  EXPECT_EQ(status("complementarity", scene, struck_from_above(0.0001, 0, {0, 1}), exact), CheckStatus::broken);
}

// States give the centre of mass, wherever the shapes are in the body's frame: straight above it, an impact turns
// nothing.
TEST(ComplementarityInvariant, TakesArmsFromTheCentreOfMass) {
  Scene scene = two_on_ground();
  scene.bodies[1].shapes[0].geometry = Box{.center = {3, 0}};
  scene.bodies[1].position = {-3, 0.5};
  EXPECT_EQ(status("complementarity", scene, struck_from_above(0.0099, 1, {0, 1}), exact), CheckStatus::held);
  EXPECT_EQ(status("complementarity", scene, struck_from_above(0.0101, 1, {0, 1}), exact), CheckStatus::broken);
}

TEST(StickingInvariant, ForbidsSlidingWithUnusedFriction) {
  const Scene scene = box_on_ground(0.5, {0, -10});
  const auto sliding = [&](double speed, double tangent) { return shown({pushing(0.1, tangent)}, {speed, 0}); };
  // What gravity adds in a step, and as much for an impact at no more than that: 2 g dt.
  EXPECT_EQ(status("sticking", scene, sliding(0.199, 0.025), exact), CheckStatus::held);
  EXPECT_EQ(status("sticking", scene, sliding(0.201, 0.025), exact), CheckStatus::broken);
  EXPECT_EQ(status("sticking", scene, sliding(100, 0.05), exact), CheckStatus::held);
}

// A slop of 1 mm that another contact corrects in a step of 10 ms.
TEST(StickingInvariant, AllowsForTheCorrectionOfAnotherContact) {
  const Scene scene = box_on_ground(0.5);
  Stepping stated = exact;
  stated.slop = 1e-3;
  const auto sliding = [&](double speed) { return shown({pushing(0.1, 0.025)}, {speed, 0}); };
  EXPECT_EQ(status("sticking", scene, sliding(0.099), stated), CheckStatus::held);
  EXPECT_EQ(status("sticking", scene, sliding(0.101), stated), CheckStatus::broken);
}

TEST(StickingInvariant, AllowsForAnImpactThatStoppedTheSlideWithinTheStep) {
  const Scene scene = box_on_ground(0.5);
  // An impulse of hypot(1, 0.25) on 1 kg, and at an arm of 0.5 m on (1/6) kg m^2, 0.25 turning it.
  const double change = std::hypot(1, 0.25) + 0.25 * 0.5 * 6 * 0.5;
  const auto landing = [](double slip, double falls) {
    return forged(dt, {{box_at({0, 0.5}, {slip, -falls})}, {box_at({0, 0.5}, {slip, 0}), {pushing(1, 0.25)}}});
  };
  EXPECT_EQ(status("sticking", scene, landing(0.99 * change, 1), exact), CheckStatus::held);
  EXPECT_EQ(status("sticking", scene, landing(1.01 * change, 1), exact), CheckStatus::broken);
  EXPECT_EQ(status("sticking", scene, landing(0.01, 0), exact), CheckStatus::broken);
}

// A joint passes an impulse on, with no more energy than J^2 B/2, B = 1 + 6/4 per kg at the contact.
TEST(StickingInvariant, AllowsForAnImpactThatAJointPassesOn) {
  Scene scene = box_on_ground(0.5);
  scene.bodies.push_back(scene.bodies[1]);
  scene.joints.push_back(Weld{.a = 1, .b = 2});
  const double change = std::hypot(1, 0.25) * std::sqrt(2.5) * (1 + std::sqrt(6) * 0.5);
  const auto landing = [](double slip, double falls) {
    const BodyState then{.position = {0, 0.5}, .velocity = {slip, -falls}};
    const BodyState now{.position = {0, 0.5}, .velocity = {slip, 0}};
    return forged(dt, {{{{}, then, then}}, {{{}, now, now}, {pushing(1, 0.25)}}});
  };
  EXPECT_EQ(status("sticking", scene, landing(0.99 * change, 1), exact), CheckStatus::held);
  EXPECT_EQ(status("sticking", scene, landing(1.01 * change, 1), exact), CheckStatus::broken);
  EXPECT_EQ(status("sticking", scene, landing(0.01, 0), exact), CheckStatus::broken);
}

// It turns by .2 rad in the step and is carried 10 cm along the ground. Where the contact is seen from, the corner
// would rise; it comes down at 4 m/s.
TEST(StickingInvariant, SeesTheImpactOfACornerThatTurnsTowardsTheGround) {
  const Scene scene = box_on_ground(0.5);
  // 1 kg, (1/6) kg m^2 and an arm of (-.05, -.5) m.
  const double change = std::hypot(1, 0.25) + (0.05 * 1 + 0.5 * 0.25) * 6 * std::hypot(0.05, 0.5);
  const auto landing = [](double slip, double spin) {
    ContactState contact = pushing(1, 0.25);
    contact.point = {0.05, 0};
    return forged(dt, {{{{}, {.position = {0, 0.5}, .angle = -0.2, .velocity = {10, -1}, .angular_velocity = spin}}},
                       {{{}, {.position = {0.1, 0.5}, .velocity = {slip, 0}}}, {contact}}});
  };
  EXPECT_EQ(status("sticking", scene, landing(0.99 * change, 20), exact), CheckStatus::held);
  EXPECT_EQ(status("sticking", scene, landing(1.01 * change, 20), exact), CheckStatus::broken);
  EXPECT_EQ(status("sticking", scene, landing(0.01, -10), exact), CheckStatus::broken);
}

TEST(StickingInvariant, TakesARollingDiscForNoImpact) {
  Scene scene = box_on_ground(0.5, {0, -10});
  scene.bodies[1].shapes[0].geometry = Circle{0.5};
  const auto rolling = [](double slip) {
    ContactState contact = pushing(0.1, 0.025);
    contact.point = {0.1, 0};
    const auto at = [&](double x, double angle) {
      return BodyState{.position = {x, 0.5}, .angle = angle, .velocity = {10 + slip, 0}, .angular_velocity = -20};
    };
    return forged(dt, {{{{}, at(0, 0)}}, {{{}, at(0.1, -0.2)}, {contact}}});
  };
  // 2 g dt, and w V dt by which the contact moves round: s = .2 + .2 (10 + s).
  EXPECT_EQ(status("sticking", scene, rolling(2.74), exact), CheckStatus::held);
  EXPECT_EQ(status("sticking", scene, rolling(2.76), exact), CheckStatus::broken);
}

}  // namespace
}  // namespace plumb::contact_laws_test
