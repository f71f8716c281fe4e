#include <gtest/gtest.h>

#include "bracket.h"

namespace plumb::impacts_test {
namespace {

TEST(RestitutionMap, FindsABounceThatIsTooHigh) {
  const Bracket found = bracket("restitution", "impulse:solver=article", 0.8, 1.0 / 240, 0.1, "bounces");
  EXPECT_EQ(found.outcome.mode, FailureMode::gains_energy);
  EXPECT_EQ(found.outcome.body, "disc");
}

TEST(TunnellingMap, FindsTheSpeedThatPassesUnseenAndTheOneThatIsNotStopped) {
  constexpr double wall = 0.2;
  const double unseen = 60 * (wall + 0.5);  // m/s
  for (const char* engine : {"impulse:solver=split-impulse,continuous=off", "box2d:continuous=off", "chipmunk"}) {
    EXPECT_NEAR(middle(bracket("tunnelling", engine, wall, 5, 115, "unseen")) / unseen, 1, 0.05) << engine;
    EXPECT_NEAR(middle(bracket("tunnelling", engine, wall, 5, 115, "stopped")) / (unseen / 2), 1, 0.05) << engine;
  }
}

TEST(TunnellingMap, FindsNoSpeedWithContinuousCollisionOrASolverThatLooksAhead) {
  for (const char* engine : {"impulse:solver=split-impulse", "impulse", "impulse:continuous=off", "box2d"}) {
    EXPECT_FALSE(bracket("tunnelling", engine, 0.05, 5, 115, "stopped").high) << engine;
  }
}

}  // namespace
}  // namespace plumb::impacts_test
