#include <gtest/gtest.h>

#include <cmath>

#include "sleepers.h"

namespace sleeping_under_forces_test {
namespace {

using namespace impulse;

TEST(Sleep, ComesToNothingThatIsAttractedAndThatNothingHolds) {
  Settings settings = sleeping_allowed("accurate");
  settings.gravity = {};
  World world(settings);
  const BodyId sun = world.create_body(at(0, 0), unit_box());
  const BodyId planet = world.create_body(at(3, 0), unit_box());
  const ForceId pull = world.add_force(Attraction{sun, real(1e-5), 2});
  run(world, 300);
  EXPECT_TRUE(world.body(sun).awake());
  EXPECT_TRUE(world.body(planet).awake());
  EXPECT_LT(world.body(planet).velocity().x, 0);
  world.remove_force(pull);
  world.body(sun).set_velocity({}, 0);
  world.body(planet).set_velocity({}, 0);
  EXPECT_LT(steps_to_sleep(world), 1200);
}

// 0.018 Hz: at its turning point it moves by less than a micrometre in half a second, 2 mm from where it comes to rest.
TEST(Sleep, ComesToNoSlowSpringAtItsTurningPoint) {
  Settings settings = sleeping_allowed("accurate");
  settings.gravity = {};
  World world(settings);
  const BodyId weight = world.create_body(at(.002, 0), unit_box());
  Spring soft;
  soft.b = weight;
  soft.anchor_a = {-3, 0};
  soft.length = 3;
  soft.stiffness = real(.0125) * world.body(weight).mass().mass;
  const ForceId spring = world.add_force(soft);
  run(world, 300);
  EXPECT_TRUE(world.body(weight).awake());
  const double w = std::sqrt(.0125);
  EXPECT_NEAR(world.body(weight).position().x, .002 * std::cos(w * 5), 1e-6);
  world.remove_force(spring);
  world.body(weight).set_velocity({}, 0);
  EXPECT_LT(steps_to_sleep(world), 1200);
}

// Only springs and rails hold it, so that it must stand still to within rounding: after 1.6 s in float, 4 s in double.
TEST(Sleep, ComesToACarOnItsSprings) {
  World world(sleeping_allowed("accurate"));
  add_floor(world);
  const BodyId car = world.create_body(at(0, 1.1), Shape::box({1, real(.3)}));
  for (const double x : {-.8, .8}) {
    const BodyId wheel = world.create_body(at(x, .4), Shape::circle(real(.4)));
    PrismaticJoint strut;
    strut.a = car;
    strut.b = wheel;
    strut.anchor = {real(x), real(.4)};
    strut.axis = {0, 1};
    world.create_joint(strut);
    Spring spring;
    spring.a = car;
    spring.b = wheel;
    spring.anchor_a = {real(x), 0};
    spring.length = real(.75);
    spring.stiffness = 200;
    spring.damping = 10;
    world.add_force(spring);
  }
  EXPECT_LT(steps_to_sleep(world), 400);
}

TEST(Sleep, ComesToNoSlowSpringOnIce) {
  World world(sleeping_allowed("accurate"));
  add_floor(world);
  const BodyId weight = world.create_body(at(.002, .5), unit_box(), {1, 0, 0, 0});
  Spring soft;
  soft.b = weight;
  soft.anchor_a = {-3, .5};
  soft.length = 3;
  soft.stiffness = real(.0125) * world.body(weight).mass().mass;
  world.add_force(soft);
  run(world, 300);
  EXPECT_TRUE(world.body(weight).awake());
}

}  // namespace
}  // namespace sleeping_under_forces_test
