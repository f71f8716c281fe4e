#include <gtest/gtest.h>

#include "../support.h"

namespace integrator_test {
namespace {

using namespace impulse;

TEST(SymplecticEuler, IsOfFirstOrder) { EXPECT_NEAR(order_of_convergence("symplectic-euler", 64), 1, .1); }

// v' = v - h x, x' = x + h v' conserve x^2 + v^2 - h v x; each step rounds a few products of size 1.
TEST(SymplecticEuler, ConservesItsModifiedEnergyToRounding) {
  Oscillator oscillator("symplectic-euler", 0.25);
  const Real h = oscillator.world.dt();
  const auto conserved = [&] { return 2 * oscillator.energy() - h * oscillator.v() * oscillator.x(); };
  const Real start = conserved();
  for (int i = 0; i < 1000; ++i) oscillator.world.step();
  EXPECT_NEAR(conserved(), start, 1000 * 8 * round_off);
}

// It follows that x^2 (1 - h^2/4) <= the conserved value, here 1.
TEST(SymplecticEuler, StaysBoundedOnASpringUpToAStepOfTwo) {
  Oscillator oscillator("symplectic-euler", 1.99);
  const Real bound = 1 / std::sqrt(1 - real(1.99 * 1.99 / 4));
  for (int i = 0; i < 10000; ++i) {
    oscillator.world.step();
    ASSERT_LE(std::abs(oscillator.x()), real(1.01) * bound);
  }
}

// The eigenvalues have the sum 2 - h^2 = -2.04 and the product 1: one is -1.22.
TEST(SymplecticEuler, DivergesBeyondAStepOfTwo) {
  Oscillator oscillator("symplectic-euler", 2.01);
  run(oscillator.world, 100);
  EXPECT_GT(std::abs(oscillator.x()), real(1e6));
}

TEST(SymplecticEuler, FallsTooFarByHalfAStepAtTheFinalSpeed) {
  EXPECT_NEAR(fall_error("symplectic-euler"), -10 * 1.0 / 64 / 2, 64 * 5 * round_off);
}

TEST(SymplecticEuler, IsStableForAnyDamping) {
  Settings settings;
  settings.solver = "article";
  World world(settings);
  BodyDef def = at(0, 0, 100, 0);
  def.linear_damping = 10000;
  const BodyId body = world.create_body(def, Shape::circle(1));
  for (int i = 0; i < 10; ++i) {
    const Real before = world.body(body).velocity().x;
    world.step();
    EXPECT_LT(world.body(body).velocity().x, before);
    EXPECT_GE(world.body(body).velocity().x, 0);
  }
  // The terminal velocity g/d is exact.
  EXPECT_NEAR(world.body(body).velocity().y, real(-10.0 / 10000), real(-10.0 / 10000) * -8 * round_off);
}

}  // namespace
}  // namespace integrator_test
