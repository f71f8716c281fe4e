#include "reports/study/stability/watches.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reports/judge/mechanics.h"
#include "scenarios/parts.h"

namespace plumb {
namespace {

// Two boxes of 1 m upon each other, at rest.
class Watches : public ::testing::Test {
 protected:
  static SharedScene tower() {
    Scene scene{.name = "tower", .gravity = {0, -10}, .duration = 2};
    scene.bodies.push_back(level_ground(surface(0.5, 0)));
    for (const double y : {0.5, 1.5}) scene.bodies.push_back(box("box", {0, y}, {1, 1}, surface(0.5, 0)));
    return std::make_shared<const Scene>(std::move(scene));
  }

  std::optional<Symptom> look(Watch& watch, double time = 1, bool last = false) {
    return watch.look({time, states_, last});
  }

  SharedScene scene_ = tower();
  std::vector<BodyState> states_ = initial_states(*scene_);
};

TEST_F(Watches, SeeNothingInWhatStandsStill) {
  for (Watch& watch : status(scene_, 1, 0)) {
    for (int i = 0; i <= 120; ++i) EXPECT_FALSE(look(watch, i / 60.0, i == 120)) << watch.metric;
  }
}

TEST_F(Watches, SeeABodyThatTurnsOrComesDown) {
  Watch watch = topples(scene_, 0.2, 0.5);
  states_[2].angle = -0.19;
  EXPECT_FALSE(look(watch));
  states_[2].angle = -0.21;
  EXPECT_EQ(look(watch)->fate, Fate::topples);
  EXPECT_EQ(look(watch)->body, 2u);
  states_[2].angle = 0;
  states_[1].position.y -= 0.51;
  EXPECT_EQ(look(watch)->body, 1u);
}

TEST_F(Watches, SeeABodyThatLeavesItsPlaceSideways) {
  Watch watch = drifts(scene_, 0.5);
  states_[1].position.y += 3;
  EXPECT_FALSE(look(watch)) << "that is another's business";
  states_[1].position.x -= 0.51;
  EXPECT_EQ(look(watch)->fate, Fate::drifts);
}

TEST_F(Watches, SeeOverlapBeyondTheStatedGap) {
  states_[2].position.y -= 0.15;
  Watch strict = sinks(scene_, 0.1, 0);
  const auto symptom = look(strict);
  ASSERT_TRUE(symptom);
  EXPECT_EQ(symptom->fate, Fate::sinks);
  EXPECT_EQ(symptom->body, 2u);
  Watch lenient = sinks(scene_, 0.1, 0.1);
  EXPECT_FALSE(look(lenient)) << "0.1 m of it are stated";
}

TEST_F(Watches, SeeEnergyThatCameFromNowhere) {
  Watch watch = gains_energy(scene_, 0.1);
  // The tower of 1 kg boxes can turn over 2 kg 10 m/s^2 2 m = 40 J.
  states_[2].velocity.x = std::sqrt(2 * 3.9);
  EXPECT_FALSE(look(watch));
  states_[2].velocity.x = std::sqrt(2 * 4.1);
  EXPECT_EQ(look(watch)->fate, Fate::gains_energy);
  EXPECT_FALSE(look(watch)->body) << "it is the scene's";
}

TEST_F(Watches, TellTremblingFromMovingAway) {
  const auto end_of = [&](auto x) {
    Watch watch = is_restless(scene_, 0.02);
    std::optional<Symptom> last;
    for (int i = 60; i <= 120; ++i) {
      states_[1].position.x = x(i);
      last = look(watch, i / 60.0, i == 120);
    }
    return last;
  };
  EXPECT_EQ(end_of([](int i) { return i % 2 * 0.001; })->fate, Fate::jitters) << "60 mm to and fro";
  EXPECT_EQ(end_of([](int i) { return i * 0.001; })->fate, Fate::drifts);
  EXPECT_FALSE(end_of([](int i) { return i % 2 * 0.0003; })) << "18 mm";
}

TEST_F(Watches, SeeWhatHoldsTwoBodiesGiveWay) {
  Watch watch = gives_way(scene_, 1, 2, 1.1);
  EXPECT_FALSE(look(watch));
  states_[2].position.y += 0.2;
  EXPECT_EQ(look(watch)->fate, Fate::sinks);
}

}  // namespace
}  // namespace plumb
