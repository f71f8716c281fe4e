#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "reports/run/selection.h"
#include "reports/study/stability/row.h"
#include "scenarios/parts.h"

namespace plumb::maps_test {
namespace {

// The bracket of a boundary of an engine in a map, bisected between two values of x.
Bracket bracket(const char* map_name, const char* engine, double y, double from, double to, const char* boundary) {
  const StabilityMap& map = *Catalog<StabilityMap>::find(map_name);
  const MapRow row = measure_row(map, {from, to}, y, parse_engine(engine));
  for (std::size_t i = 0; i < map.boundaries.size(); ++i) {
    if (map.boundaries[i].name == boundary) return row.brackets[i];
  }
  throw std::logic_error(boundary);
}

double middle(const Bracket& of) { return (of.low.value() + of.high.value()) / 2; }

TEST(SlopeMap, FindsTheAngleOfFriction) {
  for (const double mu : {0.2, 0.5, 0.8}) {
    const double angle = middle(bracket("slope", "impulse", mu, 1, 46, "sticks"));
    EXPECT_NEAR(angle, std::atan(mu) / degree, 0.1) << mu;
  }
}

TEST(TippingMap, FindsTheAngleOfTheDiagonal) {
  const double angle = middle(bracket("tipping", "impulse", 0.5, 5, 59, "stands"));
  EXPECT_NEAR(angle, std::atan(0.5) / degree, 0.5);
}

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

TEST(ArchMap, FallsWhereNoLineOfThrustFits) {
  const Bracket found = bracket("arch", "impulse", 0, 0.12, 0.09, "stands");
  EXPECT_EQ(found.outcome.mode, FailureMode::topples);
  EXPECT_GT(*found.low, *found.high) << "thick stones stand";
}

TEST(StackMap, HoldsMoreBoxesWithMoreWork) {
  const auto highest = [](const char* engine) { return *bracket("stack", engine, 0, 1, 30, "stands").low; };
  EXPECT_LT(highest("box2d:velocity=2"), highest("box2d:velocity=16"));
}

}  // namespace
}  // namespace plumb::maps_test
