#include <gtest/gtest.h>

#include <cmath>

#include "forged_runs.h"
#include "scenarios/scene/vec.h"

namespace plumb::moments_test {
namespace {

constexpr double dt = 0.001;
const Stepping exact{.dt = dt, .h = dt, .drift = 0, .impact_lag = 0, .epsilon = 1e-16};
const char* const invariant = "angular_momentum_of_bodies";

ContactState pushing_at(Vec point, double normal, double tangent = 0) {
  ContactState contact = pushing(normal, tangent);
  contact.point = point;
  return contact;
}

// A box of 1 kg and I = 1/6 lands and turns at w after contacts have pushed it.
InvariantCheck landed(double w, const std::vector<ContactState>& contacts, const Stepping& stepping = exact) {
  double push = 0;
  double drag = 0;
  for (const ContactState& contact : contacts) {
    push += contact.normal_impulse;
    drag -= contact.tangent_impulse;  // the tangent of (0, 1) is (-1, 0)
  }
  const BodyState after{.position = {0, 0.5}, .velocity = {drag, push - 1}, .angular_velocity = w};
  const Scene scene = box_on_ground();
  return checked(invariant, scene, forged(dt, {{box_at({0, 0.5}, {0, -1})}, {{{}, after}, contacts}}), stepping)
      .value();
}

TEST(AngularMomentumOfBodiesInvariant, FollowsFromWhereContactsPush) {
  // 1/2 m beside the centre, 1 N s: I w = 1/2.
  EXPECT_EQ(landed(3, {pushing_at({0.5, 0}, 1)}).status, CheckStatus::held);
  for (const double w : {0.0, -3.0, 2.9, 3.1}) {
    const InvariantCheck check = landed(w, {pushing_at({0.5, 0}, 1)});
    EXPECT_EQ(check.status, CheckStatus::broken) << w;
    EXPECT_EQ(check.where, "box");
    EXPECT_NEAR(check.value, std::abs(w - 3) / 6, 1e-12);
    EXPECT_TRUE(is_evidence(check));
  }
}

TEST(AngularMomentumOfBodiesInvariant, CountsEveryContactAndItsFriction) {
  EXPECT_EQ(landed(0, {pushing_at({0.5, 0}, 0.5), pushing_at({-0.5, 0}, 0.5)}).status, CheckStatus::held);
  EXPECT_EQ(landed(3, {pushing_at({0.5, 0}, 0.5), pushing_at({-0.5, 0}, 0.5)}).status, CheckStatus::broken);
  // Friction at the bottom, 1/2 m below the centre: I w = -1/2 T.
  EXPECT_EQ(landed(-1.2, {pushing_at({0, 0}, 1, 0.4)}).status, CheckStatus::held);
  EXPECT_EQ(landed(0, {pushing_at({0, 0}, 1, 0.4)}).status, CheckStatus::broken);
}

TEST(AngularMomentumOfBodiesInvariant, KnowsThatAPushActsAnywhereWithinTheStatedGap) {
  Stepping gap = exact;
  gap.slop = 0.01;
  EXPECT_EQ(landed(2.95, {pushing_at({0.5, 0}, 1)}, gap).status, CheckStatus::held);  // 1/6 of .05 < 1 N s times 1 cm
  EXPECT_EQ(landed(2.8, {pushing_at({0.5, 0}, 1)}, gap).status, CheckStatus::broken);
}

// A method may keep points of both bodies that have slid apart, and report the middle.
TEST(AngularMomentumOfBodiesInvariant, AllowsForTheWaySlidSinceTheContactBegan) {
  const auto slid = [](double way, double off) {
    const Scene scene = box_on_ground();
    const double speed = way / (2 * dt);
    const std::vector<ContactState> contacts{pushing_at({0.5 + off, 0}, 0.05), pushing_at({-0.5 + off, 0}, 0.05)};
    std::vector<Moment> moments;
    for (const double x : {0.0, way / 2, way}) {
      std::vector<ContactState> at = contacts;
      for (ContactState& contact : at) contact.point.x += x;
      moments.push_back({box_at({x, 0.5}, {speed, 0}), at});
    }
    return status(invariant, scene, forged(dt, moments), exact);
  };
  EXPECT_EQ(slid(0.01, 0.004), CheckStatus::held);
  EXPECT_EQ(slid(0.01, 0.02), CheckStatus::broken);
  EXPECT_EQ(slid(0.001, 0.004), CheckStatus::broken);
}

// A brick that is struck, slides up to the next one and hands its velocity on, all within a step.
TEST(AngularMomentumOfBodiesInvariant, AllowsForTheWaySlidByWhatSetsOutAndStopsWithinAStep) {
  const auto slid = [](double way, double off) {
    const std::vector<ContactState> contacts{pushing_at({way + 0.5 + off, 0}, 0.05),
                                             pushing_at({way - 0.5 + off, 0}, 0.05)};
    const Trace trace = forged(dt, {{box_at({0, 0.5})}, {box_at({way, 0.5}), contacts}});
    return status(invariant, box_on_ground(), trace, exact);
  };
  EXPECT_EQ(slid(0.01, 0.004), CheckStatus::held);
  EXPECT_EQ(slid(0.01, 0.03), CheckStatus::broken);
  EXPECT_EQ(slid(0.001, 0.004), CheckStatus::broken);
}

// A disc that rolls leaves the points behind on both.
TEST(AngularMomentumOfBodiesInvariant, AllowsForTheWayRolledSinceTheContactBegan) {
  Scene scene = box_on_ground();
  scene.bodies[1].shapes[0].geometry = Circle{.radius = 0.5};
  const auto rolled = [&](double way, double behind) {
    const double speed = way / dt;
    const auto at = [&](double x) {
      return std::vector<BodyState>{
          {}, {.position = {x, 0.5}, .angle = -2 * x, .velocity = {speed, 0}, .angular_velocity = -2 * speed}};
    };
    return status(invariant, scene, forged(dt, {{at(0)}, {at(way), {pushing_at({way - behind, 0}, 0.1)}}}), exact);
  };
  EXPECT_EQ(rolled(0.01, 0.005), CheckStatus::held);
  EXPECT_EQ(rolled(0.01, 0.1), CheckStatus::broken);
  EXPECT_EQ(rolled(0, 0.005), CheckStatus::broken);
}

TEST(AngularMomentumOfBodiesInvariant, NeedsReportedContacts) {
  const Scene scene = box_on_ground();
  const Trace trace = forged(dt, {{box_at({0, 0.5}, {0, -1})}, {box_at({0, 0.5})}});
  EXPECT_EQ(status(invariant, scene, trace, exact), CheckStatus::not_reported);
}

}  // namespace
}  // namespace plumb::moments_test
