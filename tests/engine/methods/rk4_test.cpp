#include <gtest/gtest.h>

#include "../support.h"

namespace {

using namespace impulse;

// Coarse steps, so that float shows the order too: 4e-5 of error at the finer one against 1e-6 of rounding.
TEST(RungeKutta4, IsOfFourthOrder) { EXPECT_NEAR(order_of_convergence("rk4", 4), 4, .3); }

TEST(RungeKutta4, IsOfFourthOrderInAirToo) { EXPECT_NEAR(order_of_convergence("rk4", 4, .5), 4, .3); }

// |1 + ih - h^2/2 - ih^3/6 + h^4/24|^2 = 1 - h^6/72 + h^8/576.
TEST(RungeKutta4, LosesEnergyOnASpringAsItsStabilityFunctionSays) {
  for (const double h : {0.5, 1.0, 2.0}) {
    Oscillator oscillator("rk4", h);
    const Real expected = real(1 - std::pow(h, 6) / 72 + std::pow(h, 8) / 576);
    for (int i = 0; i < 20; ++i) {
      const Real before = oscillator.energy();
      oscillator.world.step();
      EXPECT_NEAR(oscillator.energy() / before, expected, 100 * round_off) << h;
    }
  }
}

// That is below 1 up to h = 2 sqrt 2 = 2.828: .96 at 2.82, 1.06 at 2.84.
TEST(RungeKutta4, IsStableOnASpringUpToTwiceTheRootOfTwo) {
  Oscillator below("rk4", 2.82);
  run(below.world, 500);
  EXPECT_LT(below.energy(), real(1e-3));
  Oscillator above("rk4", 2.84);
  run(above.world, 500);
  EXPECT_GT(above.energy(), real(1e6));
}

TEST(RungeKutta4, IsExactInBallisticFlight) { EXPECT_NEAR(fall_error("rk4"), 0, 64 * 5 * 4 * round_off); }

// The bodies' stages are taken together: two on one spring keep their common centre where it was.
TEST(RungeKutta4, MovesCoupledBodiesTogether) {
  Settings settings = weightless(0.1);
  settings.integrator = "rk4";
  World world(settings);
  const BodyId a = world.create_body(at(-2, 0), Shape::circle(Real{0.5}));
  const BodyId b = world.create_body(at(2, 0), Shape::circle(Real{0.5}));
  world.add_force(Spring{a, b, {}, {}, 1, 3, 0});
  for (int i = 0; i < 100; ++i) {
    world.step();
    ASSERT_NEAR(world.body(a).position().x + world.body(b).position().x, 0, 100 * 4 * round_off);
  }
}

}  // namespace
