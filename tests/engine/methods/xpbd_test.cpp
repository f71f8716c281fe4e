#include <gtest/gtest.h>

#include <cmath>

#include "../support.h"

namespace xpbd_test {
namespace {

using namespace impulse;

constexpr bool is_double = sizeof(Real) == sizeof(double);
constexpr double g = 10;

Settings xpbd(int substeps = 4) {
  Settings settings;
  settings.solver = "xpbd";
  settings.substeps = substeps;
  return settings;
}

// Positions are solved: penetration of g h^2 is removed completely in the same sub-step.
TEST(Xpbd, RestsADiscOnTheGround) {
  World world(xpbd());
  add_floor(world);
  const BodyId disc = world.create_body(at(0, .45), Shape::circle(real(.5)));
  world.step();
  EXPECT_NEAR(world.body(disc).position().y, .5, 16 * round_off);
  run(world, 120);
  EXPECT_NEAR(world.body(disc).position().y, .5, 16 * round_off);
  // Velocities are differences of positions over h: a rounding of the sub-step's motion, g h^2, over h.
  EXPECT_NEAR(world.body(disc).velocity().y, 0, is_double ? 1e-12 : 1e-6);
}

// The velocity that results from removing overlap is removed again.
TEST(Xpbd, RemovesDeepOverlapWithoutSpeed) {
  Settings settings = xpbd();
  settings.gravity = {};
  World world(settings);
  add_floor(world);
  const BodyId disc = world.create_body(at(0, .3), Shape::circle(real(.5)));
  world.step();
  EXPECT_NEAR(world.body(disc).position().y, .5, 16 * round_off);
  EXPECT_NEAR(world.body(disc).velocity().y, 0, is_double ? 1e-12 : 1e-4);
}

// Slower than two sub-steps of gravity there is no restitution.
TEST(Xpbd, BouncesOffOnlyAboveTwoSubstepsOfGravity) {
  const double threshold = 2 * g / 240;
  for (const double part : {.9, 1.1}) {
    World world(xpbd());
    add_floor(world, frictionless(1));
    BodyDef def = at(0, .5, 0, -part * threshold + g / 240);
    const BodyId disc = world.create_body(def, Shape::circle(real(.5)), frictionless(1));
    run(world, 1);
    // Off the ground in the first sub-step, and for three under gravity.
    const double flown = part < 1 ? 0 : (3 * part * threshold - 6 * g / 240) / 240;
    EXPECT_NEAR(world.body(disc).position().y, .5 + flown, is_double ? 1e-12 : 1e-6) << part;
  }
}

// Sub-steps are its iterations: twice as many, less penetration.
TEST(Xpbd, PenetratesLessWithMoreSubsteps) {
  const auto sink = [](int substeps) {
    World world(xpbd(substeps));
    add_floor(world);
    BodyId top;
    for (int i = 0; i < 3; ++i) top = world.create_body(at(0, .5 + i), Shape::box({real(.5), real(.5)}));
    run(world, 120);
    return 2.5 - static_cast<double>(world.body(top).position().y);
  };
  EXPECT_GT(sink(4), 0);
  EXPECT_LT(sink(8), sink(4) / 2);
}

TEST(Xpbd, ReportsTheImpulseThatHoldsALoad) {
  World world(xpbd());
  add_floor(world);
  world.create_body(at(0, .5), Shape::circle(real(.5)));
  run(world, 120);
  ASSERT_EQ(world.contacts().size(), 1U);
  const double weight = static_cast<double>(pi) / 4 * g;
  EXPECT_NEAR(world.contacts()[0].normal_impulse, weight / 60, is_double ? 1e-9 : 1e-5);
}

}  // namespace
}  // namespace xpbd_test
