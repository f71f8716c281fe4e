#include "impulse/body.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <stdexcept>

#include "../support.h"

namespace body_test {
namespace {

using namespace impulse;

// v = J/m and w = r x J/I: 2 N s at an arm of 1 m on a box of 4 kg and 8/3 kg m^2.
TEST(Body, RespondsToAnOffCentreImpulseAsTheClosedForm) {
  World world(weightless());
  Body body = world.body(world.create_body(at(3, 4), Shape::box({1, 1})));
  body.apply_impulse({0, 2}, {4, 4});
  EXPECT_EQ(body.velocity(), (Vec2{0, Real{0.5}}));
  EXPECT_NEAR(body.angular_velocity(), 0.75, 2 * round_off);
  body.apply_impulse({2, 0}, {3, 5});  // at an arm (0, 1): rotates it the other way
  EXPECT_EQ(body.velocity(), (Vec2{Real{0.5}, Real{0.5}}));
  EXPECT_NEAR(body.angular_velocity(), 0, 2 * round_off);
}

TEST(Body, DistinguishesItsFrameFromItsCentreOfMass) {
  World world(weightless());
  const std::array parts{Part{Shape::box({1, 1}), {}}, Part{Shape::box({1, 1}, {4, 0}), {}}};
  BodyDef def = at(1, 1);
  def.angle = pi / 2;
  Body body = world.body(world.create_body(def, parts));
  EXPECT_NEAR(body.position().x, 1, 4 * round_off);
  EXPECT_NEAR(body.position().y, 1, 4 * round_off);
  EXPECT_NEAR(body.center().x, 1, 4 * round_off);
  EXPECT_NEAR(body.center().y, 3, 4 * round_off);
  EXPECT_NEAR(body.mass().center.x, 2, 4 * round_off);
  body.set_pose({5, 5}, 0);
  EXPECT_EQ(body.position(), (Vec2{5, 5}));
  EXPECT_EQ(body.center(), (Vec2{7, 5}));
}

// A free body rotates about its centre of mass, which moves in a straight line.
TEST(Body, RotatesAboutItsCentreOfMass) {
  World world(weightless());
  const std::array parts{Part{Shape::box({1, 1}), {}}, Part{Shape::box({1, 1}, {4, 0}), {}}};
  BodyDef def;
  def.angular_velocity = 3;
  Body body = world.body(world.create_body(def, parts));
  run(world, 60);
  EXPECT_NEAR(length(body.center() - Vec2{2, 0}), 0, 4 * round_off);
  EXPECT_NEAR(length(body.position() - body.center()), 2, 8 * round_off);
  EXPECT_NEAR(body.angle(), 3, 60 * 3 * round_off);
}

TEST(Body, RejectsValuesThatAreNotFinite) {
  World world;
  Body body = world.body(world.create_body({}, Shape::circle(1)));
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  EXPECT_THROW(body.set_pose({nan, 0}, 0), std::invalid_argument);
  EXPECT_THROW(body.set_velocity({0, 0}, nan), std::invalid_argument);
  EXPECT_THROW(body.set_gravity_scale(nan), std::invalid_argument);
  EXPECT_THROW(body.apply_force({nan, 0}), std::invalid_argument);
  EXPECT_THROW(body.apply_force({0, 0}, {nan, 0}), std::invalid_argument);
  EXPECT_THROW(body.apply_torque(nan), std::invalid_argument);
  EXPECT_THROW(body.apply_impulse({0, nan}, {0, 0}), std::invalid_argument);
  world.step();
  EXPECT_TRUE(std::isfinite(body.position().y));
}

TEST(Body, ReturnsItsDefinition) {
  World world;
  int player = 7;
  BodyDef def;
  def.type = BodyType::kinematic;
  def.layers = 5;
  def.user_data = &player;
  const Body body = world.body(world.create_body(def, Shape::circle(2)));
  EXPECT_EQ(body.type(), BodyType::kinematic);
  EXPECT_EQ(body.layers(), 5U);
  EXPECT_EQ(body.user_data(), &player);
  ASSERT_EQ(body.parts().size(), 1U);
  EXPECT_EQ(body.parts()[0].shape.radius(), 2);
}

TEST(Body, RejectsAVelocityForAFixedBody) {
  World world;
  Body floor = world.body(add_floor(world));
  EXPECT_THROW(floor.set_velocity({1, 0}, 0), std::invalid_argument);
}

}  // namespace
}  // namespace body_test
