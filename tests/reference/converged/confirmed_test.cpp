#include "reference/converged/converged.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "reports/run/run.h"
#include "scenarios/scenario.h"

namespace plumb::confirmed_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr double frame = 1.0 / 60;
const Refinement usual{.tolerance = 0.01, .budget = 200'000};

std::vector<double> frames(double duration) {
  std::vector<double> times;
  for (std::size_t i = 0; i <= steps_in(duration, frame); ++i) times.push_back(static_cast<double>(i) * frame);
  return times;
}

Scene scene_of(const char* name, const Parameters& changes) {
  const Scenario& scenario = *Catalog<Scenario>::find(name);
  return scenario.scene(complete(scenario, changes));
}

bool without_chipmunk() { return Catalog<Engine>::find("chipmunk") == nullptr; }

TEST(ConfirmedTruth, ReachesTheEndWhereBothEnginesConverge) {
  if (without_chipmunk()) GTEST_SKIP() << "built without Chipmunk";
  const ConvergedTruth truth = confirmed_truth(scene_of("double-pendulum", {{"angle", 5}}), frames(2), usual);
  EXPECT_EQ(truth.answer->reason(), "");
  EXPECT_EQ(truth.confirmed_by, "chipmunk");
}

TEST(ConfirmedTruth, SaysWhenAndWhyItEnds) {
  if (without_chipmunk()) GTEST_SKIP() << "built without Chipmunk";
  const ConvergedTruth truth = confirmed_truth(scene_of("double-pendulum", {}), frames(5), usual);
  EXPECT_GT(truth.answer->valid_until(), 0.5);
  EXPECT_LT(truth.answer->valid_until(), 4);
  EXPECT_THAT(truth.answer->reason(), HasSubstr("t = "));
}

TEST(ConfirmedTruth, TakesTheExactSolverWhereNoOtherEngineHasTheFrictionOfTheScene) {
  const ConvergedTruth truth = confirmed_truth(scene_of("breakaway", {}), frames(0.5), usual);
  EXPECT_EQ(truth.confirmed_by, "impulse:solver=exact");
}

TEST(ConfirmedTruth, IsNoneWithoutASecondEngine) {
  Scene scene = scene_of("double-pendulum", {});
  for (Body& body : scene.bodies) {
    for (Shape& shape : body.shapes) {
      shape.surface.static_friction = 0.9;
      shape.surface.dynamic_friction = 0.1;
    }
  }
  const ConvergedTruth truth = confirmed_truth(scene, frames(0.5), usual);
  EXPECT_EQ(truth.confirmed_by, "");
  EXPECT_THAT(truth.engine.unsupported(scene, {}), StartsWith("no second engine"));
}

TEST(Converged, IsContradictedByAnAnswerToAnotherScene) {
  const Scene scene = scene_of("double-pendulum", {});
  Scene heavier = scene;
  heavier.gravity.y *= 1.05;
  Converged answer(scene, frames(0.5), usual);
  EXPECT_FALSE(answer.contradicted_by(Converged(scene, frames(0.5), usual), 30));
  EXPECT_FALSE(answer.contradicted_by(Converged(heavier, frames(0.5), usual), 0));
  EXPECT_TRUE(answer.contradicted_by(Converged(heavier, frames(0.5), usual), 30));
}

TEST(Converged, CountsWhatItDiffersFromAnotherAnswerByAsAnError) {
  const Scene scene = scene_of("double-pendulum", {});
  Scene heavier = scene;
  heavier.gravity.y *= 1.0001;
  Converged answer(scene, frames(0.5), usual);
  const double before = answer.errors(30)[2].position;
  EXPECT_FALSE(answer.contradicted_by(Converged(heavier, frames(0.5), usual), 30));
  EXPECT_GT(answer.errors(30)[2].position, 2 * before);
}

}  // namespace
}  // namespace plumb::confirmed_test
