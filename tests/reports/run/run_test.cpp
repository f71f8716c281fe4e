#include "reports/run/run.h"

#include <gmock/gmock.h>

#include "../fakes.h"

namespace plumb::run_test {
namespace {

using fakes::Stepper;
using ::testing::StartsWith;

Outcome run_with(const Engine& engine, double dt = 1.0 / 60) {
  static const Scene scene = fakes::thrown_box();
  return run(scene, {&engine, {}}, dt);
}

TEST(Run, RecordsTheStartAndEveryStep) {
  const Outcome outcome = run_with(fakes::engine("ours"));
  EXPECT_EQ(outcome.status, Status::ok);
  EXPECT_EQ(outcome.trace->size(), 121u);
  EXPECT_EQ(outcome.trace->time(0), 0);
  EXPECT_DOUBLE_EQ(outcome.trace->times().back(), 2);
  EXPECT_EQ(outcome.trace->states(0)[0].position, (Vec{1, 2}));
}

TEST(Run, CoversADurationThatIsNotAMultipleOfTheStep) {
  EXPECT_EQ(steps_in(1, 0.3), 4u);
  EXPECT_EQ(steps_in(2, 1.0 / 60), 120u);
  EXPECT_EQ(steps_in(0.7, 0.1), 7u);
  EXPECT_EQ(steps_in(0, 0.1), 0u);
}

TEST(Run, EndsWhenAClosedFormIsNoLongerValid) {
  const Outcome outcome = run_with(fakes::free_flight(1.01), 0.1);
  EXPECT_EQ(outcome.status, Status::ok);
  EXPECT_DOUBLE_EQ(outcome.trace->times().back(), 1);
}

TEST(Run, ReportsWhenWhichBodyDiverged) {
  const Outcome nan = run_with(fakes::engine("bad", Stepper::Fault::nan), 0.25);
  EXPECT_EQ(nan.status, Status::failed);
  EXPECT_THAT(nan.reason, StartsWith("diverged at t = 1 s: body \"box\""));
  EXPECT_EQ(nan.trace->size(), 4u) << "the sane part is kept";

  const Outcome explosion = run_with(fakes::engine("bad", Stepper::Fault::explosion), 0.25);
  EXPECT_EQ(explosion.status, Status::failed);
  EXPECT_THAT(explosion.reason, StartsWith("diverged at t = 1 s: body \"box\""));
}

TEST(Run, ReportsWhatAnEngineThrows) {
  const Outcome outcome = run_with(fakes::engine("bad", Stepper::Fault::exception));
  EXPECT_EQ(outcome.status, Status::failed);
  EXPECT_EQ(outcome.reason, "the engine gave up");
}

TEST(Run, ReportsWhyASceneIsNotSupported) {
  Engine engine = fakes::engine("picky");
  engine.unsupported = [](const Scene&, const Settings&) { return "boxes are not supported"; };
  const Outcome outcome = run_with(engine);
  EXPECT_EQ(outcome.status, Status::not_supported);
  EXPECT_EQ(outcome.reason, "boxes are not supported");
  EXPECT_EQ(outcome.trace, nullptr);
}

TEST(Run, ReportsWhyASceneTurnsOutToBeNotSupported) {
  const Outcome outcome = run_with(fakes::engine("small", Stepper::Fault::beyond));
  EXPECT_EQ(outcome.status, Status::not_supported);
  EXPECT_EQ(outcome.reason, "too much for it");
  EXPECT_EQ(outcome.trace, nullptr);
}

TEST(Watch, ShowsTheStartAndEveryStepUntilTheObserverStopsIt) {
  const Scene scene = fakes::thrown_box();
  const Engine ours = fakes::engine("ours");
  std::vector<double> heights;
  const auto observer = [&](double time, std::span<const BodyState> states) {
    heights.push_back(states[0].position.y);
    return time < 0.45;
  };
  const Outcome outcome = watch(scene, {&ours, {}}, 0.1, 1, observer);
  EXPECT_EQ(outcome.status, Status::ok);
  EXPECT_DOUBLE_EQ(outcome.time, 0.5);
  EXPECT_EQ(outcome.trace, nullptr);
  const Trace record = *run(scene, {&ours, {}}, 0.1).trace;
  ASSERT_EQ(heights.size(), 6u);
  for (std::size_t i = 0; i < heights.size(); ++i) EXPECT_EQ(heights[i], record.states(i)[0].position.y);
}

TEST(Watch, ReportsWhichBodyDivergedAndWhen) {
  const Scene scene = fakes::thrown_box();
  const Engine bad = fakes::engine("bad", Stepper::Fault::nan);
  const Outcome outcome = watch(scene, {&bad, {}}, 0.25, 1, [](double, std::span<const BodyState>) { return true; });
  EXPECT_EQ(outcome.status, Status::failed);
  EXPECT_EQ(outcome.lost, std::optional<std::size_t>(0));
  EXPECT_DOUBLE_EQ(outcome.time, 1);
}

TEST(Run, SpendsLessTimeInStepsThanInAll) {
  const Outcome outcome = run_with(fakes::engine("ours"));
  EXPECT_GT(outcome.stepping, 0);
  EXPECT_LT(outcome.stepping, outcome.wall);
}

TEST(EngineConfig, IsNamedByWhatDiffersFromTheDefaults) {
  Engine engine = fakes::engine("ours");
  engine.options = {{.key = "solver", .value = "a"}, {.key = "steps", .value = "4"}};
  EXPECT_EQ((EngineConfig{&engine, {{"solver", "a"}, {"steps", "4"}}}.method()), "");
  EXPECT_EQ((EngineConfig{&engine, {{"solver", "b"}, {"steps", "8"}}}.method()), "solver=b,steps=8");
}

}  // namespace
}  // namespace plumb::run_test
