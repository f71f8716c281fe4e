#include "reference/exact/plank.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "integrate.h"
#include "reference/simulation.h"
#include "scenarios/scenario.h"

namespace plumb {
namespace {

const Plank::Case soft{
    .plank = 5, .body = 3, .radius = 0.4, .pull = 12, .gravity = 10, .static_friction = 0.5, .dynamic_friction = 0.5};

// Friction as a very stiff brake on the slip, c (V - v - w r), at most mu m g: it knows nothing of rolling. What it
// gives of the motion is as stiff a spring away from Coulomb's as 1/c.
TEST(Plank, AgreesWithABrakeOnTheSlipThatKnowsNothingOfRolling) {
  for (const double pull : {12.0, 200.0}) {
    Plank::Case c = soft;
    c.pull = pull;
    const double inertia = c.body * c.radius * c.radius / c.shape;
    constexpr double brake = 1e6;  // N s/m
    std::array<double, 3> y{};     // V, v, w
    constexpr int steps = 400000;
    for (int i = 0; i < steps; ++i) {
      y = runge_kutta(y, 1.0 / steps, [&](const std::array<double, 3>& now) {
        const double most = c.dynamic_friction * c.body * c.gravity;
        const double f = std::clamp(brake * (now[0] - now[1] - now[2] * c.radius), -most, most);
        return std::array<double, 3>{(c.pull - f) / c.plank, f / c.body, f * c.radius / inertia};
      });
    }
    const Plank motion(c);
    EXPECT_EQ(motion.rolls(), pull < 100);
    // The brake's slip, f/c, and its beginning, within m/c seconds, are what it lacks.
    const double lacks = 1e-9 * pull + pull / brake;
    EXPECT_NEAR(y[0], motion.plank(), lacks) << pull;
    EXPECT_NEAR(y[1], motion.body(), lacks) << pull;
    EXPECT_NEAR(y[2], motion.spin(), 2 * lacks / c.radius) << pull;
  }
}

TEST(Plank, KeepsNewtonsLawForBothAndTheRimWithThePlank) {
  const Plank motion(soft);
  EXPECT_NEAR(soft.plank * motion.plank() + soft.body * motion.body(), soft.pull, 1e-14 * soft.pull);
  EXPECT_NEAR(motion.body() + motion.spin() * soft.radius, motion.plank(), 1e-14);
  EXPECT_NEAR(motion.body(), motion.plank() / 3, 1e-15);
  EXPECT_NEAR(motion.plank(), soft.pull / (soft.plank + soft.body / 3), 1e-14);
}

// mu g (3 M + m) is the hardest pull that a disc follows without slipping.
TEST(Plank, RollsUpToTheFrictionThatItTakes) {
  Plank::Case c = soft;
  const double limit = c.static_friction * c.gravity * (3 * c.plank + c.body);
  c.pull = limit * (1 - 1e-12);
  EXPECT_TRUE(Plank(c).rolls());
  c.pull = limit * (1 + 1e-12);
  EXPECT_FALSE(Plank(c).rolls());
  EXPECT_NEAR(Plank(c).body(), c.dynamic_friction * c.gravity, 1e-15);
}

TEST(Plank, UnderAWeightlessBodyIsPulledAloneAndABodyOnIceStays) {
  Plank::Case c = soft;
  c.body = 1e-12;
  EXPECT_NEAR(Plank(c).plank(), c.pull / c.plank, 1e-12);
  c = soft;
  c.static_friction = c.dynamic_friction = 0;
  EXPECT_EQ(Plank(c).body(), 0);
  EXPECT_EQ(Plank(c).spin(), 0);
}

// Forces twice as large on masses twice as large, lengths thrice as long.
TEST(Plank, ScalesAsItsUnitsDo) {
  Plank::Case c = soft;
  c.plank *= 2;
  c.body *= 2;
  c.pull *= 2;
  c.radius *= 3;
  EXPECT_NEAR(Plank(c).plank(), Plank(soft).plank(), 1e-15);
  EXPECT_NEAR(Plank(c).spin(), Plank(soft).spin() / 3, 1e-15);
}

TEST(PlankScene, IsRefusedWithFrictionOnTheFloor) {
  const Scenario& family = *Catalog<Scenario>::find("pushed-plank");
  Scene scene = family.scene(complete(family, {}));
  const Engine& plank = *Catalog<Engine>::find("plank");
  EXPECT_EQ(plank.unsupported(scene, {}), "");
  scene.bodies[0].shapes[0].surface.dynamic_friction = 0.1;
  EXPECT_NE(plank.unsupported(scene, {}), "");
}

}  // namespace
}  // namespace plumb
