#include "reports/run/scene_warnings.h"

#include <gmock/gmock.h>

namespace plumb::scene_warnings_test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Body box(const std::string& name, Vec position) {
  return {.name = name, .position = position, .shapes = {{.geometry = Box{.size = {1, 1}}}}};
}

TEST(SceneWarnings, AreNoneForBodiesThatTouch) {
  EXPECT_THAT(warnings_about({.bodies = {box("a", {0, 0}), box("b", {0.995, 0})}}), IsEmpty());
}

TEST(SceneWarnings, NameBodiesThatStartInEachOther) {
  EXPECT_THAT(warnings_about({.bodies = {box("a", {0, 0}), box("b", {0.75, 0})}}),
              ElementsAre("bodies[1] (\"b\"): starts 0.25 m inside bodies[0] (\"a\")"));
}

TEST(SceneWarnings, NameAnglesThatMayBeDegrees) {
  Scene scene{.bodies = {box("a", {0, 0})}};
  scene.bodies[0].angle = 6.28;
  EXPECT_THAT(warnings_about(scene), IsEmpty());
  scene.bodies[0].angle = 45;
  EXPECT_THAT(warnings_about(scene),
              ElementsAre(AllOf(HasSubstr("bodies[0] (\"a\").angle: 45"), HasSubstr("0.785398"))));
}

TEST(SceneWarnings, NameDensitiesPerVolumeOfBodiesThatMove) {
  Scene scene{.bodies = {box("a", {0, 0})}};
  scene.bodies[0].shapes[0].surface.density = 1000;
  EXPECT_THAT(warnings_about(scene),
              ElementsAre(HasSubstr("bodies[0] (\"a\").shapes[0].density: 1000 kg/m^2 is per area")));
  scene.bodies[0].type = BodyType::fixed;
  EXPECT_THAT(warnings_about(scene), IsEmpty());
}

TEST(SceneWarnings, NameRodsThatStartStretched) {
  Distance rod{.a = 0, .b = 1, .anchor_a = {0, 0}, .anchor_b = {3, 0}, .length = 2};
  Scene scene{.bodies = {box("a", {0, 0}), box("b", {3, 0})}, .joints = {rod}};
  EXPECT_THAT(warnings_about(scene), ElementsAre("joints[0].length: is 2 m, but the anchors start 3 m apart"));
  rod.stiffness = 10;
  scene.joints = {rod};
  EXPECT_THAT(warnings_about(scene), IsEmpty()) << "a spring may be stretched";
}

TEST(SceneWarnings, NameScenesThatTakeMinutesWithoutTakingThem) {
  Scene heap;
  for (int i = 0; i < 5000; ++i) heap.bodies.push_back(box(std::to_string(i), {0, 0}));
  EXPECT_THAT(warnings_about(heap), ElementsAre(HasSubstr("most start in one place")));
  Scene many{.bodies = {box("a", {0, 0})}};
  many.bodies[0].shapes.assign(5000, many.bodies[0].shapes[0]);
  EXPECT_THAT(warnings_about(many), ElementsAre(HasSubstr("bodies[0] (\"a\"): has 5000 shapes")));
}

TEST(SceneWarnings, AreFewOfAKind) {
  Scene scene;
  for (int i = 0; i < 9; ++i) scene.bodies.push_back(box(std::to_string(i), {3.0 * i, 0}));
  for (Body& body : scene.bodies) body.angle = 90;
  EXPECT_THAT(warnings_about(scene), SizeIs(6));
  EXPECT_THAT(warnings_about(scene).back(), HasSubstr("and 4 more"));
}

}  // namespace
}  // namespace plumb::scene_warnings_test
