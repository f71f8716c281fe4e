#include "reference/meeting.h"

#include <gtest/gtest.h>

#include "reports/run/selection.h"
#include "scenarios/parts.h"

namespace plumb {
namespace {

// Two discs of radius 1/2 for a second without gravity.
Scene two(Vec apart, Vec closing) {
  Scene scene;
  scene.gravity = {};
  scene.bodies = {disc("a", {0, 0}, 0.5, surface(0, 1)), disc("b", apart, 0.5, surface(0, 1))};
  scene.bodies[1].velocity = closing;
  return scene;
}

bool none_meets(const Scene& scene) { return !why_none_meet(scene).empty(); }

TEST(WhyNoneMeet, TellsThoseThatPassFromThoseThatMeet) {
  EXPECT_TRUE(none_meets(two({3, 0}, {})));
  EXPECT_TRUE(none_meets(two({3, 0}, {-1.9, 0})));
  EXPECT_FALSE(none_meets(two({3, 0}, {-2.1, 0})));
  EXPECT_TRUE(none_meets(two({3, 1.1}, {-6, 0})));
  EXPECT_FALSE(none_meets(two({3, 0.9}, {-6, 0})));
}

TEST(WhyNoneMeet, LooksNoFartherThanTheScenesEnd) {
  Scene scene = two({3, 0}, {-1, 0});
  EXPECT_TRUE(none_meets(scene));
  scene.duration = 3;
  EXPECT_FALSE(none_meets(scene));
}

TEST(WhyNoneMeet, KnowsThatWhatFallsTogetherStaysApart) {
  Scene scene = two({1.1, 0}, {});
  scene.gravity = {0, -10};
  EXPECT_TRUE(none_meets(scene));
  scene.bodies[1].gravity_scale = 0.5;
  scene.bodies[1].position = {0, -1.1};
  EXPECT_FALSE(none_meets(scene));
}

// 5 m in a second.
TEST(WhyNoneMeet, KnowsHowLongAFallTakesToTheGround) {
  Scene scene;
  scene.bodies = {level_ground(surface(0, 0)), disc("disc", {0, 5.6}, 0.5, surface(0, 0))};
  EXPECT_TRUE(none_meets(scene));
  scene.bodies[1].position.y = 5.4;
  EXPECT_FALSE(none_meets(scene));
  scene.bodies[1].position.y = 5.6;
  scene.forces.push_back(Constant{1, {0, -1}, 0});
  EXPECT_FALSE(none_meets(scene));
}

TEST(WhyNoneMeet, ClaimsNothingOfWhatForcesOrJointsCarry) {
  Scene scene = two({30, 0}, {});
  EXPECT_TRUE(none_meets(scene));
  scene.bodies[1].linear_damping = 1;
  EXPECT_FALSE(none_meets(scene));
  scene.bodies[1].linear_damping = 0;
  scene.forces.push_back(Spring{0, 1, {}, {}, 1, 0, 0});
  EXPECT_FALSE(none_meets(scene));
}

TEST(WhyNoneMeet, SeesThatLayersJointsOrNoShapesKeepBodiesApart) {
  Scene scene = two({0, 0}, {});
  EXPECT_FALSE(none_meets(scene));
  scene.joints.push_back(Revolute{0, 1, {}});
  EXPECT_TRUE(none_meets(scene));
  scene.joints.clear();
  scene.bodies[0].layers = 1;
  scene.bodies[1].layers = 2;
  EXPECT_TRUE(none_meets(scene));
  scene.bodies[1].layers = 3;
  EXPECT_FALSE(none_meets(scene));
  scene.bodies[1].shapes.clear();
  EXPECT_TRUE(none_meets(scene));
}

TEST(WhyNoneMeet, HoldsForWhatTurnsAboutAPointOfItsRim) {
  Scene scene = two({3, 0}, {});
  scene.bodies[1].shapes[0].geometry = Box{.size = {2, 2}};  // 1 m to its sides, 1.41 m to its corners
  scene.bodies[1].position = {1.6, 0};
  EXPECT_FALSE(none_meets(scene));
  scene.bodies[1].position = {2, 0};
  EXPECT_TRUE(none_meets(scene));
}

TEST(WhyNoneMeet, IsRightOfEveryScenarioThatItClaims) {
  for (const Case& one : default_cases(true)) {
    if (!none_meets(*one.scene)) continue;
    const EngineConfig engine = parse_engine("impulse");
    const Outcome outcome = run(*one.scene, engine, 1.0 / 60);
    ASSERT_EQ(outcome.status, Status::ok) << one.scenario->name;
    for (std::size_t moment = 0; moment < outcome.trace->size(); ++moment) {
      for (const ContactState& contact : outcome.trace->contacts(moment)) {
        EXPECT_EQ(contact.normal_impulse, 0) << one.scenario->name << " " << one.variant;
      }
    }
  }
}

}  // namespace
}  // namespace plumb
