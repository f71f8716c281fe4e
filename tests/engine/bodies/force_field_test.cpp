#include "bodies/force_field.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "../support.h"

namespace force_field_test {
namespace {

using namespace impulse;

/// The velocity of a body after one step under its weight alone.
using FreeFall = Vec2 (*)(Real mass, Vec2 gravity, Real dt);

/// Galileo: v = g dt for any mass.
bool is_independent_of_mass(FreeFall fall) {
  const Vec2 gravity{0, -10};
  const Real dt = 1 / Real{64};
  for (const double mass : {1e-3, 1.0, 1e3}) {
    if (!(fall(real(mass), gravity, dt) == dt * gravity)) return false;
  }
  return true;
}

Vec2 fall_in_engine(Real mass, Vec2 gravity, Real dt) {
  Settings settings;
  settings.solver = "article";
  settings.gravity = gravity;
  settings.dt = dt;
  World world(settings);
  Material material;
  material.density = mass / 4;
  const BodyId body = world.create_body({}, Shape::box({1, 1}), material);
  world.step();
  return world.body(body).velocity();
}

// As the article prints it: velocity += force * (1.0f / mass + gravity) * dt, componentwise, where the force is the
// weight or zero.
Vec2 printed_fall_with_weight(Real mass, Vec2 gravity, Real dt) {
  const Vec2 force = mass * gravity;
  return {force.x * (1 / mass + gravity.x) * dt, force.y * (1 / mass + gravity.y) * dt};
}
Vec2 printed_fall_without_weight(Real, Vec2, Real) { return {0, 0}; }

TEST(ForceField, MakesBodiesOfAnyMassFallEqually) { EXPECT_TRUE(is_independent_of_mass(fall_in_engine)); }

TEST(ForceField, PrintedFormulaDoesNotMakeBodiesFallEqually) {
  EXPECT_FALSE(is_independent_of_mass(printed_fall_with_weight));
  EXPECT_FALSE(is_independent_of_mass(printed_fall_without_weight));
}

TEST(ForceField, CancelsOppositeForcesExactly) {
  World world(weightless());
  const BodyId id = world.create_body(at(1, 2), Shape::box({1, 1}));
  Body body = world.body(id);
  const Vec2 force{real(0.1), real(-12345.678)};
  body.apply_force(force, {3, 4});
  body.apply_force(-force, {3, 4});
  world.step();
  EXPECT_EQ(body.velocity(), (Vec2{0, 0}));
  EXPECT_EQ(body.angular_velocity(), 0);
}

TEST(ForceField, AppliesAccumulatedForcesForOneStepOnly) {
  World world(weightless(0.5));
  const BodyId id = world.create_body({}, Shape::box({1, 1}));
  Body body = world.body(id);
  body.apply_force({4, 0});
  body.apply_force({0, 8});
  body.apply_torque(Real{0.5});
  world.step();
  EXPECT_EQ(body.velocity(), (Vec2{Real{0.5}, 1}));  // 4 kg
  const Real w = body.angular_velocity();
  EXPECT_NEAR(w, 0.5 / (4 * 8 / 12.0) * 0.5, 4 * round_off);
  world.step();
  EXPECT_EQ(body.velocity(), (Vec2{Real{0.5}, 1}));
  EXPECT_EQ(body.angular_velocity(), w);
}

// Torque is r x F (the article prints r x w): 3 N at an arm of 2 m give 6 N m.
TEST(ForceField, AppliesTheTorqueOfAForce) {
  World world(weightless(1));
  const BodyId id = world.create_body({}, Shape::box({1, 1}));
  Body body = world.body(id);
  body.set_velocity({}, 1);
  body.apply_force({0, 3}, {2, 0});
  world.step();
  EXPECT_NEAR(body.angular_velocity(), 1 + 6 / (4 * 8 / 12.0), 8 * round_off);
}

TEST(ForceField, ScalesGravityByBody) {
  Settings settings;
  settings.solver = "article";
  settings.dt = Real{0.5};
  World world(settings);
  BodyDef def;
  def.gravity_scale = -2;
  const BodyId id = world.create_body(def, Shape::circle(1));
  world.step();
  EXPECT_EQ(world.body(id).velocity(), (Vec2{0, 10}));
  world.body(id).set_gravity_scale(0);
  world.step();
  EXPECT_EQ(world.body(id).velocity(), (Vec2{0, 10}));
}

TEST(ForceField, NeverMovesBodiesWithoutMass) {
  World world;
  const BodyId floor = add_floor(world);
  BodyDef def;
  def.type = BodyType::kinematic;
  def.velocity = {1, 0};
  def.position = {0, 50};
  const BodyId lift = world.create_body(def, Shape::box({1, 1}));
  for (int i = 0; i < 10; ++i) {
    world.body(floor).apply_force({100, 100});
    world.body(lift).apply_force({100, 100});
    world.step();
  }
  EXPECT_EQ(world.body(floor).position(), (Vec2{0, 0}));
  EXPECT_EQ(world.body(lift).velocity(), (Vec2{1, 0}));
  EXPECT_EQ(world.body(lift).position().y, 50);
}

TEST(ForceField, DampsRotationToo) {
  World world(weightless(0.5));
  BodyDef def;
  def.angular_velocity = 3;
  def.angular_damping = 4;
  const BodyId id = world.create_body(def, Shape::circle(1));
  world.step();
  EXPECT_EQ(world.body(id).angular_velocity(), 1);  // 3/(1 + .5 * 4)
}

/// Where a disc of 1 mm is after 9 steps past an attraction at 8 m/s, from 0.6 m before it and 2 cm beside it.
Vec2 attracted_aside(int substeps) {
  Settings settings = falling(0);
  settings.substeps = substeps;
  World world(settings);
  BodyDef sun = at(0, 0);
  sun.type = BodyType::fixed;
  const BodyId from = world.create_body(sun, Shape::circle(real(.001)));
  const BodyId disc = world.create_body(at(-.6, .02, 8), Shape::circle(real(.001)));
  world.add_force(Attraction{from, real(.4), 1});
  run(world, 9);
  return world.body(disc).position();
}

// In a quarter of a step it goes by twice the distance at which it passes.
TEST(ForceField, IsFollowedWhereABodyPassesWhatAttractsIt) {
  EXPECT_LT(length(attracted_aside(4) - attracted_aside(512)), 1e-5);
}

/// The acceleration of a body at a distance of 2 m from an attraction of strength 3.
Vec2 attracted_with(double exponent, double reach = HUGE_VAL) {
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
  EXPECT_EQ(attracted_with(2), (Vec2{0, -Real{3} / 4}));
  EXPECT_EQ(attracted_with(1), (Vec2{0, -Real{3} / 2}));
  EXPECT_EQ(attracted_with(0), (Vec2{0, -3}));
  EXPECT_EQ(attracted_with(-1), (Vec2{0, -6}));
  EXPECT_NEAR(attracted_with(.5).y, -3 / std::sqrt(2), 8 * round_off);
  EXPECT_NEAR(attracted_with(-2.5).y, -3 * std::pow(2, 2.5), 64 * round_off);
}

TEST(Attraction, EndsBeyondItsReach) {
  EXPECT_EQ(attracted_with(2, 1), (Vec2{0, 0}));
  EXPECT_EQ(attracted_with(2, 2), (Vec2{0, -Real{3} / 4}));
}

TEST(Attraction, RejectsPowersThatDifferBetweenMachines) {
  EXPECT_THROW(attracted_with(2.3), std::invalid_argument);
  EXPECT_THROW(attracted_with(40), std::invalid_argument);
  EXPECT_THROW(attracted_with(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(attracted_with(2, -1), std::invalid_argument);
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

TEST(Attraction, DoesNotActOnItsSourceUnlessMutual) {
  World world(weightless(0.1));
  const BodyId heavy = world.create_body(at(0, 0), Shape::circle(1));
  world.create_body(at(5, 1), Shape::circle(Real{0.25}));
  world.add_force(Attraction{heavy, 2});
  run(world, 10);
  EXPECT_EQ(world.body(heavy).velocity(), (Vec2{0, 0}));
}

// Velocity Verlet follows exactly a modified energy with the additional term h^2 (p.V''p/12 - |V'|^2/24), here
// h^2 (L^2/(12 r^5) - 1/(24 r^4)). It moves a circular orbit of radius 1 outwards by h^2/4, so the radius oscillates
// between 1 and 1 + h^2/2 and does not drift.
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

TEST(SpringForce, PullsBothEndsEqually) {
  World world(weightless(1));
  const BodyId a = world.create_body(at(0, 0), Shape::box({1, 1}));
  const BodyId b = world.create_body(at(6, 0), Shape::box({1, 1}));
  world.add_force(Spring{a, b, {1, 0}, {-1, 0}, 2, 3, 0});  // 4 m between the anchors
  world.step();
  EXPECT_EQ(world.body(a).velocity(), (Vec2{Real{0.5}, 0}));
  EXPECT_EQ(world.body(b).velocity(), (Vec2{-Real{0.5}, 0}));
}

TEST(SpringForce, RotatesABodyAttachedOffCentre) {
  World world(weightless(1));
  const BodyId body = world.create_body(at(0, 0), Shape::box({1, 1}));
  world.add_force(Spring{body, {}, {1, 0}, {1, 5}, 1, 2, 0});  // 3 N upwards at an arm of 1 m
  world.step();
  EXPECT_EQ(world.body(body).velocity(), (Vec2{0, Real{0.75}}));
  EXPECT_NEAR(world.body(body).angular_velocity(), 3 / (4 * 8 / 12.0), 4 * round_off);
}

TEST(SpringForce, DampsTheSeparatingVelocityOfTheAnchors) {
  World world(weightless(0.5));
  const BodyId body = world.create_body(at(2, 0, 1, 5), Shape::box({1, 1}));
  world.add_force(Spring{{}, body, {}, {}, 0, 0, 4});
  world.step();
  EXPECT_EQ(world.body(body).velocity(), (Vec2{Real{0.5}, 5}));  // 1 - .5 * 4/4 along the spring, unchanged across it
}

TEST(SpringForce, RejectsInvalidValues) {
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

TEST(Force, EndsWithAnyOfItsBodies) {
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
  world.create_body(at(0, 0), Shape::box({1, 1}));  // in the same row: no force of the old body acts on it
  world.step();
  EXPECT_EQ(world.body(b).velocity(), (Vec2{1, 0}));
}

TEST(Force, PausesWhileItsBodyIsOutOfTheWorld) {
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
}  // namespace force_field_test
