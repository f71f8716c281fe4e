#include "impulse/debug_draw.h"

#include <gmock/gmock.h>

#include <array>

#include "../support.h"

namespace debug_draw_test {
namespace {

using namespace impulse;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr Aabb view{{-10, -10}, {10, 10}};

class Recorder : public DebugDraw {
 public:
  struct Line {
    Vec2 from, to;
    DrawRole role;
  };
  void polygon(std::span<const Vec2> corners, DrawRole role) override {
    polygons.emplace_back(corners.begin(), corners.end());
    roles.push_back(role);
  }
  void circle(Vec2 center, Real, Vec2 axis, DrawRole role) override {
    centers.push_back(center);
    axes.push_back(axis);
    roles.push_back(role);
  }
  void segment(Vec2 from, Vec2 to, DrawRole role) override { lines.push_back({from, to, role}); }
  void point(Vec2 at, DrawRole) override { points.push_back(at); }

  std::vector<std::vector<Vec2>> polygons;
  std::vector<Vec2> centers, axes, points;
  std::vector<Line> lines;
  std::vector<DrawRole> roles;
};

TEST(DebugDraw, DrawsEveryShapeAtItsPose) {
  World world(weightless());
  BodyDef turned = at(3, 4);
  turned.angle = pi / 2;
  const std::array parts{Part{Shape::circle(1), {}}, Part{Shape::box({1, 2}), {}},
                         Part{Shape::capsule({-1, 0}, {1, 0}, Real{0.5}), {}},
                         Part{Shape::segment({0, 0}, {1, 0}), {}}};
  turned.type = BodyType::kinematic;
  world.create_body(turned, parts);
  Recorder recorder;
  world.debug_draw(recorder, view);
  EXPECT_THAT(recorder.centers, SizeIs(3));  // the circle, the capsule's ends
  EXPECT_EQ(recorder.centers[0], (Vec2{3, 4}));
  EXPECT_NEAR(recorder.axes[0].y, 1, 4 * round_off);
  ASSERT_THAT(recorder.polygons, SizeIs(1));
  EXPECT_THAT(recorder.polygons[0], SizeIs(4));
  EXPECT_THAT(recorder.lines, SizeIs(3));  // the capsule's sides, the segment
  EXPECT_NEAR(recorder.lines[2].to.y, 5, 16 * round_off);
  EXPECT_THAT(recorder.roles, testing::Each(DrawRole::kinematic));
}

TEST(DebugDraw, DrawsContactsAndJoints) {
  World world;
  add_floor(world);
  const BodyId a = world.create_body(at(0, .5), Shape::circle(Real{0.5}));
  const BodyId b = world.create_body(at(2, .5), Shape::circle(Real{0.5}));
  world.create_joint(DistanceJoint{a, b, {0, Real{0.5}}, {2, Real{0.5}}, 2});
  world.step();
  Recorder recorder;
  world.debug_draw(recorder, view);
  EXPECT_THAT(recorder.points, SizeIs(2));
  std::vector<DrawRole> roles;
  for (const Recorder::Line& line : recorder.lines) roles.push_back(line.role);
  EXPECT_THAT(roles, ElementsAre(DrawRole::fixed, DrawRole::joint, DrawRole::contact, DrawRole::contact));
  EXPECT_EQ(recorder.lines[0].from.y, 0);  // the floor, all through the view
  EXPECT_GT(recorder.lines[0].from.x * -recorder.lines[0].to.x, 100);
}

TEST(DebugDraw, OmitsShapesOutsideTheView) {
  World world(weightless());
  world.create_body(at(20, 0), Shape::circle(1));
  Recorder recorder;
  world.debug_draw(recorder, view);
  EXPECT_THAT(recorder.centers, IsEmpty());
}

TEST(DebugDraw, CallbacksMayChangeTheWorld) {
  class Eraser : public Recorder {
   public:
    explicit Eraser(World& world) : world_(world) {}
    void circle(Vec2 center, Real radius, Vec2 axis, DrawRole role) override {
      Recorder::circle(center, radius, axis, role);
      for (const BodyId id : world_.bodies()) world_.destroy_body(id);
      for (int i = 0; i < 100; ++i) world_.create_body(at(0, 0), Shape::circle(1));
    }

   private:
    World& world_;
  };
  World world(weightless());
  for (int i = 0; i < 3; ++i) world.create_body(at(3 * i, 0), Shape::circle(1));
  Eraser eraser(world);
  world.debug_draw(eraser, view);
  EXPECT_THAT(eraser.centers, SizeIs(3));
  EXPECT_EQ(world.body_count(), 300U);
}

}  // namespace
}  // namespace debug_draw_test
