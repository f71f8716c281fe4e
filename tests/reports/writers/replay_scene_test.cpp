#include "reports/writers/replay_scene.h"

#include <gmock/gmock.h>

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

TEST(ReplayScene, HasEachOutlineOnceAboutTheCentreOfMass) {
  const Shape box{.geometry = Box{.size = {2, 1}, .center = {5, 0}}};
  const Json scene =
      outlines_of({.bodies = {{.name = "one", .shapes = {box}},
                              {.name = "two", .shapes = {box}},
                              {.name = "floor", .type = BodyType::fixed, .shapes = {{HalfSpace{}, {}}}}}});
  ASSERT_EQ(scene["outlines"].size(), 2u);
  EXPECT_EQ(scene["outlines"][0]["points"], Json::parse("[[-1.0, -0.5], [1.0, -0.5], [1.0, 0.5], [-1.0, 0.5]]"));
  EXPECT_EQ(scene["outlines"][1], Json::parse(R"({"normal": [0.0, 1.0], "offset": 0.0})"));
  EXPECT_EQ(scene["bodies"][1], Json::parse(R"({"name": "two", "type": "dynamic", "outlines": [0]})"));
  EXPECT_EQ(scene["bodies"][2]["type"], "fixed");
}

TEST(ReplayScene, DrawsCapsulesAndDiscsAsPointsThatAreGrown) {
  const Capsule capsule{.from = {-1, 0}, .to = {1, 0}, .radius = 0.25};
  const Scene scene{.bodies = {{.name = "c", .shapes = {{.geometry = capsule}}}, {.name = "point"}}};
  EXPECT_EQ(outlines_of(scene)["outlines"][0], Json::parse(R"({"points": [[-1.0, 0.0], [1.0, 0.0]], "radius": 0.25})"));
  EXPECT_THAT(radii_of(scene), ::testing::ElementsAre(1.25, 0));
}

TEST(ReplayScene, TiesJointsAndSpringsInTheBodiesFrames) {
  const Shape disc{.geometry = Circle{}};
  const Scene scene{.bodies = {{.name = "a", .position = {1, 0}, .shapes = {disc}},
                               {.name = "b", .position = {3, 0}, .angle = 0, .shapes = {disc}}},
                    .joints = {Revolute{.a = 0, .b = 1, .anchor = {2, 0}}},
                    .forces = {Spring{.b = 1, .anchor_a = {0, 4}, .anchor_b = {0, 0.5}}}};
  const Json ties = outlines_of(scene)["ties"];
  EXPECT_EQ(ties[0], Json::parse(R"({"a": 0, "b": 1, "at_a": [1.0, 0.0], "at_b": [-1.0, 0.0]})"));
  EXPECT_EQ(ties[1], Json::parse(R"({"a": null, "b": 1, "at_a": [0.0, 4.0], "at_b": [0.0, 0.5]})"));
}

}  // namespace
}  // namespace plumb
