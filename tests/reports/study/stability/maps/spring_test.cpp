#include <gtest/gtest.h>

#include <cmath>

#include "bracket.h"

namespace plumb {
namespace {

// w dt, where each integrator loses a spring; 1 % is the promise, 0.1 % the bracket.
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

TEST(SpringMap, HasNoStepForExplicitEuler) {
  const Bracket found = bracket("spring", "impulse:solver=exact,integrator=explicit-euler", 4, 0.003, 1, "bounded");
  EXPECT_FALSE(found.low) << "w dt = 0.012";
  EXPECT_EQ(found.seen.fate, Fate::gains_energy);
}

}  // namespace
}  // namespace plumb
