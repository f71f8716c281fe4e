#include "reports/timing/machine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(TimingMachine, IsTheSameAsItself) {
  const TimingFacts facts = timing_facts();
  EXPECT_EQ(other_machine(facts, timing_facts()), "");
  EXPECT_TRUE(built_otherwise(facts, facts).empty());
  for (const char* const key : {"processor", "processors", "governor", "load", "compiler", "flags", "machine"}) {
    EXPECT_FALSE(facts.at(key).empty()) << key;
  }
}

TEST(TimingMachine, AnotherProcessorIsAnotherMachine) {
  TimingFacts there = timing_facts();
  there["processor"] = "80486";
  EXPECT_THAT(other_machine(there, timing_facts()), testing::HasSubstr("processor \"80486\" there"));
}

TEST(TimingMachine, SoIsOneOfTheSameKindAndOneThatDoesNotSay) {
  TimingFacts there = timing_facts();
  there["machine"] = "another";
  EXPECT_NE(other_machine(there, timing_facts()), "");
  EXPECT_NE(other_machine({}, timing_facts()), "");
}

TEST(TimingMachine, LoadAndCompilerMakeNoOtherMachine) {
  TimingFacts there = timing_facts();
  there["load"] = "17";
  there["flags"] = "-O0";
  EXPECT_EQ(other_machine(there, timing_facts()), "");
  EXPECT_THAT(built_otherwise(there, timing_facts()), testing::ElementsAre(testing::StartsWith("flags: -O0, now ")));
}

TEST(TimingMachine, IsBusyWithMoreAtWorkThanProcessors) {
  EXPECT_TRUE(busy({{"load", "2.5"}, {"processors", "2"}}));
  EXPECT_FALSE(busy({{"load", "1.5"}, {"processors", "2"}}));
}

}  // namespace
}  // namespace plumb
