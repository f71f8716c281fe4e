#include "reports/run/horizon.h"

#include <gtest/gtest.h>

#include "reports/run/beyond.h"
#include "reports/run/selection.h"
#include "scenarios/transformed.h"

namespace plumb {
namespace {

constexpr double dt = 1.0 / 60;

std::optional<double> scene_horizon(const char* word) { return horizon_of(*parse_cases(word).front().scene, dt); }

TEST(Horizon, IsShorterThanTheRunWhereMotionIsChaotic) {
  for (const char* word : {"gas", "rain:seed 1", "tumbler:boxes", "double-pendulum:duration=20"}) {
    const auto horizon = scene_horizon(word);
    ASSERT_TRUE(horizon) << word;
    EXPECT_GT(*horizon, 0.1) << word;
  }
}

TEST(Horizon, IsNotReachedWhereMotionIsRegular) {
  for (const char* word : {"spring", "bounce", "pendulum", "orbit", "stacking:ten", "double-pendulum:small", "slope"}) {
    EXPECT_FALSE(scene_horizon(word)) << word;
  }
}

// Differences grow exponentially: what starts a thousand times farther apart parts sooner, but not by much.
TEST(Horizon, ComesSoonerForCoarserArithmetic) {
  const Case wild = parse_case("double-pendulum:duration=20");
  const auto own = [&](const char* word) {
    const EngineConfig config = parse_engine(word);
    const Outcome outcome = run(*wild.scene, config, dt);
    return horizon_of(*wild.scene, config, dt, *outcome.trace).value_or(20);
  };
  EXPECT_LT(own("impulse:precision=float"), own("impulse"));
  EXPECT_GT(own("impulse:precision=float"), 1);
}

TEST(Horizon, StartsDifferByABillionthOrByWhatTheArithmeticTells) {
  Scene scene = *parse_case("spring").scene;
  scene.bodies.front().position = {1, 0};
  EXPECT_EQ(smallest_difference(scene, {.epsilon = 0x1p-53}), 1e-9);
  scene.bodies.front().position = {1000, 0};
  EXPECT_EQ(smallest_difference(scene, {.epsilon = 0x1p-24}), 8000 * 0x1p-24);
}

TEST(Perturbed, MovesDynamicBodiesOnlyAndAlikeForTheSameSeed) {
  const Scene scene = *parse_case("pyramid").scene;
  const Scene moved = perturbed(scene, 0.01, 3);
  const Scene again = perturbed(scene, 0.01, 3);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Vec from = scene.bodies[i].position;
    const Vec to = moved.bodies[i].position;
    EXPECT_EQ(to, again.bodies[i].position);
    EXPECT_EQ(to == from, scene.bodies[i].type != BodyType::dynamic);
    EXPECT_NEAR(to.x, from.x, 0.01);
    EXPECT_NEAR(to.y, from.y, 0.01);
  }
}

}  // namespace
}  // namespace plumb
