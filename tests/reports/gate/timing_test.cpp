#include "reports/gate/timing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace plumb::timing_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

JudgedTime judged(const std::string& name, double ratio, TimeChange change) {
  JudgedTime one{.change = change, .time = {ratio, 0.001, 1}};
  one.pair = {.name = name, .steps = 10, .of = 10};
  one.pair.before.cpu = {1e-4, 1e-4};
  one.pair.now.cpu = {1e-4 * ratio, 1e-4 * ratio};
  return one;
}

GateResult accepted() { return {.verdict = "as accepted", .runs = {{"bounce", "e=1", "impulse", ""}}}; }

TEST(TimingRegressions, NameTheSlowerCasesAndByHowMuch) {
  GateResult result = accepted();
  add_times(result, {.cases = {judged("heap", 1.05, TimeChange::slower), judged("fall", 1.01, TimeChange::same)}},
            "impulse");
  EXPECT_FALSE(result.passed());
  EXPECT_EQ(result.verdict, "as accepted; steps take LONGER in 1 of 2 cases");
  EXPECT_THAT(result.runs, SizeIs(3));
  ASSERT_THAT(result.regressions, SizeIs(1));
  const Regression& slow = result.regressions[0];
  EXPECT_EQ(slow.run, (RunKey{"time", "heap", "impulse", ""}));
  EXPECT_EQ(slow.before, "100 us a step");
  EXPECT_EQ(slow.now, "105 us a step");
  EXPECT_EQ(slow.rule, Rule::time);
  EXPECT_EQ(slow.change, Change::worse);
  EXPECT_NEAR(slow.times, 2, 1e-9);
  EXPECT_THAT(slow.why, HasSubstr("+5.0 %"));
}

TEST(TimingRegressions, AreNoneIfNothingIsSlower) {
  GateResult result = accepted();
  add_times(result, {.cases = {judged("heap", 0.9, TimeChange::faster)}}, "impulse");
  EXPECT_TRUE(result.passed());
  EXPECT_EQ(result.verdict, "as accepted; no step takes longer");
  EXPECT_THAT(result.notes, IsEmpty());
}

TEST(TimingRegressions, NoteTheCasesWithoutTimes) {
  GateResult result = accepted();
  JudgedTime lost{.change = TimeChange::no_result};
  lost.pair = {.name = "lost", .no_result = "refused"};
  add_times(result, {.cases = {lost}}, "impulse");
  EXPECT_TRUE(result.passed());
  EXPECT_THAT(result.notes, ElementsAre("lost was not timed: refused"));
}

}  // namespace
}  // namespace plumb::timing_test
