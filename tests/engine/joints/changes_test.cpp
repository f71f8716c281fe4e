// Motors and limits that change while the world runs.
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "../real_literal.h"
#include "impulse/impulse.h"

namespace impulse::inline IMPULSE_PRECISION::joint_changes_test {
namespace {

constexpr Real round_off = std::numeric_limits<Real>::epsilon() / 2;

void steps(World& world, int count) {
  for (int i = 0; i < count; ++i) world.step();
}

/// A wheel on a fixed axle, and a slider on a level rail, without gravity.
struct Machine {
  World world;
  BodyId wheel, slider;
  JointId axle, rail;

  explicit Machine(Settings settings = {}) : world(without_gravity(settings)) {
    BodyDef def;
    def.type = BodyType::fixed;
    def.layers = 1;
    const BodyId base = world.create_body(def, Shape::circle(0.1_r));
    def.type = BodyType::dynamic;
    def.layers = 2;
    wheel = world.create_body(def, Shape::circle(1));
    def.position = {5, 0};
    slider = world.create_body(def, Shape::box({0.5_r, 0.5_r}));
    axle = world.create_joint(RevoluteJoint{.a = base, .b = wheel, .anchor = {0, 0}});
    rail = world.create_joint(PrismaticJoint{.a = base, .b = slider, .anchor = {5, 0}, .axis = {1, 0}});
  }
  static Settings without_gravity(Settings settings) {
    settings.gravity = {};
    return settings;
  }
};

TEST(SetMotor, DrivesAJointAtItsNewSpeedUntilItIsRemoved) {
  Machine machine;
  World& world = machine.world;
  world.set_motor(machine.axle, Motor{3, 1000});
  world.set_motor(machine.rail, Motor{-2, 1000});
  steps(world, 2);
  // The motor's strength exceeds what one sub-step needs, so its row is solved to rounding.
  EXPECT_NEAR(world.body(machine.wheel).angular_velocity(), 3, 64 * round_off);
  EXPECT_NEAR(world.body(machine.slider).velocity().x, -2, 64 * round_off);
  world.set_motor(machine.axle, Motor{-1, 1000});
  steps(world, 2);
  EXPECT_NEAR(world.body(machine.wheel).angular_velocity(), -1, 64 * round_off);
  world.set_motor(machine.axle, {});
  world.body(machine.wheel).set_velocity({}, 7);
  steps(world, 10);
  EXPECT_NEAR(world.body(machine.wheel).angular_velocity(), 7, 512 * round_off);
}

// A torque T on an inertia I for a time t: w = T t / I.
TEST(SetMotor, PushesNoHarderThanItsNewStrength) {
  Machine machine;
  World& world = machine.world;
  world.set_motor(machine.axle, Motor{100, 5});
  steps(world, 60);
  const Real inertia = world.body(machine.wheel).mass().inertia;
  EXPECT_NEAR(world.body(machine.wheel).angular_velocity() * inertia / 5, 1, 4096 * round_off);
}

TEST(SetLimits, StopAJointWhereTheyNowAre) {
  Machine machine;
  World& world = machine.world;
  world.set_limits(machine.rail, Limits{0, 1});
  world.body(machine.slider).set_velocity({3, 0}, 0);
  steps(world, 60);
  const Real tolerance = stated_errors(world.settings()).joint_gap;
  EXPECT_NEAR(world.body(machine.slider).position().x, 6, tolerance);
  world.set_limits(machine.rail, Limits{0, 2});
  world.body(machine.slider).set_velocity({3, 0}, 0);
  steps(world, 60);
  EXPECT_NEAR(world.body(machine.slider).position().x, 7, tolerance);
  world.set_limits(machine.rail, {});
  world.body(machine.slider).set_velocity({3, 0}, 0);
  steps(world, 60);
  EXPECT_NEAR(world.body(machine.slider).position().x, 10, tolerance);
}

TEST(SetMotor, AndLimitsWakeTheBodies) {
  Settings settings;
  settings.sleeping = true;
  Machine machine(settings);
  World& world = machine.world;
  steps(world, 120);
  ASSERT_EQ(world.awake_count(), 0U);
  world.set_motor(machine.axle, Motor{1, 10});
  EXPECT_TRUE(world.body(machine.wheel).awake());
  EXPECT_FALSE(world.body(machine.slider).awake());
  world.set_limits(machine.rail, Limits{1, 2});
  EXPECT_TRUE(world.body(machine.slider).awake());
}

TEST(SetMotor, AndLimitsRefuseBadValuesAndOtherJointsAndChangeNothing) {
  Machine machine;
  World& world = machine.world;
  const Real infinite = std::numeric_limits<Real>::infinity();
  EXPECT_THROW(world.set_motor(machine.axle, Motor{infinite, 1}), std::invalid_argument);
  EXPECT_THROW(world.set_motor(machine.axle, Motor{1, -1}), std::invalid_argument);
  EXPECT_THROW(world.set_limits(machine.axle, Limits{1, 0}), std::invalid_argument);
  steps(world, 10);
  EXPECT_EQ(world.body(machine.wheel).angular_velocity(), 0);
  const JointId weld = world.create_joint(WeldJoint{.a = machine.wheel, .b = machine.slider, .anchor = {0, 0}});
  EXPECT_THROW(world.set_motor(weld, Motor{1, 1}), std::invalid_argument);
  EXPECT_THROW(world.set_limits(weld, Limits{0, 1}), std::invalid_argument);
  world.destroy_joint(weld);
  EXPECT_THROW(world.set_motor(weld, Motor{1, 1}), std::out_of_range);
  EXPECT_THROW(world.set_limits(weld, Limits{0, 1}), std::out_of_range);
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::joint_changes_test
