#include "reports/run/run.h"

#include <gmock/gmock.h>

#include <functional>
#include <limits>
#include <utility>

#include "../fakes.h"

namespace plumb::run_test {
namespace {

using fakes::Stepper;
using ::testing::HasSubstr;
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

/// A simulation that reads as a test specifies.
struct CustomReader : Simulation {
  std::function<void(std::span<BodyState>)> reads = [](std::span<BodyState> out) {
    for (BodyState& state : out) state = {};
  };
  ContactState touching{.a = 0, .b = 1};
  void step(double) override {}
  void read(std::span<BodyState> out) const override { reads(out); }
  void read_contacts(std::vector<ContactState>& out) const override { out.push_back(touching); }
};

std::string error_of(const CustomReader& simulation) {
  Scene scene = fakes::thrown_box();
  scene.bodies.push_back({.name = "other"});
  Readout readout(scene);
  try {
    readout.states(simulation);
    readout.contacts(simulation);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Readout, AcceptsCorrectReads) { EXPECT_EQ(error_of({}), ""); }

TEST(Readout, NamesABodyThatWasLeftOut) {
  CustomReader simulation;
  simulation.reads = [](std::span<BodyState> out) { out[0] = {}; };
  EXPECT_THAT(error_of(simulation), HasSubstr("read() left out body \"other\""));
  simulation.reads = [](std::span<BodyState> out) {
    for (BodyState& state : out) state.position = {1, 2};
  };
  EXPECT_THAT(error_of(simulation), HasSubstr("read() left out body \"box\""));
}

TEST(Readout, NoticesAWritePastTheEnd) {
  CustomReader simulation;
  simulation.reads = [](std::span<BodyState> out) {
    for (std::size_t i = 0; i < 3; ++i) out.data()[i] = {};
  };
  EXPECT_THAT(error_of(simulation), HasSubstr("past the end: the scene has 2 bodies"));
}

TEST(Readout, AcceptsNaNWhichTheRunReports) {
  CustomReader simulation;
  simulation.reads = [](std::span<BodyState> out) {
    for (BodyState& state : out) state = {.angle = std::numeric_limits<double>::quiet_NaN()};
  };
  EXPECT_EQ(error_of(simulation), "");
}

TEST(Readout, RefusesImpossibleContacts) {
  CustomReader simulation;
  simulation.touching = {.a = 0, .b = 2};
  EXPECT_THAT(error_of(simulation), HasSubstr("between bodies 0 and 2 of a scene of 2"));
  simulation.touching = {.a = 1, .b = 1};
  EXPECT_THAT(error_of(simulation), HasSubstr("between bodies 1 and 1"));
  simulation.touching = {.a = 0, .b = 1, .normal_impulse = std::numeric_limits<double>::infinity()};
  EXPECT_THAT(error_of(simulation), HasSubstr("not finite"));
}

}  // namespace
}  // namespace plumb::run_test
