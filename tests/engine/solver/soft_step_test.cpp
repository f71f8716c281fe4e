#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support.h"

namespace soft_step_test {
namespace {

using namespace impulse;

constexpr bool is_double = sizeof(Real) == sizeof(double);
constexpr double g = 10;

Settings soft_step(int substeps = 4) {
  Settings settings;
  settings.solver = "soft-step";
  settings.substeps = substeps;
  return settings;
}

/// A shape above the ground, on its own.
struct Drop {
  World world;
  BodyId body;

  Drop(const Settings& settings, const Shape& shape, double y, double vy = 0, double restitution = 0)
      : world(settings) {
    const Material material{1, real(.6), real(.6), real(restitution)};
    add_floor(world, material);
    body = world.create_body(at(0, y, 0, vy), shape, material);
  }
  void run(int steps) { impulse::run(world, steps); }
  double y() { return static_cast<double>(world.body(body).position().y); }
  double vy() { return static_cast<double>(world.body(body).velocity().y); }
};

// Rigid joints corrected by a share of their error a sub-step pumped this to 120 J and more.
TEST(SoftStep, GivesNoEnergyToABridgeBuiltStraight) {
  World world(soft_step());
  BodyDef bank = at(0, 0);
  bank.type = BodyType::fixed;
  BodyId last = world.create_body(bank, Shape::circle(real(.1)));
  for (int i = 0; i < 10; ++i) {
    const BodyId plank = world.create_body(at(i + .5, 0), Shape::box({real(.4), real(.1)}));
    world.create_joint(RevoluteJoint{last, plank, {real(i), 0}});
    last = plank;
  }
  bank.position = {10, 0};
  world.create_joint(RevoluteJoint{last, world.create_body(bank, Shape::circle(real(.1))), {10, 0}});
  double most = 0;
  for (int i = 0; i < 600; ++i) {
    world.step();
    double energy = 0;
    for (const BodyId id : world.bodies()) {
      const Body body = world.body(id);
      energy += static_cast<double>(body.mass().mass * (length_squared(body.velocity()) / 2 + 10 * body.center().y) +
                                    body.mass().inertia * body.angular_velocity() * body.angular_velocity() / 2);
    }
    most = std::max(most, energy);
  }
  EXPECT_LT(most, .1);
}

// load / (m_eff w^2) with w = 2 pi 60 Hz against the ground: a disc bears m g at m; each corner of a square m g/2 at
// 1/m_eff = 1/m + (a/2)^2/(m a^2/6) = 2.5/m.
TEST(SoftStep, RestsAtTheDepthOfItsSoftConstraints) {
  const double w = 2 * static_cast<double>(pi) * 60;
  const double tolerance = is_double ? 1e-9 : 1e-6;
  Drop disc(soft_step(8), Shape::circle(real(.5)), .5);
  disc.run(600);
  EXPECT_NEAR(.5 - disc.y(), g / (w * w), tolerance);
  Drop box(soft_step(8), Shape::box({real(.5), real(.5)}), .5);
  box.run(600);
  EXPECT_NEAR(.5 - box.y(), 1.25 * g / (w * w), tolerance);
}

// Symplectic Euler with sub-steps h: short by g t h/2, a quarter of a whole step's.
TEST(SoftStep, FallsLikeSymplecticEuler) {
  for (const int substeps : {1, 4, 10}) {
    Drop ball(soft_step(substeps), Shape::circle(real(.5)), 100);
    ball.run(60);
    EXPECT_NEAR(ball.y(), 95 - g / 120 / substeps, is_double ? 1e-9 : 1e-4) << substeps;
  }
}

TEST(SoftStep, BouncesOffOnlyAboveAMetrePerSecond) {
  Settings no_gravity = soft_step();
  no_gravity.gravity = {};
  Drop slow(no_gravity, Shape::circle(real(.5)), .6, -.9, .5);
  slow.run(60);
  EXPECT_LT(std::abs(slow.vy()), 1e-3);
  Drop fast(no_gravity, Shape::circle(real(.5)), .6, -1.1, .5);
  fast.run(60);
  EXPECT_NEAR(fast.vy(), .55, 1e-5);
}

// 3 m/s at most, and nothing of it is left in the velocity.
TEST(SoftStep, PushesDeepOverlapOutGently) {
  Settings no_gravity = soft_step();
  no_gravity.gravity = {};
  Drop ball(no_gravity, Shape::circle(real(.5)), .1);
  for (int i = 0; i < 60; ++i) {
    const double before = ball.y();
    ball.run(1);
    EXPECT_LE(ball.y() - before, 3.0 / 60 + 1e-6);
    EXPECT_NEAR(ball.vy(), 0, 1e-5);
  }
  EXPECT_GT(ball.y(), .49);
}

TEST(SoftStep, HoldsALoadWithTheImpulseOfItsWeight) {
  Drop box(soft_step(), Shape::box({real(.5), real(.5)}), .5);
  box.run(120);
  double sum = 0;
  for (const ContactInfo& contact : box.world.contacts()) sum += static_cast<double>(contact.normal_impulse);
  EXPECT_NEAR(sum, g / 60, is_double ? 1e-9 : 1e-5);
}

}  // namespace
}  // namespace soft_step_test
