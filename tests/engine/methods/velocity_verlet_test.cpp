#include <gtest/gtest.h>

#include "../support.h"

namespace {

using namespace impulse;

TEST(VelocityVerlet, IsOfSecondOrder) { EXPECT_NEAR(order_of_convergence("velocity-verlet", 16), 2, .1); }

TEST(VelocityVerlet, IsOfSecondOrderInAirToo) { EXPECT_NEAR(order_of_convergence("velocity-verlet", 16, .5), 2, .1); }

// Kick-drift-kick on x'' = -x leaves v^2 + x^2 (1 - h^2/4) as it was.
TEST(VelocityVerlet, KeepsTheEnergyItConservesToRounding) {
  Oscillator oscillator("velocity-verlet", 0.25);
  const Real h = oscillator.world.dt();
  const auto conserved = [&] { return 2 * oscillator.energy() - h * h / 4 * oscillator.x() * oscillator.x(); };
  const Real start = conserved();
  for (int i = 0; i < 1000; ++i) oscillator.world.step();
  EXPECT_NEAR(conserved(), start, 1000 * 8 * round_off);
}

// From there, with x = 1 and v = 0 at the start: |x| never exceeds 1, but for rounding.
TEST(VelocityVerlet, StaysBoundedOnASpringUpToTwo) {
  Oscillator oscillator("velocity-verlet", 1.99);
  for (int i = 0; i < 10000; ++i) {
    oscillator.world.step();
    ASSERT_LE(std::abs(oscillator.x()), real(1.01));
  }
}

TEST(VelocityVerlet, ExplodesBeyondTwo) {
  Oscillator oscillator("velocity-verlet", 2.01);
  run(oscillator.world, 100);
  EXPECT_GT(std::abs(oscillator.x()), real(1e6));
}

TEST(VelocityVerlet, IsExactInBallisticFlight) { EXPECT_NEAR(fall_error("velocity-verlet"), 0, 64 * 5 * round_off); }

// Half a kick after the contacts were solved would leave it sinking at g h/2.
TEST(VelocityVerlet, LeavesAHeldBodyAtRest) {
  Settings settings;
  settings.solver = "article";
  settings.integrator = "velocity-verlet";
  World world(settings);
  add_floor(world);
  const BodyId disc = world.create_body(at(0, .498), Shape::circle(Real{0.5}));
  run(world, 120);
  EXPECT_NEAR(world.body(disc).velocity().y, 0, 10 * round_off);
}

}  // namespace
