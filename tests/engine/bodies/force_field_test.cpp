#include "bodies/force_field.h"

#include <gtest/gtest.h>

#include "../support.h"

namespace {

using namespace impulse;

/// Speed of a body after one step under its weight and no other force.
using FreeFall = Vec2 (*)(Real mass, Vec2 gravity, Real dt);

/// Galileo: whatever the mass, v = g dt.
bool falls_alike(FreeFall fall) {
  const Vec2 gravity{0, -10};
  const Real dt = 1 / Real{64};
  for (const double mass : {1e-3, 1.0, 1e3}) {
    if (!(fall(real(mass), gravity, dt) == dt * gravity)) return false;
  }
  return true;
}

Vec2 as_the_engine(Real mass, Vec2 gravity, Real dt) {
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

// velocity += force * (1.0f / mass + gravity) * dt, componentwise; the force is the weight or nothing.
Vec2 as_printed_with_weight(Real mass, Vec2 gravity, Real dt) {
  const Vec2 force = mass * gravity;
  return {force.x * (1 / mass + gravity.x) * dt, force.y * (1 / mass + gravity.y) * dt};
}
Vec2 as_printed_without(Real, Vec2, Real) { return {0, 0}; }

TEST(ForceField, MakesBodiesOfAnyMassFallAlike) { EXPECT_TRUE(falls_alike(as_the_engine)); }

TEST(ForceField, AsThePrintHasItWouldNot) {
  EXPECT_FALSE(falls_alike(as_printed_with_weight));
  EXPECT_FALSE(falls_alike(as_printed_without));
}

TEST(ForceField, LetsTwoOppositeForcesCancelExactly) {
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

TEST(ForceField, UsesCollectedForcesForOneStepOnly) {
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

// The print has r x w; a force of 3 N at an arm of 2 m turns with 6 N m.
TEST(ForceField, TurnsByArmTimesForce) {
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

TEST(ForceField, NeverMovesWhatHasNoMass) {
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

TEST(ForceField, DampsTurningToo) {
  World world(weightless(0.5));
  BodyDef def;
  def.angular_velocity = 3;
  def.angular_damping = 4;
  const BodyId id = world.create_body(def, Shape::circle(1));
  world.step();
  EXPECT_EQ(world.body(id).angular_velocity(), 1);  // 3/(1 + .5 * 4)
}

}  // namespace
