#include "reference/scene_facts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scenarios/scene/mass.h"

namespace plumb::scene_facts_test {
namespace {

Body box(Vec position) {
  Body body;
  body.name = "box";
  body.position = position;
  body.shapes.push_back({Box{}, {}});
  return body;
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

TEST(SceneFacts, MeasureTheSmallestBodyByItsGyration) {
  Scene scene;
  EXPECT_EQ(smallest_body(scene), 1);
  Body disc;
  disc.shapes.push_back({Circle{.25, {}}, {}});
  scene.bodies = {box({}), disc};
  EXPECT_NEAR(smallest_body(scene), .5, 1e-15);
}

}  // namespace
}  // namespace plumb::scene_facts_test
