#include <gtest/gtest.h>

#include <cmath>

#include "bracket.h"

namespace plumb::joints_test {
namespace {

TEST(ChainMap, FindsAChainThatTears) {
  const Bracket found = bracket("chain", "impulse:solver=article", 10, 1, 10000, "holds");
  EXPECT_EQ(found.outcome.mode, FailureMode::sinks);
}

// w dt at which a spring becomes unstable; 1 % is promised, 0.1 % is the bracket.
TEST(SpringMap, FindsTheLimitOfEveryIntegrator) {
  constexpr double w = 20;
  const auto limit = [](const char* engine) { return w * middle(bracket("spring", engine, w, 0.01, 1, "bounded")); };
  EXPECT_NEAR(limit("impulse:solver=exact"), 2, 0.02);
  EXPECT_NEAR(limit("impulse:solver=exact,integrator=velocity-verlet"), 2, 0.02);
  EXPECT_NEAR(limit("impulse:solver=exact,integrator=rk4"), 2 * std::sqrt(2.0), 0.02 * std::sqrt(2.0));
  EXPECT_NEAR(limit("impulse"), 8, 0.08) << "Verlet in four sub-steps";
  EXPECT_NEAR(limit("box2d"), 2, 0.02);
  EXPECT_NEAR(limit("chipmunk"), 2, 0.02);
}

TEST(SpringMap, FindsNoStableStepForExplicitEuler) {
  const Bracket found = bracket("spring", "impulse:solver=exact,integrator=explicit-euler", 4, 0.003, 1, "bounded");
  EXPECT_FALSE(found.low) << "w dt = 0.012";
  EXPECT_EQ(found.outcome.mode, FailureMode::gains_energy);
}

}  // namespace
}  // namespace plumb::joints_test
