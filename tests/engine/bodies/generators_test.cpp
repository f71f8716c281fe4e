#include "bodies/generators.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "../support.h"

namespace {

using namespace impulse;

/// The acceleration of a body 2 m from one that attracts by strength 3.
Vec2 pulled_by(double exponent, double reach = HUGE_VAL) {
  World world(weightless(1));
  BodyDef sun = at(0, 0);
  sun.type = BodyType::fixed;
  const BodyId from = world.create_body(sun, Shape::circle(real(.1)));
  const BodyId body = world.create_body(at(0, 2), Shape::circle(real(.1)));
  world.add_force(Attraction{from, 3, real(exponent), false, real(reach)});
  world.step();
  return world.body(body).velocity();
}

TEST(Attraction, FallsWithThePowerOfTheDistance) {
  EXPECT_EQ(pulled_by(2), (Vec2{0, -Real{3} / 4}));
  EXPECT_EQ(pulled_by(1), (Vec2{0, -Real{3} / 2}));
  EXPECT_EQ(pulled_by(0), (Vec2{0, -3}));
  EXPECT_EQ(pulled_by(-1), (Vec2{0, -6}));
  EXPECT_NEAR(pulled_by(.5).y, -3 / std::sqrt(2), 8 * round_off);
  EXPECT_NEAR(pulled_by(-2.5).y, -3 * std::pow(2, 2.5), 64 * round_off);
}

TEST(Attraction, EndsAtItsReach) {
  EXPECT_EQ(pulled_by(2, 1), (Vec2{0, 0}));
  EXPECT_EQ(pulled_by(2, 2), (Vec2{0, -Real{3} / 4}));
}

TEST(Attraction, RefusesPowersThatDifferBetweenMachines) {
  EXPECT_THROW(pulled_by(2.3), std::invalid_argument);
  EXPECT_THROW(pulled_by(40), std::invalid_argument);
  EXPECT_THROW(pulled_by(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(pulled_by(2, -1), std::invalid_argument);
}

TEST(Attraction, KeepsMomentumWhenMutual) {
  World world(weightless(0.1));
  const BodyId heavy = world.create_body(at(0, 0), Shape::circle(1));
  const BodyId light = world.create_body(at(5, 1), Shape::circle(Real{0.25}));
  world.add_force(Attraction{heavy, 2, 2, true});
  run(world, 10);
  const Real ratio = world.body(heavy).mass().mass / world.body(light).mass().mass;
  EXPECT_GT(length(world.body(heavy).velocity()), 0);
  const Vec2 left = ratio * world.body(heavy).velocity() + world.body(light).velocity();
  EXPECT_NEAR(length(left), 0, 10 * 8 * round_off * length(world.body(light).velocity()));
}

TEST(Attraction, IsNotFeltByItsSourceOtherwise) {
  World world(weightless(0.1));
  const BodyId heavy = world.create_body(at(0, 0), Shape::circle(1));
  world.create_body(at(5, 1), Shape::circle(Real{0.25}));
  world.add_force(Attraction{heavy, 2});
  run(world, 10);
  EXPECT_EQ(world.body(heavy).velocity(), (Vec2{0, 0}));
}

// Verlet moves exactly in a field with h^2 (L^2/(12 r^5) - 1/(24 r^4)) of energy more (p.V''p/12 - |V'|^2/24), which
// pushes a circle of radius 1 outwards by h^2/4: it swings between 1 and 1 + h^2/2, and does not drift.
TEST(Attraction, KeepsAnOrbit) {
  Settings settings = weightless(0.01);
  settings.integrator = "velocity-verlet";
  World world(settings);
  BodyDef sun = at(0, 0);
  sun.type = BodyType::fixed;
  const BodyId from = world.create_body(sun, Shape::circle(real(.1)));
  const BodyId planet = world.create_body(at(1, 0, 0, 1), Shape::circle(real(.1)));
  world.add_force(Attraction{from, 1});
  for (int i = 0; i < 6283; ++i) {
    world.step();
    ASSERT_NEAR(length(world.body(planet).position()), 1, 1.1e-4 / 2 + 6283 * round_off);
  }
}

TEST(SpringForce, PullsBothEndsAlike) {
  World world(weightless(1));
  const BodyId a = world.create_body(at(0, 0), Shape::box({1, 1}));
  const BodyId b = world.create_body(at(6, 0), Shape::box({1, 1}));
  world.add_force(Spring{a, b, {1, 0}, {-1, 0}, 2, 3, 0});  // 4 m between the anchors
  world.step();
  EXPECT_EQ(world.body(a).velocity(), (Vec2{Real{0.5}, 0}));
  EXPECT_EQ(world.body(b).velocity(), (Vec2{-Real{0.5}, 0}));
}

TEST(SpringForce, TurnsABodyThatItHoldsOffCentre) {
  World world(weightless(1));
  const BodyId body = world.create_body(at(0, 0), Shape::box({1, 1}));
  world.add_force(Spring{body, {}, {1, 0}, {1, 5}, 1, 2, 0});  // 3 N upwards at an arm of 1 m
  world.step();
  EXPECT_EQ(world.body(body).velocity(), (Vec2{0, Real{0.75}}));
  EXPECT_NEAR(world.body(body).angular_velocity(), 3 / (4 * 8 / 12.0), 4 * round_off);
}

TEST(SpringForce, BrakesTheAnchorsThatPart) {
  World world(weightless(0.5));
  const BodyId body = world.create_body(at(2, 0, 1, 5), Shape::box({1, 1}));
  world.add_force(Spring{{}, body, {}, {}, 0, 0, 4});
  world.step();
  EXPECT_EQ(world.body(body).velocity(), (Vec2{Real{0.5}, 5}));  // 1 - .5 * 4/4, and nothing across
}

TEST(SpringForce, RefusesNumbersThatMakeNoSense) {
  World world;
  const BodyId body = world.create_body({}, Shape::circle(1));
  EXPECT_THROW(world.add_force(Spring{}), std::invalid_argument);
  EXPECT_THROW(world.add_force(Spring{body, body}), std::invalid_argument);
  EXPECT_THROW(world.add_force(Spring{{}, body, {}, {}, -1, 0, 0}), std::invalid_argument);
  EXPECT_THROW(world.add_force(Spring{{}, body, {}, {}, 0, real(HUGE_VAL), 0}), std::invalid_argument);
  EXPECT_THROW(world.add_force(Spring{{}, BodyId{7, 0}, {}, {}, 1, 1, 0}), std::out_of_range);
}

TEST(ConstantForce, ActsUntilItIsRemoved) {
  World world(weightless(1));
  const BodyId body = world.create_body({}, Shape::box({1, 1}));
  const ForceId force = world.add_force(ConstantForce{body, {4, 0}, 0});
  run(world, 3);
  EXPECT_EQ(world.body(body).velocity(), (Vec2{3, 0}));
  world.remove_force(force);
  EXPECT_FALSE(world.contains(force));
  EXPECT_THROW(world.remove_force(force), std::out_of_range);
  world.step();
  EXPECT_EQ(world.body(body).velocity(), (Vec2{3, 0}));
}

TEST(Force, DiesWithAnyBodyThatItNames) {
  World world(weightless(1));
  const BodyId a = world.create_body(at(0, 0), Shape::box({1, 1}));
  const BodyId b = world.create_body(at(5, 0), Shape::box({1, 1}));
  const ForceId spring = world.add_force(Spring{a, b, {}, {}, 1, 1, 0});
  const ForceId attraction = world.add_force(Attraction{a, 1});
  const ForceId constant = world.add_force(ConstantForce{b, {4, 0}, 0});
  world.destroy_body(a);
  EXPECT_FALSE(world.contains(spring));
  EXPECT_FALSE(world.contains(attraction));
  EXPECT_TRUE(world.contains(constant));
  world.create_body(at(0, 0), Shape::box({1, 1}));  // in the same row: nothing of the old one acts on it
  world.step();
  EXPECT_EQ(world.body(b).velocity(), (Vec2{1, 0}));
}

TEST(Force, RestsWhileItsBodyIsOutOfTheWorld) {
  World world(weightless(1));
  const BodyId a = world.create_body(at(0, 0), Shape::box({1, 1}));
  const BodyId b = world.create_body(at(5, 0), Shape::box({1, 1}));
  world.add_force(Spring{a, b, {}, {}, 1, 1, 0});
  world.add_force(Attraction{a, 1});
  world.remove_body(a);
  world.step();
  EXPECT_EQ(world.body(b).velocity(), (Vec2{0, 0}));
  world.insert_body(a);
  world.step();
  EXPECT_LT(world.body(b).velocity().x, 0);
}

}  // namespace
