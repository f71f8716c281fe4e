#include <gtest/gtest.h>

#include "forged_runs.h"

namespace plumb::restitution_test {
namespace {

constexpr double dt = 0.01;
const Stepping exact{.dt = dt, .h = dt, .drift = 0, .impact_lag = 0, .epsilon = 1e-16};

Scene disc_on_ground(double restitution, Vec gravity = {}) {
  Scene scene = box_on_ground(0.5, gravity);
  for (Body& body : scene.bodies) body.shapes.front().surface.restitution = restitution;
  scene.bodies[1].shapes.front().geometry = Circle{.radius = 0.5};
  return scene;
}

// Falls onto the ground at 2 m/s and leaves it at `speed`.
Trace bounced(double speed, const std::vector<ContactState>& contacts = {pushing(1)}) {
  return forged(dt, {{box_at({0, 0.51}, {0, -2})}, {box_at({0, 0.51}, {0, speed}), contacts}});
}

TEST(RestitutionInvariant, IsBrokenByABodyThatLeavesFasterThanItMay) {
  EXPECT_EQ(status("restitution", disc_on_ground(0.5), bounced(1), exact), CheckStatus::held);
  EXPECT_EQ(status("restitution", disc_on_ground(0.5), bounced(1.001), exact), CheckStatus::broken);
  EXPECT_EQ(status("restitution", disc_on_ground(0), bounced(2), exact), CheckStatus::broken);
  EXPECT_EQ(status("restitution", disc_on_ground(1), bounced(2), exact), CheckStatus::held);
}

TEST(RestitutionInvariant, IsEvidenceOnlyOfImpactsThatLoseEnergy) {
  EXPECT_TRUE(is_evidence(checked("restitution", disc_on_ground(0.5), bounced(1), exact).value()));
  EXPECT_FALSE(is_evidence(checked("restitution", disc_on_ground(1), bounced(2), exact).value()));
}

// Gravity gives it 0.1 m/s in a step, before the impact and after it.
TEST(RestitutionInvariant, AllowsForTheForcesOfTheStep) {
  EXPECT_EQ(status("restitution", disc_on_ground(0.5, {0, -10}), bounced(1.149), exact), CheckStatus::held);
  EXPECT_EQ(status("restitution", disc_on_ground(0.5, {0, -10}), bounced(1.151), exact), CheckStatus::broken);
}

TEST(RestitutionInvariant, JudgesOnlyWhatTouchesNothingElse) {
  const std::vector<ContactState> two_points{pushing(1), pushing(1)};
  EXPECT_EQ(status("restitution", disc_on_ground(0), bounced(2, two_points), exact), CheckStatus::held);

  Scene scene = disc_on_ground(0);
  scene.bodies.push_back(scene.bodies[1]);
  scene.bodies[2].name = "other";
  const auto with_other = [&](double x) {
    const BodyState other{.position = {x, 0.51}};
    Trace trace(3);
    std::vector<BodyState> states = box_at({0, 0.51}, {0, -2});
    states.push_back(other);
    trace.record(0, states, {});
    states[1].velocity = {0, 2};
    trace.record(dt, states, std::vector{pushing(1)});
    return trace;
  };
  EXPECT_EQ(status("restitution", scene, with_other(1.001), exact), CheckStatus::held);
  EXPECT_EQ(status("restitution", scene, with_other(3), exact), CheckStatus::broken);
}

TEST(RestitutionInvariant, IsNotReportedWithoutContacts) {
  EXPECT_EQ(status("restitution", disc_on_ground(0), bounced(2, {}), exact), CheckStatus::not_reported);
}

}  // namespace
}  // namespace plumb::restitution_test
