#include "window_times.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "reports/judge/mechanics.h"
#include "scenarios/parts.h"

namespace plumb::benchmarks::window_times_test {
namespace {

using testing::ElementsAre;

// The order in which engines stepped, without repeats, and the number of steps.
struct StepLog {
  std::string order;
  int steps = 0;
};

class Stepper : public Simulation {
 public:
  Stepper(const Scene& scene, char name, StepLog& log, int breaks_at)
      : scene_(scene), name_(name), log_(log), breaks_at_(breaks_at) {}
  void step(double) override {
    if (++made_ == breaks_at_) throw std::domain_error("too hard for it");
    ++log_.steps;
    if (log_.order.empty() || log_.order.back() != name_) log_.order += name_;
  }
  void read(std::span<BodyState> out) const override {
    const std::vector<BodyState> initial = initial_states(scene_);
    std::copy(initial.begin(), initial.end(), out.begin());
    if (name_ == 'x') out[0].position.y = std::numeric_limits<double>::infinity();
  }

 private:
  const Scene& scene_;
  char name_;
  StepLog& log_;
  int breaks_at_, made_ = 0;
};

Engine stepper(char name, StepLog& log, int breaks_at = -1) {
  return {.name = std::string(1, name),
          .unsupported = [](const Scene& scene,
                            const Settings&) { return std::string(scene.joints.empty() ? "" : "has no joints"); },
          .build = [=, &log](const Scene& scene,
                             const Settings&) { return std::make_unique<Stepper>(scene, name, log, breaks_at); }};
}

SceneSetup one_disc() {
  SceneSetup setup{.size = 1};
  setup.scene.bodies = {disc("disc", {0, 0}, 0.5, {})};
  return setup;
}

TEST(TimeWindow, AlternatesAndLetsAnotherEngineBeginEachSlice) {
  StepLog log;
  const Engine a = stepper('a', log);
  const Engine b = stepper('b', log);
  const std::vector<EngineTimes> times =
      time_window(one_disc(), {5, 25}, std::vector<EngineConfig>{{&a, {}}, {&b, {}}}, 2, 60);
  EXPECT_EQ(log.steps, 2 * 2 * 25);
  // First a and b make the steps before the window. In the window the order is ab, ba, ab ...
  EXPECT_EQ(log.order.substr(0, 8), "abababab");
  EXPECT_EQ(times[0].rounds.size(), 2U);
  EXPECT_EQ(times[1].rounds.size(), 2U);
}

TEST(TimeWindow, MakesEveryStepOfAWindowThatTenDoesNotDivide) {
  StepLog log;
  const Engine a = stepper('a', log);
  time_window(one_disc(), {0, 7}, std::vector<EngineConfig>{{&a, {}}}, 1, 60);
  EXPECT_EQ(log.steps, 7);
}

TEST(TimeWindow, HasNoResultForAnEngineThatThrowsOrLetsTheSceneCollapse) {
  StepLog log;
  const Engine sound = stepper('a', log);
  const Engine breaks = stepper('b', log, 3);
  const Engine loses = stepper('x', log);
  const std::vector<EngineTimes> times =
      time_window(one_disc(), {0, 10}, std::vector<EngineConfig>{{&sound, {}}, {&breaks, {}}, {&loses, {}}}, 2, 60);
  EXPECT_EQ(times[0].no_result, "");
  EXPECT_EQ(times[1].no_result, "too hard for it");
  EXPECT_EQ(times[2].no_result, "the state of body 0 is not finite");
  EXPECT_TRUE(times[1].rounds.empty());
  EXPECT_TRUE(times[2].rounds.empty());
}

TEST(TimeWindow, LosesPatience) {
  StepLog log;
  const Engine a = stepper('a', log);
  const std::vector<EngineTimes> times =
      time_window(one_disc(), {9, 10}, std::vector<EngineConfig>{{&a, {}}}, 3, 1e-12);
  EXPECT_EQ(times[0].no_result, "takes more than 1e-12 s a round");
  EXPECT_EQ(log.steps, 1);
}

TEST(TimeWindow, SaysWhyAnEngineCannotRunTheScene) {
  StepLog log;
  SceneSetup setup = one_disc();
  setup.scene.joints = {Revolute{}};
  const Engine a = stepper('a', log);
  EXPECT_EQ(time_window(setup, {0, 10}, std::vector<EngineConfig>{{&a, {}}}, 1, 60)[0].no_result, "has no joints");
  EXPECT_EQ(log.steps, 0);
}

}  // namespace
}  // namespace plumb::benchmarks::window_times_test
