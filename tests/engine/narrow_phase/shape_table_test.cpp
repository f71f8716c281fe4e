#include "narrow_phase/shape_table.h"

#include <gtest/gtest.h>

#include "../random_shapes.h"
#include "../support.h"
#include "narrow_phase/collide.h"
#include "narrow_phase/margin.h"

namespace impulse::inline IMPULSE_PRECISION::shape_table_test {

namespace {

std::size_t add(BodySet& bodies, const Shape& shape, const Pose& pose, const Velocity& velocity) {
  BodyDef def;
  def.type = BodyType::kinematic;
  const Part part{shape, {}};
  const std::size_t i = bodies.add(def, std::span(&part, 1)).index;
  bodies.insert(i);
  bodies.pose[i] = pose;
  bodies.velocity[i] = velocity;
  return i;
}

/// A long plank at every angle, and a shape near it.
TEST(ShapeTable, CallsApartOnlyPartsWithoutContact) {
  RandomShapes random(1);
  const Margin margin{real(.02), real(.02)};
  std::size_t apart = 0;
  std::size_t touching = 0;
  for (int i = 0; i < 5000; ++i) {
    BodySet bodies;
    const Shape plank = Shape::box({5, real(.1)}, random.point(1));
    const Pose plank_pose = random.pose(1);
    const Vec2 plank_v = random.point(2);
    const Real plank_w = random.number(-1, 1);
    const Shape shape = random.shape(i % 2 == 0 ? ShapeType::box : ShapeType::polygon);
    const Pose pose = random.pose(4);
    const Vec2 v = random.point(5);
    const Real w = random.number(-3, 3);
    const std::size_t a = add(bodies, plank, plank_pose, {plank_v, plank_w});
    const std::size_t b = add(bodies, shape, pose, {v, w});
    ShapeTable shapes;
    shapes.update(bodies, margin);
    const bool meet = collide(plank, plank_pose, shape, pose, speculative_gap(bodies, a, b, margin)).count > 0;
    EXPECT_FALSE(meet && shapes.apart(a, b)) << i;
    EXPECT_EQ(shapes.apart(a, b), shapes.apart(b, a));
    apart += shapes.apart(a, b) ? 1 : 0;
    touching += meet ? 1 : 0;
  }
  EXPECT_GT(apart, 1000U);
  EXPECT_GT(touching, 500U);
}

TEST(ShapeTable, FollowsBodiesThatAppearAndDisappear) {
  BodySet bodies;
  const std::size_t first = add(bodies, Shape::circle(1), {}, {});
  const std::size_t second = add(bodies, Shape::box({1, 1}), {}, {});
  ShapeTable shapes;
  shapes.update(bodies, {});
  ASSERT_EQ(shapes.proxies().size(), 2U);
  EXPECT_EQ(shapes.kind(first), ShapeKind::disc);
  bodies.remove(first);
  shapes.update(bodies, {});
  ASSERT_EQ(shapes.proxies().size(), 1U);
  EXPECT_EQ(shapes.proxies()[0].body, second);
  bodies.set_layers(second, 4);
  bodies.pose[second].p = {3, 0};
  shapes.update(bodies, {});
  EXPECT_EQ(shapes.proxies()[0].layers, 4U);
  EXPECT_EQ(shapes.proxies()[0].bounds.low, (Vec2{2, -1}));
}

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION::shape_table_test
