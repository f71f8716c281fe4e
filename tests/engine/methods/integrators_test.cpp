#include <gtest/gtest.h>

#include "../support.h"

namespace integrators_test {
namespace {

using namespace impulse;

// x' = x + dt v, v' = v - dt x: x'^2 + v'^2 = (1 + dt^2)(x^2 + v^2).
TEST(ExplicitEuler, MultipliesTheEnergyOfASpringByOnePlusTheSquareOfTheStepEveryStep) {
  for (const double dt : {0.01, 0.1, 0.5}) {
    Oscillator oscillator("explicit-euler", dt);
    const Real h = oscillator.world.dt();
    for (int i = 0; i < 20; ++i) {
      const Real before = oscillator.energy();
      oscillator.world.step();
      EXPECT_NEAR(oscillator.energy() / before, 1 + h * h, 20 * round_off) << dt;
    }
  }
}

// The error's next term is about h times the first: log2(1 + h) < .1 at h = 2/64.
TEST(ExplicitEuler, IsOfFirstOrder) { EXPECT_NEAR(order_of_convergence("explicit-euler", 64), 1, .1); }

// Each step moves with the speed at its start, g h/2 short of the mean: g t h/2 in all.
TEST(ExplicitEuler, FallsShortByHalfAStepOfSpeed) {
  EXPECT_NEAR(fall_error("explicit-euler"), 10 * 1.0 / 64 / 2, 64 * 5 * round_off);
}

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
}  // namespace integrators_test
