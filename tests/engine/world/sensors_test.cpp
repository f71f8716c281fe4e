// Sensors, and layers of single parts.
#include <gmock/gmock.h>

#include <array>
#include <vector>

#include "../solver/worlds.h"

namespace impulse::inline IMPULSE_PRECISION::sensors_test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

BodyDef fixed_at(double x, double y) {
  BodyDef def = at(x, y);
  def.type = BodyType::fixed;
  return def;
}

Part sensor(const Shape& shape) {
  Part part{shape, {}};
  part.sensor = true;
  return part;
}

BodyId add_zone(World& world, double x, double y, const Shape& shape) {
  return world.create_body(fixed_at(x, y), std::array{sensor(shape)});
}

TEST(Sensor, ReportsWhatEntersAndLeavesWithoutTouchingIt) {
  for (const bool sleeping : {false, true}) {
    Settings settings;
    settings.sleeping = sleeping;
    World world(settings);
    const BodyId zone = add_zone(world, 0, 5, Shape::box({1, 1}));
    const BodyId ball = world.create_body(at(0, 10), Shape::circle(real(.5)));
    // A ball falls 3.5 m to the zone's rim and 6.5 m until it has left it.
    std::vector<double> times;
    for (int i = 1; i <= 120; ++i) {
      world.step();
      const SensorEvents events = world.sensor_events();
      for (const SensorOverlap& overlap : events.begun) {
        EXPECT_EQ(overlap.sensor.body, zone);
        EXPECT_EQ(overlap.visitor.body, ball);
        EXPECT_THAT(events.overlapping, SizeIs(1));
        times.push_back(i / 60.);
      }
      for (const SensorOverlap& overlap : events.ended) {
        EXPECT_EQ(overlap.visitor.body, ball);
        EXPECT_THAT(events.overlapping, IsEmpty());
        times.push_back(i / 60.);
      }
    }
    ASSERT_THAT(times, SizeIs(2));
    EXPECT_NEAR(times[0], std::sqrt(2 * 3.5 / 10), 1. / 60);
    EXPECT_NEAR(times[1], std::sqrt(2 * 6.5 / 10), 1. / 60);
    EXPECT_NEAR(world.body(ball).velocity().y, -20, 1e-3) << "it fell freely";
  }
}

TEST(Sensor, OnAMovingBodySeesTheGround) {
  World world;
  const BodyId floor = add_floor(world);
  const std::array parts{Part{Shape::box({real(.4), real(.8)}), {}},
                         sensor(Shape::box({real(.3), real(.1)}, {0, real(-.8)}))};
  const BodyId player = world.create_body(at(0, 2), parts);
  EXPECT_NEAR(world.body(player).mass().mass, .8 * 1.6, 1e-5) << "sensors have no mass";
  world.step();
  EXPECT_THAT(world.sensor_events().overlapping, IsEmpty());
  run(world, 120);
  ASSERT_THAT(world.sensor_events().overlapping, SizeIs(1));
  EXPECT_EQ(world.sensor_events().overlapping[0].sensor, (PartId{player, 1}));
  EXPECT_EQ(world.sensor_events().overlapping[0].visitor, (PartId{floor, 0}));
  EXPECT_THAT(world.sensor_events().begun, IsEmpty());
}

TEST(Sensor, ChangesNoBit) {
  for (const bool sleeping : {false, true}) {
    Settings settings;
    settings.sleeping = sleeping;
    World plain(settings);
    World watched(settings);
    std::vector<BodyId> zones;
    for (World* world : {&plain, &watched}) {
      std::mt19937 random(5);
      add_floor(*world);
      for (int i = 0; i < 80; ++i) {
        const BodyDef def = at(seeded(random, -4, 4), 1 + i * .4);
        const Part solid{i % 2 == 0 ? Shape::circle(real(.3)) : Shape::box({real(.3), real(.2)}), {}};
        const Part feeler = sensor(Shape::circle(2));
        world == &plain ? world->create_body(def, std::array{solid})
                        : world->create_body(def, std::array{solid, feeler});
      }
      if (world == &watched)
        zones = {add_zone(*world, 0, 2, Shape::circle(3)), add_zone(*world, 3, 1, Shape::box({1, 1}))};
    }
    std::size_t seen = 0;
    for (int i = 0; i < 300; ++i) {
      plain.step();
      watched.step();
      seen += watched.sensor_events().begun.size();
    }
    EXPECT_GT(seen, 200U);
    for (const BodyId id : plain.bodies()) {
      ASSERT_EQ(plain.body(id).position(), watched.body(id).position());
      ASSERT_EQ(plain.body(id).angle(), watched.body(id).angle());
    }
  }
}

TEST(Sensor, EndsTheOverlapsOfADestroyedBody) {
  World world;
  add_zone(world, 0, 0, Shape::circle(2));
  const BodyId ball = world.create_body(at(0, 0), Shape::circle(real(.5)));
  world.step();
  EXPECT_THAT(world.sensor_events().begun, SizeIs(1));
  world.destroy_body(ball);
  const BodyId heir = world.create_body(at(0, 0), Shape::circle(real(.5)));
  ASSERT_EQ(heir.index, ball.index);
  world.step();
  ASSERT_THAT(world.sensor_events().ended, SizeIs(1));
  EXPECT_EQ(world.sensor_events().ended[0].visitor.body, ball);
  ASSERT_THAT(world.sensor_events().begun, SizeIs(1));
  EXPECT_EQ(world.sensor_events().begun[0].visitor.body, heir);
}

TEST(Sensor, SeesNoOtherSensorAndOnlyItsLayers) {
  World world;
  Part zone = sensor(Shape::circle(2));
  zone.layers = Layers{1, 2};
  world.create_body(fixed_at(0, 0), std::array{zone});
  add_zone(world, 0, 0, Shape::circle(1));
  BodyDef def = at(0, 0);
  def.layers = {2, ~0U};
  const BodyId seen = world.create_body(def, Shape::circle(real(.5)));
  def = at(1, 0);
  def.layers = {4, ~0U};
  world.create_body(def, Shape::circle(real(.1)));
  world.step();
  std::size_t of_zone = 0;
  for (const SensorOverlap& overlap : world.sensor_events().overlapping) {
    if (overlap.sensor.body.index != 0) continue;
    ++of_zone;
    EXPECT_EQ(overlap.visitor.body, seen);
  }
  EXPECT_EQ(of_zone, 1U);
}

TEST(Sensor, IsFoundByQueriesButNotByCasts) {
  World world;
  add_zone(world, 5, 0, Shape::circle(1));
  EXPECT_FALSE(world.ray_cast({0, 0}, {10, 0}));
  EXPECT_FALSE(world.shape_cast(Shape::circle(1), {}, {10, 0}));
  int found = 0;
  world.query_point({5, 0}, [&found](BodyId, const Part& part) {
    EXPECT_TRUE(part.sensor);
    ++found;
    return true;
  });
  EXPECT_EQ(found, 1);
}

TEST(Sensor, StaysAsItIsInACopy) {
  World world;
  add_zone(world, 0, 0, Shape::circle(2));
  world.create_body(at(0, 0), Shape::circle(real(.5)));
  world.step();
  World copy = world;
  EXPECT_THAT(copy.sensor_events().begun, SizeIs(1));
  copy.step();
  EXPECT_THAT(copy.sensor_events().begun, IsEmpty());
  EXPECT_THAT(copy.sensor_events().overlapping, SizeIs(1));
}

TEST(Sensor, AloneMakesNoDynamicBody) {
  World world;
  EXPECT_THROW(world.create_body(at(0, 0), std::array{sensor(Shape::circle(1))}), std::invalid_argument);
}

TEST(PartLayers, DecideForEachPart) {
  World world;
  BodyDef ground = fixed_at(0, 0);
  ground.layers = {1, 1};
  world.create_body(ground, Shape::half_space({0, 1}, 0));
  // A box that the ground holds, and a leg below it that it doesn't.
  Part box{Shape::box({real(.5), real(.5)}), {}};
  Part leg{Shape::box({real(.1), real(.5)}, {0, -1}), {}};
  leg.layers = Layers{2, 2};
  const BodyId walker = world.create_body(at(0, 3), std::array{box, leg});
  run(world, 200);
  EXPECT_NEAR(world.body(walker).position().y, .5, .01);
  EXPECT_EQ(world.body(walker).layers(1), (Layers{2, 2}));
  EXPECT_EQ(world.body(walker).layers(0), Layers{});

  world.body(walker).set_part_layers(1, std::nullopt);
  world.body(walker).set_pose({0, 3}, 0);
  run(world, 60);
  EXPECT_NEAR(world.body(walker).position().y, 1.5, .05) << "now it stands on its leg";
  EXPECT_THROW(world.body(walker).set_part_layers(2, Layers{}), std::out_of_range);
}

TEST(PartLayers, DecideWhatCastsHit) {
  World world;
  Part upper{Shape::circle(1, {0, 5}), {}};
  upper.layers = Layers{2, 2};
  world.create_body(fixed_at(0, 0), std::array{Part{Shape::circle(1), {}, Layers{1, 1}}, upper});
  EXPECT_EQ(world.ray_cast({0, 10}, {0, -10}, 1)->part, 0U);
  EXPECT_EQ(world.ray_cast({0, 10}, {0, -10}, 2)->part, 1U);
  EXPECT_EQ(world.shape_cast(Shape::circle(real(.1)), {{0, 10}, {}}, {0, -20}, 1)->part, 0U);
}

TEST(SolverType, NamesSolvers) {
  for (const SolverType solver : {SolverType::accurate, SolverType::soft_step}) {
    Settings settings;
    settings.solver = name_of(solver);
    EXPECT_NO_THROW(validate(settings));
  }
  EXPECT_STREQ(name_of(SolverType::soft_step), "soft-step");
  EXPECT_EQ(Settings{}.solver, name_of(SolverType::accurate));
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::sensors_test
