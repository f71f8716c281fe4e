#include "reports/study/stability/detectors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reports/judge/mechanics.h"
#include "scenarios/parts.h"

namespace plumb::detectors_test {
namespace {

// Two boxes of 1 m stacked at rest.
class Detectors : public ::testing::Test {
 protected:
  static SharedScene tower() {
    Scene scene{.name = "tower", .gravity = {0, -10}, .duration = 2};
    scene.bodies.push_back(level_ground(surface(0.5, 0)));
    for (const double y : {0.5, 1.5}) scene.bodies.push_back(box("box", {0, y}, {1, 1}, surface(0.5, 0)));
    return std::make_shared<const Scene>(std::move(scene));
  }

  std::optional<DetectorFinding> check(Detector& detector, double time = 1, bool last = false) {
    return detector.check({time, states_, last});
  }

  SharedScene scene_ = tower();
  std::vector<BodyState> states_ = initial_states(*scene_);
};

TEST_F(Detectors, FindNothingInAStructureAtRest) {
  for (Detector& detector : structure_detectors(scene_, 1, 0)) {
    for (int i = 0; i <= 120; ++i) EXPECT_FALSE(check(detector, i / 60.0, i == 120)) << detector.criterion;
  }
}

TEST_F(Detectors, FindABodyThatTurnsOrDrops) {
  Detector detector = topple_detector(scene_, 0.2, 0.5);
  states_[2].angle = -0.19;
  EXPECT_FALSE(check(detector));
  states_[2].angle = -0.21;
  EXPECT_EQ(check(detector)->mode, FailureMode::topples);
  EXPECT_EQ(check(detector)->body, 2u);
  states_[2].angle = 0;
  states_[1].position.y -= 0.51;
  EXPECT_EQ(check(detector)->body, 1u);
}

TEST_F(Detectors, FindABodyThatMovesSideways) {
  Detector detector = drift_detector(scene_, 0.5);
  states_[1].position.y += 3;
  EXPECT_FALSE(check(detector)) << "height is not checked here";
  states_[1].position.x -= 0.51;
  EXPECT_EQ(check(detector)->mode, FailureMode::drifts);
}

TEST_F(Detectors, FindOverlapBeyondTheStatedGap) {
  states_[2].position.y -= 0.15;
  Detector strict = sink_detector(scene_, 0.1, 0);
  const auto finding = check(strict);
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->mode, FailureMode::sinks);
  EXPECT_EQ(finding->body, 2u);
  Detector lenient = sink_detector(scene_, 0.1, 0.1);
  EXPECT_FALSE(check(lenient)) << "the method states 0.1 m of it";
}

TEST_F(Detectors, FindEnergyThatTheSceneCannotHave) {
  Detector detector = energy_detector(scene_, 0.1);
  // The energy range of the tower of 1 kg boxes is 2 kg 10 m/s^2 2 m = 40 J.
  states_[2].velocity.x = std::sqrt(2 * 3.9);
  EXPECT_FALSE(check(detector));
  states_[2].velocity.x = std::sqrt(2 * 4.1);
  EXPECT_EQ(check(detector)->mode, FailureMode::gains_energy);
  EXPECT_FALSE(check(detector)->body) << "it belongs to the scene";
}

TEST_F(Detectors, DistinguishJitterFromDrift) {
  const auto end_of = [&](auto x) {
    Detector detector = restlessness_detector(scene_, 0.02);
    std::optional<DetectorFinding> last;
    for (int i = 60; i <= 120; ++i) {
      states_[1].position.x = x(i);
      last = check(detector, i / 60.0, i == 120);
    }
    return last;
  };
  EXPECT_EQ(end_of([](int i) { return i % 2 * 0.001; })->mode, FailureMode::jitters) << "60 mm back and forth";
  EXPECT_EQ(end_of([](int i) { return i * 0.001; })->mode, FailureMode::drifts);
  EXPECT_FALSE(end_of([](int i) { return i % 2 * 0.0003; })) << "18 mm";
}

TEST_F(Detectors, FindTwoJoinedBodiesThatSeparate) {
  Detector detector = separation_detector(scene_, 1, 2, 1.1);
  EXPECT_FALSE(check(detector));
  states_[2].position.y += 0.2;
  EXPECT_EQ(check(detector)->mode, FailureMode::sinks);
}

}  // namespace
}  // namespace plumb::detectors_test
