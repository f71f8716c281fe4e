#include "reports/system/environment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace plumb::environment_test {
namespace {

TEST(TimingMachine, IsTheSameAsItself) {
  const TimingFacts facts = timing_facts();
  EXPECT_EQ(machine_difference(facts, timing_facts()), "");
  EXPECT_TRUE(build_differences(facts, facts).empty());
  for (const char* const key : {"processor", "processors", "governor", "load", "compiler", "flags", "machine"}) {
    EXPECT_FALSE(facts.at(key).empty()) << key;
  }
}

TEST(TimingMachine, DiffersWithAnotherProcessor) {
  TimingFacts there = timing_facts();
  there["processor"] = "80486";
  EXPECT_THAT(machine_difference(there, timing_facts()), testing::HasSubstr("processor \"80486\" there"));
}

TEST(TimingMachine, DiffersWithAnotherIdentityOrNone) {
  TimingFacts there = timing_facts();
  there["machine"] = "another";
  EXPECT_NE(machine_difference(there, timing_facts()), "");
  EXPECT_NE(machine_difference({}, timing_facts()), "");
}

TEST(TimingMachine, IsTheSameDespiteOtherLoadAndFlags) {
  TimingFacts there = timing_facts();
  there["load"] = "17";
  there["flags"] = "-O0";
  EXPECT_EQ(machine_difference(there, timing_facts()), "");
  EXPECT_THAT(build_differences(there, timing_facts()), testing::ElementsAre(testing::StartsWith("flags: -O0, now ")));
}

TEST(TimingMachine, IsBusyIfTheLoadExceedsTheProcessors) {
  EXPECT_TRUE(busy({{"load", "2.5"}, {"processors", "2"}}));
  EXPECT_FALSE(busy({{"load", "1.5"}, {"processors", "2"}}));
}

}  // namespace
}  // namespace plumb::environment_test
