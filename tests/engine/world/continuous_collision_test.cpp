#include "world/continuous_collision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "../random_shapes.h"
#include "../support.h"

namespace continuous_collision_test {
namespace {

using namespace impulse;

// At 500 m/s and 60 Hz a step is 8.3 m long.
constexpr double fast = 500;

BodyId add_wall(World& world, double x, double thickness = .01, BodyType type = BodyType::fixed, double vx = 0) {
  BodyDef def = at(x, 0, vx);
  def.type = type;
  return world.create_body(def, Shape::box({real(thickness / 2), 100}), frictionless(.5));
}

/// An obstacle without thickness: a segment, or a chain with its free side towards x < 0.
void add_line(World& world, bool chain) {
  const std::array line{Vec2{0, 100}, Vec2{0, 3}, Vec2{0, -2}, Vec2{0, -100}};
  const std::vector<Shape> shapes = chain ? Shape::chain(line, false) : std::vector{Shape::segment(line[0], line[3])};
  std::vector<Part> parts;
  parts.reserve(shapes.size());
  for (const Shape& shape : shapes) parts.push_back({shape, frictionless(.5)});
  BodyDef def;
  def.type = BodyType::fixed;
  world.create_body(def, parts);
}

std::vector<std::vector<Part>> projectiles() {
  RandomShapes random(11);
  const Material made_of = frictionless(.5);
  return {{{Shape::circle(real(.1)), made_of}},
          {{Shape::box({real(.1), real(.1)}), made_of}},
          {{Shape::box({real(.5), real(.01)}), made_of}},
          {{Shape::capsule({real(-.3), 0}, {real(.3), 0}, real(.05)), made_of}},
          {{random.shape(ShapeType::polygon), made_of}},
          {{Shape::circle(real(.2), {real(-.3), 0}), made_of}, {Shape::box({real(.3), real(.05)}), made_of}}};
}

/// Moves at 50 ... 2000 m/s from the left, tumbling.
BodyDef shot(RandomShapes& random, int start) {
  constexpr std::array speeds{50.0, 120.0, 500.0, 1000.0, 2000.0};
  const double speed = speeds[static_cast<std::size_t>(start) % speeds.size()];
  const Real vy = random.number(-.2 * speed, .2 * speed);
  BodyDef def = at(-3 - .37 * start, 0, speed, static_cast<double>(vy));
  def.angle = random.number(-3, 3);
  def.angular_velocity = random.number(-20, 20);
  return def;
}

class Fast : public testing::TestWithParam<std::string> {
 protected:
  static World world() {
    Settings settings;
    settings.gravity = {};
    settings.solver = GetParam();
    return World(settings);
  }
};

template <class AddObstacle>
void expect_no_tunnelling(World (*make)(), const AddObstacle& add_obstacle, bool must_bounce) {
  RandomShapes random(12);
  int shape = 0;
  for (const std::vector<Part>& parts : projectiles()) {
    for (int start = 0; start < 20; ++start) {
      World world = make();
      add_obstacle(world);
      const BodyId body = world.create_body(shot(random, start), parts);
      for (int step = 0; step < 40; ++step) {
        world.step();
        ASSERT_LT(world.body(body).center().x, 0) << "shape " << shape << ", start " << start << ", step " << step;
      }
      if (!must_bounce) continue;
      EXPECT_LT(world.body(body).velocity().x, 0) << "stopped but not bounced: shape " << shape << ", start " << start;
    }
    ++shape;
  }
}

TEST_P(Fast, BodiesNeverTunnelThroughAThinWall) {
  // Methods that solve one point at a time may leave a box spinning at the wall, its corners always moving away from
  // it.
  const std::array look_ahead{"accurate", "soft-step", "xpbd"};
  const bool must_bounce = std::find(look_ahead.begin(), look_ahead.end(), GetParam()) != look_ahead.end();
  expect_no_tunnelling(
      world, [](World& world) { add_wall(world, 0); }, must_bounce);
}

TEST_P(Fast, BodiesNeverTunnelThroughASegment) {
  expect_no_tunnelling(
      world, [](World& world) { add_line(world, false); }, false);
}

TEST_P(Fast, BodiesNeverTunnelThroughAChainFromItsFreeSide) {
  expect_no_tunnelling(
      world, [](World& world) { add_line(world, true); }, false);
}

TEST_P(Fast, BulletsHitMovingBodies) {
  World world = Fast::world();
  const BodyId target = world.create_body(at(0, 0, 1, 0), Shape::box({real(.005), 2}), frictionless());
  BodyDef def = at(-5, 0, fast, 0);
  def.bullet = true;
  const BodyId bullet = world.create_body(def, Shape::circle(real(.05)), frictionless());
  run(world, 10);
  EXPECT_LT(world.body(bullet).center().x, world.body(target).center().x);
  EXPECT_GT(world.body(target).velocity().x, 2);
}

TEST_P(Fast, BulletsHitEachOtherInFlight) {
  World world = Fast::world();
  BodyDef def = at(-5, 0, fast, 0);
  def.bullet = true;
  const BodyId left = world.create_body(def, Shape::circle(real(.05)), frictionless());
  def = at(5, 0, -fast, 0);
  def.bullet = true;
  const BodyId right = world.create_body(def, Shape::circle(real(.05)), frictionless());
  run(world, 10);
  EXPECT_LT(world.body(left).center().x, world.body(right).center().x);
}

TEST_P(Fast, MovingWallsPushBodies) {
  World world = Fast::world();
  const BodyId wall = add_wall(world, -3, .01, BodyType::kinematic, 60);
  const BodyId disc = world.create_body(at(0, 0), Shape::circle(real(.1)), frictionless());
  for (int step = 0; step < 30; ++step) {
    world.step();
    ASSERT_GT(world.body(disc).center().x, world.body(wall).center().x) << step;
  }
}

INSTANTIATE_TEST_SUITE_P(Solvers, Fast, testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const MethodInfo& solver : solvers()) names.push_back(solver.name);
                           return names;
                         }()),
                         [](const auto& entry) {
                           std::string name = entry.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

/// Whether a disc of 0.2 m that starts at `from` (m) and moves at 30 m/s in steps of dt ever touches a wall of 1 cm.
bool touches(double dt, double from, Continuous mode) {
  Settings settings = weightless(dt);
  settings.continuous = mode;
  World world(settings);
  add_wall(world, 0);
  world.create_body(at(from, 0, 30, 0), Shape::circle(real(.1)));
  for (int step = 0; step < 40; ++step) {
    world.step();
    if (!world.contacts().empty()) return true;
  }
  return false;
}

// An engine that only tests the poses after each step can miss a wall if a step is longer than wall and body together.
TEST(ContinuousCollision, IfOffBodiesTunnelWhenAStepIsLongerThanWallAndBody) {
  const double long_enough = (.2 + .01) / 30;
  int missed = 0;
  for (int i = 0; i < 40; ++i) {
    const double from = -1 - 1.5 * .21 * i / 40;
    EXPECT_TRUE(touches(.98 * long_enough, from, Continuous::off)) << from;
    EXPECT_TRUE(touches(1.5 * long_enough, from, Continuous::automatic)) << from;
    if (!touches(1.5 * long_enough, from, Continuous::off)) ++missed;
  }
  // The starts are spread over one step. A third of the step is between two tested poses; the count may be off by one.
  EXPECT_NEAR(missed, 40 / 3.0, 1);
}

TEST(ContinuousCollision, IfOnEveryBodyIsABullet) {
  for (const Continuous mode : {Continuous::automatic, Continuous::on}) {
    Settings settings = weightless();
    settings.continuous = mode;
    World world(settings);
    const BodyId plate = world.create_body(at(0, 0), Shape::box({real(.005), 2}), frictionless());
    world.create_body(at(-3, 0, fast, 0), Shape::circle(real(.1)), frictionless());
    run(world, 5);
    EXPECT_EQ(world.body(plate).velocity().x > 0, mode == Continuous::on);
  }
}

// A wheel that rolls far in a step is fast, but its core circle hits nothing; the solver handles the contact at its
// rim.
TEST(ContinuousCollision, DoesNotAffectSlowOrRollingBodies) {
  const auto end = [](Continuous mode, Shape shape, double speed) {
    Settings settings;
    settings.continuous = mode;
    World world(settings);
    add_floor(world);
    BodyDef def = at(0, .5, speed, 0);
    def.angular_velocity = real(-speed / .5);
    const BodyId body = world.create_body(def, shape);
    run(world, 90);
    return world.body(body).center();
  };
  const Shape box = Shape::box({real(.5), real(.5)});
  const Shape wheel = Shape::circle(real(.5));
  EXPECT_EQ(end(Continuous::off, box, 3), end(Continuous::on, box, 3));
  EXPECT_EQ(end(Continuous::off, wheel, 60), end(Continuous::on, wheel, 60));
}

TEST(ContinuousCollision, IgnoresOtherLayersAndTheSolidSideOfChains) {
  World world(weightless());
  BodyDef wall;
  wall.type = BodyType::fixed;
  wall.layers = 0b01;
  world.create_body(wall, Shape::box({real(.005), 20}));
  wall.layers = 0b10;
  const std::array line{Vec2{1, 20}, Vec2{1, -20}};  // solid where x is larger
  world.create_body(wall, Shape::chain(line, false)[0]);
  BodyDef def = at(3, 0, -fast, 0);
  def.layers = 0b10;
  const BodyId body = world.create_body(def, Shape::circle(real(.1)));
  run(world, 2);
  EXPECT_LT(world.body(body).center().x, -10);
}

}  // namespace
}  // namespace continuous_collision_test
