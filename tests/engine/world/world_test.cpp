#include "impulse/world.h"

#include <gmock/gmock.h>

#include <limits>
#include <stdexcept>

#include "../support.h"

namespace world_test {
namespace {

using namespace impulse;
using testing::ElementsAre;

TEST(World, KeepsItsSettingsWhenItRejectsNewOnes) {
  World world;
  Settings bad;
  bad.gravity = {1, 1};
  bad.iterations = 0;
  EXPECT_THROW(world.set_settings(bad), std::invalid_argument);
  EXPECT_THROW(world.set_dt(-1), std::invalid_argument);
  EXPECT_THROW(world.set_gravity({0, std::numeric_limits<Real>::infinity()}), std::invalid_argument);
  EXPECT_EQ(world.gravity(), (Vec2{0, -10}));
  EXPECT_EQ(world.dt(), real(1.0 / 60));
  EXPECT_EQ(world.settings().iterations, 10);
}

TEST(World, ChangesItsMethodsBetweenSteps) {
  World world(weightless(1));
  const BodyId body = world.create_body(at(0, 0), Shape::box({1, 1}));
  world.body(body).apply_force({4, 0});
  world.step();
  EXPECT_EQ(world.body(body).position(), (Vec2{1, 0}));
  Settings settings = world.settings();
  settings.integrator = "explicit-euler";
  world.set_settings(settings);
  world.body(body).apply_force({4, 0});
  world.step();
  EXPECT_EQ(world.body(body).position(), (Vec2{2, 0}));
  EXPECT_EQ(world.body(body).velocity(), (Vec2{2, 0}));
}

TEST(World, ListsInsertedBodiesByIndex) {
  World world;
  const BodyId a = world.create_body({}, Shape::circle(1));
  const BodyId b = world.create_body({}, Shape::circle(1));
  const BodyId c = world.create_body({}, Shape::circle(1));
  world.remove_body(b);
  EXPECT_THAT(world.bodies(), ElementsAre(a, c));
  EXPECT_EQ(world.body_count(), 2U);
  EXPECT_TRUE(world.contains(b));
  world.insert_body(b);
  EXPECT_THAT(world.bodies(), ElementsAre(a, b, c));
}

TEST(World, DetectsStaleHandles) {
  World world;
  const BodyId old = world.create_body({}, Shape::circle(1));
  Body view = world.body(old);
  world.destroy_body(old);
  const BodyId next = world.create_body({}, Shape::circle(1));
  ASSERT_EQ(next.index, old.index);
  EXPECT_FALSE(world.contains(old));
  EXPECT_THROW(world.body(old), std::out_of_range);
  EXPECT_THROW(world.destroy_body(old), std::out_of_range);
  EXPECT_THROW(world.remove_body(old), std::out_of_range);
  EXPECT_THROW(world.insert_body(old), std::out_of_range);
  EXPECT_THROW(world.body(BodyId{}), std::out_of_range);
  EXPECT_THROW(view.position(), std::out_of_range);
  EXPECT_THROW(view.velocity(), std::out_of_range);
  EXPECT_THROW(view.set_pose({}, 0), std::out_of_range);
  EXPECT_THROW(view.apply_force({}), std::out_of_range);
  EXPECT_THROW(view.apply_impulse({}, {}), std::out_of_range);
  EXPECT_THROW(view.mass(), std::out_of_range);
}

TEST(World, KeepsTheStateOfARemovedBody) {
  World world;
  const BodyId id = world.create_body(at(1, 2, 3, 4), Shape::circle(1));
  world.remove_body(id);
  run(world, 10);
  EXPECT_EQ(world.body(id).position(), (Vec2{1, 2}));
  EXPECT_EQ(world.body(id).velocity(), (Vec2{3, 4}));
  EXPECT_FALSE(world.body(id).awake());
  world.body(id).set_velocity({5, 6}, 0);
  world.insert_body(id);
  EXPECT_EQ(world.body(id).velocity(), (Vec2{5, 6}));
  world.step();
  EXPECT_GT(world.body(id).position().x, 1);
}

TEST(World, RemovedBodiesTouchNothing) {
  World world;
  const BodyId floor = add_floor(world);
  const BodyId disc = world.create_body(at(0, .5), Shape::circle(Real{0.5}));
  world.step();
  EXPECT_EQ(world.contacts().size(), 1U);
  world.remove_body(floor);
  EXPECT_TRUE(world.contacts().empty());
  run(world, 30);
  EXPECT_LT(world.body(disc).position().y, 0);
}

TEST(World, RejectsInvalidBodies) {
  World world;
  const Shape disc = Shape::circle(1);
  const auto refused = [&](auto change) {
    BodyDef def;
    change(def);
    EXPECT_THROW(world.create_body(def, disc), std::invalid_argument);
  };
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  refused([&](BodyDef& def) { def.position.x = nan; });
  refused([&](BodyDef& def) { def.angle = nan; });
  refused([&](BodyDef& def) { def.velocity.y = std::numeric_limits<Real>::infinity(); });
  refused([&](BodyDef& def) { def.angular_velocity = nan; });
  refused([&](BodyDef& def) { def.gravity_scale = nan; });
  refused([&](BodyDef& def) { def.linear_damping = -1; });
  refused([&](BodyDef& def) { def.angular_damping = nan; });
  refused([&](BodyDef& def) {
    def.type = BodyType::fixed;
    def.velocity = {1, 0};
  });
  EXPECT_THROW(world.create_body({}, std::span<const Part>{}), std::invalid_argument);
  EXPECT_THROW(world.create_body({}, disc, {0, 0, 0, 0}), std::invalid_argument);
  EXPECT_THROW(world.create_body({}, disc, {1, 0, 0, 2}), std::invalid_argument);
  EXPECT_THROW(world.create_body({}, disc, {1, real(.1), real(.2), 0}), std::invalid_argument);
  EXPECT_THROW(world.create_body({}, disc, {nan, 0, 0, 0}), std::invalid_argument);
  EXPECT_THROW(world.create_body({}, Shape::half_space({0, 1}, 0)), std::invalid_argument);
  EXPECT_EQ(world.body_count(), 0U);
}

TEST(World, KinematicBodiesMoveAsPrescribedAndArePushedByNothing) {
  World world;
  BodyDef def;
  def.type = BodyType::kinematic;
  def.velocity = {0, 1};
  def.angular_velocity = 0;
  const BodyId lift = world.create_body(def, Shape::half_space({0, 1}, 0));
  const BodyId disc = world.create_body(at(0, .5), Shape::circle(Real{0.5}));
  run(world, 120);
  EXPECT_NEAR(world.body(lift).position().y, 2, 120 * 2 * round_off);
  EXPECT_EQ(world.body(lift).velocity(), (Vec2{0, 1}));
  // The lift carries it: at most the slop and one step of gravity deep in the floor.
  EXPECT_NEAR(world.body(disc).position().y, 2.5, .01);
  // Laws are met to 64 epsilon of the velocities that they compare, here two of 1 m/s.
  EXPECT_NEAR(world.body(disc).velocity().y, 1, 2 * 64 * 2 * round_off);
}

TEST(World, BodiesWithoutACommonLayerPassThroughEachOther) {
  World world;
  BodyDef ground;
  ground.type = BodyType::fixed;
  ground.layers = 0b11;
  world.create_body(ground, Shape::half_space({0, 1}, 0));
  BodyDef red = at(-2, .5, 4, 0);
  red.layers = 0b01;
  BodyDef blue = at(2, .5, -4, 0);
  blue.layers = 0b10;
  const BodyId a = world.create_body(red, Shape::circle(Real{0.5}), frictionless());
  const BodyId b = world.create_body(blue, Shape::circle(Real{0.5}), frictionless());
  run(world, 60);
  EXPECT_NEAR(world.body(a).position().x, 2, 60 * 4 * round_off);
  EXPECT_NEAR(world.body(b).position().x, -2, 60 * 4 * round_off);
  EXPECT_NEAR(world.body(a).position().y, .5, .01);
  // Now they share a layer.
  world.body(a).set_velocity({-4, 0}, 0);
  world.body(b).set_velocity({4, 0}, 0);
  world.body(a).set_layers(0b11);
  run(world, 60);
  EXPECT_GT(world.body(a).position().x, 0);
}

// Each row: category and mask of a disc, and whether it lands on the floor of category 1 that meets 6.
TEST(World, BodiesCollideIfEachIsInTheOthersMask) {
  struct Row {
    Layers layers;
    bool lands;
  };
  for (const Row& row : {Row{{2, 1}, true}, Row{{4, 1}, true}, Row{{8, 1}, false}, Row{{2, 2}, false},
                         Row{{2, 0}, false}, Row{{6, ~0U}, true}, Row{{8, ~0U}, false}}) {
    for (const bool sleeping : {false, true}) {
      Settings settings;
      settings.sleeping = sleeping;
      World world(settings);
      BodyDef ground;
      ground.type = BodyType::fixed;
      ground.layers = {1, 6};
      world.create_body(ground, Shape::half_space({0, 1}, 0));
      BodyDef def = at(0, 1);
      def.layers = row.layers;
      const BodyId disc = world.create_body(def, Shape::circle(Real{0.5}));
      run(world, 60);
      EXPECT_EQ(world.body(disc).position().y > 0, row.lands) << row.layers.category << " " << row.layers.mask;
    }
  }
}

TEST(World, FixedRotationKeepsTheAngle) {
  World world(weightless());
  BodyDef def;
  def.fixed_rotation = true;
  const BodyId id = world.create_body(def, Shape::box({1, 1}));
  world.body(id).apply_impulse({0, 1}, {1, 0});
  run(world, 10);
  EXPECT_EQ(world.body(id).angle(), 0);
  EXPECT_EQ(world.body(id).mass().inertia, 0);
  EXPECT_GT(world.body(id).position().y, 0);
}

TEST(World, MixesMaterialsByTheRuleOfItsSettings) {
  Settings settings = weightless();
  settings.restitution_mixing = RestitutionMixing::multiply;
  World world(settings);
  world.create_body(at(0, 0, 1, 0), Shape::circle(Real{0.5}), frictionless(.5));
  const BodyId b = world.create_body(at(1, 0, -1, 0), Shape::circle(Real{0.5}), frictionless(.5));
  world.step();
  EXPECT_NEAR(world.body(b).velocity().x, .25, 16 * round_off);
}

/// The state of every body after 200 steps of a mixed pile.
std::vector<Real> mixed_pile(const char* integrator) {
  Settings settings;
  settings.integrator = integrator;
  World world(settings);
  add_floor(world);
  for (int i = 0; i < 40; ++i) {
    BodyDef def = at(.31 * (i % 7), .6 + .55 * i, 0, -1);
    def.angle = real(.1 * i);
    const Real size = real(.2 + .01 * (i % 5));
    world.create_body(def, i % 2 == 0 ? Shape::circle(size) : Shape::box({size, size}));
    if (i % 10 == 9) world.destroy_body(world.bodies()[static_cast<std::size_t>(i) / 2]);
  }
  run(world, 200);
  std::vector<Real> state;
  for (const BodyId id : world.bodies()) {
    const Body body = world.body(id);
    state.insert(state.end(), {body.position().x, body.position().y, body.angle(), body.velocity().x, body.velocity().y,
                               body.angular_velocity()});
  }
  return state;
}

TEST(World, GivesTheSameBitsForTheSameCalls) {
  for (const MethodInfo& integrator : integrators()) {
    const std::vector<Real> state = mixed_pile(integrator.name.c_str());
    EXPECT_EQ(state, mixed_pile(integrator.name.c_str())) << integrator.name;
    for (const Real x : state) ASSERT_TRUE(std::isfinite(x)) << integrator.name;
  }
}

TEST(World, CanBeMoved) {
  World world;
  const BodyId id = world.create_body(at(1, 2), Shape::circle(1));
  World other = std::move(world);
  EXPECT_EQ(other.body(id).position(), (Vec2{1, 2}));
}

TEST(World, LetsBodiesPassWhileContactsAreOffAndCollideWhenTheyAreOn) {
  for (const MethodInfo& solver : solvers()) {
    Settings settings;
    settings.solver = solver.name;
    settings.contact_events = true;
    World world(settings);
    const BodyId floor = add_floor(world);
    const BodyId disc = world.create_body(at(0, 1), Shape::circle(1));
    run(world, 10);
    EXPECT_NEAR(world.body(disc).position().y, 1, 0.02) << solver.name;
    settings.contacts = false;
    world.set_settings(settings);
    run(world, 30);
    EXPECT_LT(world.body(disc).position().y, 0) << solver.name;
    EXPECT_TRUE(world.contacts().empty()) << solver.name;
    EXPECT_TRUE(world.contact_events().touching.empty()) << solver.name;
    settings.contacts = true;
    world.set_settings(settings);
    world.body(disc).set_pose({0, 1}, 0);
    world.body(disc).set_velocity({}, 0);
    run(world, 10);
    EXPECT_NEAR(world.body(disc).position().y, 1, 0.02) << solver.name;
    EXPECT_TRUE(world.contains(floor));
  }
}

TEST(World, WakesRestingBodiesWhenContactsAreTurnedOff) {
  Settings settings;
  settings.sleeping = true;
  World world(settings);
  add_floor(world);
  const BodyId disc = world.create_body(at(0, 1), Shape::circle(1));
  run(world, 60);
  ASSERT_EQ(world.awake_count(), 0U);
  settings.contacts = false;
  world.set_settings(settings);
  run(world, 60);
  EXPECT_NEAR(world.body(disc).position().y, 1 - 5, 0.1);
}

}  // namespace
}  // namespace world_test
