#include <gtest/gtest.h>

#include "forged_runs.h"

namespace plumb::points_test {
namespace {

constexpr double dt = 0.01;
const Stepping stepping{.dt = dt, .h = dt, .epsilon = 1e-16};

ContactState at(Vec point, double push) {
  ContactState contact = pushing(push);
  contact.point = point;
  return contact;
}

Trace shown(const std::vector<ContactState>& contacts) {
  return forged(dt, {{box_at({0, 0.5}), contacts}, {box_at({0, 0.5}), contacts}});
}

TEST(PointsInvariant, ForbidsPairsThatAreFoundTwice) {
  const Scene scene = box_on_ground();
  const ContactState left = at({-0.5, 0}, 1);
  const ContactState right = at({0.5, 0}, 2);
  EXPECT_EQ(status("points", scene, shown({left, right}), stepping), CheckStatus::held);
  const auto twice = checked("points", scene, shown({left, right, left, right}), stepping).value();
  EXPECT_EQ(twice.status, CheckStatus::broken);
  EXPECT_EQ(twice.value, 1);
  EXPECT_EQ(twice.where, "ground - box");
  EXPECT_FALSE(is_evidence(twice));
}

TEST(PointsInvariant, AllowsAContactThatShrinksToAPointAndSeveralPointsOfAStep) {
  const Scene scene = box_on_ground();
  EXPECT_EQ(status("points", scene, shown({at({0.5, 0}, 1), at({0.5, 0}, 1)}), stepping), CheckStatus::held);
  EXPECT_EQ(status("points", scene, shown({at({0.5, 0}, 1), at({0.49, 0}, 1), at({0.48, 0}, 1)}), stepping),
            CheckStatus::held);
}

TEST(PointsInvariant, LetsADiscTouchAtOnePoint) {
  Scene scene = box_on_ground();
  scene.bodies[1].shapes[0].geometry = Circle{0.5};
  EXPECT_EQ(status("points", scene, shown({at({0.1, 0}, 1)}), stepping), CheckStatus::held);
  EXPECT_EQ(status("points", scene, shown({at({0.1, 0}, 1), at({0.1, 0}, 1)}), stepping), CheckStatus::broken);
  EXPECT_EQ(status("points", scene, shown({at({0.1, 0}, 1), at({0.1, 0}, 0)}), stepping), CheckStatus::held);
}

// Capsules may be made of discs and a box, and bodies of several shapes meet at corners that these share.
TEST(PointsInvariant, DoesNotJudgeBodiesThatMayBeMadeOfSeveralShapes) {
  Scene scene = box_on_ground();
  const auto contacts = shown({at({0.1, 0}, 1), at({0.1, 0}, 1), at({0.1, 0}, 1)});
  EXPECT_EQ(status("points", scene, contacts, stepping), CheckStatus::broken);
  scene.bodies[1].shapes.push_back(scene.bodies[1].shapes[0]);
  EXPECT_EQ(status("points", scene, contacts, stepping), CheckStatus::held);
  scene.bodies[1].shapes = {{Capsule{}, {}}};
  EXPECT_EQ(status("points", scene, contacts, stepping), CheckStatus::held);
}

}  // namespace
}  // namespace plumb::points_test
