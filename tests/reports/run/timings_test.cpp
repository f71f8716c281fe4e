#include "reports/run/timings.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "../fakes.h"

namespace plumb::timings_test {
namespace {

using fakes::Stepper;

TEST(TimeConfigs, GivesEveryEngineAMedianBetweenItsQuartiles) {
  const Scenario scenario = fakes::throwing();
  const Engine one = fakes::engine("one");
  const Engine two = fakes::engine("two");
  const std::vector<EngineConfig> configs{{&one, {}}, {&two, {}}};
  const auto timings = time_configs(fakes::case_of(scenario, nullptr), configs, 1.0 / 60);
  ASSERT_EQ(timings.size(), 2u);
  EXPECT_EQ(timings[1].engine, "two");
  for (const Timing& timing : timings) {
    EXPECT_GT(timing.step_us_low, 0);
    EXPECT_LE(timing.step_us_low, timing.step_us);
    EXPECT_LE(timing.step_us, timing.step_us_high);
    EXPECT_GE(timing.repetitions, 5);
    EXPECT_LE(timing.repetitions, 9);
    EXPECT_GT(timing.real_time_factor, 1);
  }
}

TEST(TimeConfigs, NamesAnEngineThatRunsOnlyOnce) {
  const Scenario scenario = fakes::throwing();
  const Engine once = fakes::engine("once", Stepper::Fault::exception);
  const std::vector<EngineConfig> configs{{&once, {}}};
  try {
    time_configs(fakes::case_of(scenario, nullptr), configs, 1.0 / 60);
    FAIL() << "it gave up";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(
        error.what(),
        "once ran thrown, but failed when it ran again to be timed: the engine gave up. A new simulation must not "
        "depend on earlier ones");
  }
}

}  // namespace
}  // namespace plumb::timings_test
