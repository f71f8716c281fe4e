#include <gtest/gtest.h>

#include "../support.h"

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

}  // namespace
