#include "reports/study/stability/map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "reports/run/selection.h"
#include "reports/study/stability/row.h"
#include "scenarios/parts.h"

namespace plumb::maps_test {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

TEST(Axis, SpacesItsValuesEvenlyWithExactEnds) {
  EXPECT_THAT((Axis{.from = 1, .to = 4}.values(4)), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT((Axis{.from = 4, .to = 1}.values(3)), ElementsAre(4, 2.5, 1)) << "in either direction";
  EXPECT_THAT((Axis{.from = 0.1, .to = 10, .logarithmic = true}.values(3)), ElementsAre(0.1, DoubleNear(1, 1e-12), 10));
}

TEST(Axis, OfIntegersHasEachOnce) {
  const Axis axis{.from = 1, .to = 8, .logarithmic = true, .whole = true};
  EXPECT_THAT(axis.values(7), ElementsAre(1, 2, 3, 4, 6, 8));
}

TEST(Axis, BisectsAnInterval) {
  EXPECT_EQ((Axis{}.between(1, 2)), 1.5);
  EXPECT_DOUBLE_EQ((Axis{.logarithmic = true}.between(1, 4)), 2);
  const Axis whole{.whole = true};
  EXPECT_EQ(whole.between(4, 6), 5);
  EXPECT_EQ(whole.between(4, 5), 4) << "no integer is between";
  EXPECT_EQ(whole.between(5, 4), 5) << "no integer is between";
}

TEST(StabilityMaps, AreKnown) {
  std::vector<std::string> names;
  for (const StabilityMap* map : Catalog<StabilityMap>::all()) names.push_back(map->name);
  EXPECT_THAT(names, ElementsAre("arch", "chain", "mass-ratio", "overhang", "restitution", "slope", "spring", "stack",
                                 "tipping", "tunnelling"));
}

TEST(StabilityMaps, HaveAQuestionAndASourceOfTheirTheory) {
  for (const StabilityMap* map : Catalog<StabilityMap>::all()) {
    EXPECT_TRUE(map->question.ends_with("?")) << map->name;
    ASSERT_FALSE(map->boundaries.empty()) << map->name;
    for (const Boundary& boundary : map->boundaries) {
      EXPECT_EQ(boundary.theory == nullptr, boundary.source.empty()) << map->name;
      EXPECT_EQ(boundary.theory == nullptr, boundary.agreement == 0) << map->name;
      EXPECT_TRUE(map->x.whole || boundary.resolution > 0) << map->name;
      // The width of a bracket must not decide whether it agrees with theory.
      if (boundary.theory) {
        EXPECT_LE(boundary.resolution, boundary.agreement / 2) << map->name;
      }
    }
  }
}

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
