#include "benchmark_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>

#include "reports/judge/mechanics.h"
#include "scenarios/parts.h"

namespace plumb::benchmarks::benchmark_scene_test {
namespace {

SceneSetup three_rows() {
  SceneSetup setup{.size = 1};
  add_pyramid(setup, 3, {0, 0});
  return setup;
}

TEST(SceneCheck, AcceptsAPyramidAsBuilt) {
  const SceneSetup setup = three_rows();
  EXPECT_EQ(setup.supports.size(), 6U);
  const SceneCheck found = check_scene(setup, initial_states(setup.scene));
  EXPECT_EQ(found.broken, "");
  EXPECT_EQ(found.overlap.most, 0);
}

TEST(SceneCheck, AllowsAPyramidToSinkAsAWhole) {
  const SceneSetup setup = three_rows();
  std::vector<BodyState> states = initial_states(setup.scene);
  for (BodyState& state : states) state.position.y *= 0.95;
  const SceneCheck found = check_scene(setup, states);
  EXPECT_EQ(found.broken, "");
  EXPECT_NEAR(found.overlap.mean, 0.05, 1e-12);
  EXPECT_NEAR(found.overlap.most, 0.05, 1e-12);
}

TEST(SceneCheck, NoticesABoxThatSlippedOffTheRowBelow) {
  const SceneSetup setup = three_rows();
  std::vector<BodyState> states = initial_states(setup.scene);
  states.back().position.x += 0.49;
  EXPECT_EQ(check_scene(setup, states).broken, "");
  states.back().position.x += 0.02;
  EXPECT_EQ(check_scene(setup, states).broken, "body 5 has fallen off body 3");
}

TEST(SceneCheck, NoticesAStateThatIsNotFinite) {
  const SceneSetup setup = three_rows();
  std::vector<BodyState> states = initial_states(setup.scene);
  states[4].angular_velocity = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(check_scene(setup, states).broken, "the state of body 4 is not finite");
}

TEST(SceneCheck, NoticesADynamicBodyThatLeft) {
  SceneSetup setup{.size = 1, .center = {1, 0}, .reach = 2};
  setup.scene.bodies = {fixed(box("wall", {9, 0}, {1, 1}, {})), box("box", {-1, 0}, {1, 1}, {})};
  std::vector<BodyState> states = initial_states(setup.scene);
  EXPECT_EQ(check_scene(setup, states).broken, "");
  states[1].position.x -= 1e-9;
  EXPECT_EQ(check_scene(setup, states).broken, "body 1 has left the scene");
}

TEST(SceneCheck, NoticesAMeanOverlapOfMoreThanAQuarter) {
  SceneSetup setup{.size = 0.8};
  setup.scene.bodies = {disc("", {0, 0}, 0.4, {}), disc("", {0.5, 0}, 0.4, {}), disc("", {1.22, 0}, 0.4, {})};
  std::vector<BodyState> states = initial_states(setup.scene);
  const SceneCheck found = check_scene(setup, states);
  EXPECT_EQ(found.broken, "");
  EXPECT_NEAR(found.overlap.mean, 0.19, 1e-12);
  EXPECT_NEAR(found.overlap.most, 0.3, 1e-12);
  states[2].position.x = 1.18;
  EXPECT_EQ(check_scene(setup, states).broken, "bodies overlap by 0.21 m on average");
}

TEST(SceneCheck, NoticesAHingeThatOpensButNotOneThatTurns) {
  SceneSetup setup{.size = 0.8};
  setup.scene.bodies = {disc("", {0, 0}, 0.4, {}), disc("", {1, 0}, 0.4, {})};
  setup.scene.joints = {Revolute{.a = 0, .b = 1, .anchor = {0.5, 0}}};
  std::vector<BodyState> states = initial_states(setup.scene);
  states[1] = {.position = {0.5, 0.5}, .angle = 90 * degree};
  EXPECT_EQ(check_scene(setup, states).broken, "");
  states[1].position.y = 1.29;
  EXPECT_EQ(check_scene(setup, states).broken, "");
  states[1].position.y = 1.31;
  EXPECT_EQ(check_scene(setup, states).broken, "the hinge of bodies 0 and 1 is open by 0.81 m");
}

TEST(BenchmarkScenes, AreTheseWithThatManyBodiesAndStartSound) {
  std::map<std::string, std::ptrdiff_t> dynamic;
  for (const BenchmarkScene* scene : Catalog<BenchmarkScene>::all()) {
    const SceneSetup setup = scene->setup();
    const SceneCheck found = check_scene(setup, initial_states(setup.scene));
    EXPECT_EQ(found.broken, "") << scene->name;
    EXPECT_LT(found.overlap.most, 1e-12) << scene->name;
    EXPECT_GT(scene->settled.steps() + scene->moving.steps(), 0) << scene->name;
    dynamic[scene->name] = std::count_if(setup.scene.bodies.begin(), setup.scene.bodies.end(),
                                         [](const Body& body) { return body.type == BodyType::dynamic; });
  }
  const std::map<std::string, std::ptrdiff_t> expected{
      {"bouncing", 600},      {"free-10000", 10000}, {"joint-grid", 9993}, {"many-pyramids", 22000}, {"one-box", 1},
      {"pyramid-100", 5050},  {"pyramid-20", 210},   {"rain", 2000},       {"smash", 9601},          {"terrain", 4000},
      {"smooth-discs", 2000}, {"three-bodies", 2},   {"tumbler", 2025},    {"washer", 8100}};
  EXPECT_EQ(dynamic, expected);
}

}  // namespace
}  // namespace plumb::benchmarks::benchmark_scene_test
