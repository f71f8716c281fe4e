#include "race.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "reports/judge/mechanics.h"
#include "scenarios/parts.h"

namespace plumb::benchmarks {
namespace {

using testing::ElementsAre;

// Who stepped, each time that it was another than before, and how often.
struct Log {
  std::string turns;
  int steps = 0;
};

class Stepper : public Simulation {
 public:
  Stepper(const Scene& scene, char name, Log& log, int breaks_at)
      : scene_(scene), name_(name), log_(log), breaks_at_(breaks_at) {}
  void step(double) override {
    if (++made_ == breaks_at_) throw std::domain_error("too much for it");
    ++log_.steps;
    if (log_.turns.empty() || log_.turns.back() != name_) log_.turns += name_;
  }
  void read(std::span<BodyState> out) const override {
    const std::vector<BodyState> start = initial_states(scene_);
    std::copy(start.begin(), start.end(), out.begin());
    if (name_ == 'x') out[0].position.y = std::numeric_limits<double>::infinity();
  }

 private:
  const Scene& scene_;
  char name_;
  Log& log_;
  int breaks_at_, made_ = 0;
};

Engine stepper(char name, Log& log, int breaks_at = -1) {
  return {.name = std::string(1, name),
          .unsupported = [](const Scene& scene,
                            const Settings&) { return std::string(scene.joints.empty() ? "" : "knows no joints"); },
          .build = [=, &log](const Scene& scene,
                             const Settings&) { return std::make_unique<Stepper>(scene, name, log, breaks_at); }};
}

Start one_disc() {
  Start start{.size = 1};
  start.scene.bodies = {disc("disc", {0, 0}, 0.5, {})};
  return start;
}

TEST(Race, LetsAllTakeTurnsInAnOrderThatMovesOn) {
  Log log;
  const Engine a = stepper('a', log);
  const Engine b = stepper('b', log);
  const std::vector<Finish> finishes = race(one_disc(), {5, 25}, std::vector<EngineConfig>{{&a, {}}, {&b, {}}}, 2, 60);
  EXPECT_EQ(log.steps, 2 * 2 * 25);
  // Before the window one after the other; in it ab, ba, ab ...; the second round begins with b.
  EXPECT_EQ(log.turns.substr(0, 8), "abababab");
  EXPECT_EQ(finishes[0].laps.size(), 2U);
  EXPECT_EQ(finishes[1].laps.size(), 2U);
}

TEST(Race, MakesEveryStepOfAWindowThatTenDoesNotDivide) {
  Log log;
  const Engine a = stepper('a', log);
  race(one_disc(), {0, 7}, std::vector<EngineConfig>{{&a, {}}}, 1, 60);
  EXPECT_EQ(log.steps, 7);
}

TEST(Race, GivesNoTimeToWhoBreaksOffOrLosesTheScene) {
  Log log;
  const Engine sound = stepper('a', log);
  const Engine breaks = stepper('b', log, 3);
  const Engine loses = stepper('x', log);
  const std::vector<Finish> finishes =
      race(one_disc(), {0, 10}, std::vector<EngineConfig>{{&sound, {}}, {&breaks, {}}, {&loses, {}}}, 2, 60);
  EXPECT_EQ(finishes[0].no_result, "");
  EXPECT_EQ(finishes[1].no_result, "too much for it");
  EXPECT_EQ(finishes[2].no_result, "body 0 is nowhere");
  EXPECT_TRUE(finishes[1].laps.empty());
  EXPECT_TRUE(finishes[2].laps.empty());
}

TEST(Race, LosesPatience) {
  Log log;
  const Engine a = stepper('a', log);
  const std::vector<Finish> finishes = race(one_disc(), {9, 10}, std::vector<EngineConfig>{{&a, {}}}, 3, 1e-12);
  EXPECT_EQ(finishes[0].no_result, "takes more than 1e-12 s a round");
  EXPECT_EQ(log.steps, 1);
}

TEST(Race, SaysWhoCannotRunIt) {
  Log log;
  Start start = one_disc();
  start.scene.joints = {Revolute{}};
  const Engine a = stepper('a', log);
  EXPECT_EQ(race(start, {0, 10}, std::vector<EngineConfig>{{&a, {}}}, 1, 60)[0].no_result, "knows no joints");
  EXPECT_EQ(log.steps, 0);
}

}  // namespace
}  // namespace plumb::benchmarks
