#include "reference/scene_facts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scenarios/scene/mass.h"

namespace plumb {
namespace {

Body box(Vec position) {
  Body body;
  body.name = "box";
  body.position = position;
  body.shapes.push_back({Box{}, {}});
  return body;
}

TEST(SceneFacts, ReachAsFarAsGravityAndTheStartCarry) {
  Scene scene;
  scene.duration = 10;
  scene.bodies = {box({30, 40})};
  scene.bodies[0].velocity = {6, 8};
  EXPECT_DOUBLE_EQ(reach(scene), 50 + 10 * 10 + 10 * 100 / 2.0);
  scene.duration = .1;
  EXPECT_DOUBLE_EQ(reach(scene), 100);
}

TEST(SceneFacts, CenteringMovesTheFrameAndNotTheShapes) {
  Body body = box({1, 2});
  body.angle = .5;
  body.shapes = {{Box{{1, 1}, {2, 0}, 0}, {}}, {Circle{.5, {0, 3}}, {}}};
  const Mass before = mass_of(body);
  const Body moved = centered(body);
  const Mass after = mass_of(moved);
  EXPECT_NEAR(after.center.x, 0, 1e-15);
  EXPECT_NEAR(after.center.y, 0, 1e-15);
  EXPECT_NEAR(after.inertia, before.inertia, 1e-15 * before.inertia);
  const Vec box_center = std::get<Box>(moved.shapes[0].geometry).center;
  const double x = moved.position.x + std::cos(.5) * box_center.x - std::sin(.5) * box_center.y;
  EXPECT_NEAR(x, 1 + 2 * std::cos(.5), 1e-15 * 8);
}

TEST(SceneFacts, NameTheBodyThatAsksTooMuch) {
  Scene scene;
  scene.bodies = {box({})};
  EXPECT_EQ(needs_two_frictions(scene), "");
  EXPECT_EQ(needs_dynamic_half_space(scene), "");
  EXPECT_EQ(needs_massless_body(scene), "");
  scene.bodies[0].shapes[0].surface.static_friction = .7;
  EXPECT_NE(needs_two_frictions(scene).find("\"box\""), std::string::npos);
  scene.bodies[0].shapes[0].surface.density = 0;
  EXPECT_NE(needs_massless_body(scene).find("\"box\""), std::string::npos);
  scene.bodies[0].shapes[0].geometry = HalfSpace{};
  EXPECT_NE(needs_dynamic_half_space(scene).find("\"box\""), std::string::npos);
}

}  // namespace
}  // namespace plumb
