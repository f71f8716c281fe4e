#include "reports/gate/result.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "sample.h"

namespace plumb::compare_test {
namespace {

using fakes::baseline;
using fakes::check_of;
using fakes::elsewhere;
using fakes::metric_of;
using fakes::run_key;
using fakes::run_of;
using ::testing::HasSubstr;

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Compare, PassesIfEveryBitIsTheSame) {
  const GateResult result = compare(baseline(), baseline());
  EXPECT_TRUE(result.passed());
  EXPECT_EQ(result.verdict, "as accepted: 1 run, to the bit");
  EXPECT_TRUE(result.notes.empty());
  EXPECT_EQ(caught_by(result, run_key()), std::nullopt);
}

TEST(Compare, FindsEveryBitThatDiffersOnTheSamePlatform) {
  Baseline now = baseline();
  metric_of(now).value = std::nextafter(1.0, 2.0);
  EXPECT_EQ(caught_by(compare(baseline(), now), run_key()), Rule::bits);
  EXPECT_TRUE(compare(baseline(), elsewhere(now)).passed());

  now = baseline();
  run_of(now).bits = "00000000000000ab";
  const GateResult result = compare(baseline(), now);
  ASSERT_EQ(result.regressions.size(), 1u);
  EXPECT_EQ(result.regressions[0].metric, "bits");
  EXPECT_THAT(result.regressions[0].why, HasSubstr("no number differs"));
  EXPECT_TRUE(compare(baseline(), elsewhere(now)).passed());
}

TEST(Compare, AllowsNumbersToDifferByTheirBoundOnAnotherPlatform) {
  Baseline now = elsewhere(baseline());
  metric_of(now).value = 1.5;
  EXPECT_TRUE(compare(baseline(), now).passed());
  metric_of(now).value = std::nextafter(1.5, 2.0);
  const GateResult result = compare(baseline(), now);
  ASSERT_EQ(result.regressions.size(), 1u);
  EXPECT_EQ(result.regressions[0].rule, Rule::bound);
  EXPECT_EQ(result.regressions[0].change, Change::worse) << "less penetration is better";
  EXPECT_EQ(result.regressions[0].tolerance, "+/- 0.5");
  metric_of(now).value = 0.25;
  EXPECT_EQ(compare(baseline(), now).regressions.at(0).change, Change::better);
}

TEST(Compare, UsesBoundsOnTheSamePlatformToo) {
  Baseline now = baseline();
  metric_of(now).value = 3;
  const GateResult result = compare(baseline(), now);
  ASSERT_EQ(result.regressions.size(), 2u);
  EXPECT_EQ(result.regressions[0].times, 4);
  EXPECT_EQ(result.regressions[1].rule, Rule::bits);
  EXPECT_EQ(caught_by(result, run_key()), Rule::bound);
}

TEST(Compare, FindsWorseVerdictsOnAnyPlatform) {
  for (const Verdict worse : {Verdict::plausible, Verdict::not_supported, Verdict::wrong, Verdict::failed}) {
    Baseline now = elsewhere(baseline());
    run_of(now).verdict = worse;
    const GateResult result = compare(baseline(), now);
    ASSERT_EQ(result.regressions.size(), 1u) << name_of(worse);
    EXPECT_EQ(result.regressions[0].change, Change::worse) << name_of(worse);
    EXPECT_EQ(result.regressions[0].before, "right");
    EXPECT_EQ(result.regressions[0].now, name_of(worse));
    EXPECT_EQ(caught_by(result, run_key()), Rule::verdict);
  }
}

// A run that is no longer possible, and an answer that is no longer close or no longer evidence, are regressions even
// where no number that remains differs.
TEST(Compare, FailsWhatTurnsWorseWithoutTurningWrong) {
  using enum Verdict;
  const std::pair<Verdict, Verdict> turns[] = {{right, coarse},
                                               {right, plausible},
                                               {right, no_evidence},
                                               {right, not_supported},
                                               {coarse, no_evidence},
                                               {coarse, not_supported},
                                               {plausible, not_supported},
                                               {plausible, no_evidence},
                                               {no_evidence, not_supported}};
  for (const auto& [was, is] : turns) {
    Baseline before = baseline();
    run_of(before).verdict = was;
    run_of(before).perturbed_verdicts = {was};
    Baseline now = before;
    run_of(now).verdict = is;
    if (is == not_supported) run_of(now) = {.verdict = is, .reason = "no chains"};
    for (const Baseline& here : {now, elsewhere(now)}) {
      const GateResult result = compare(before, here);
      ASSERT_FALSE(result.passed()) << name_of(was) << " -> " << name_of(is);
      EXPECT_EQ(result.regressions.front().metric, "verdict");
      EXPECT_EQ(result.regressions.front().change, Change::worse) << name_of(was) << " -> " << name_of(is);
    }
  }
}

TEST(Compare, WantsABetterVerdictToBeAccepted) {
  Baseline before = baseline();
  run_of(before).verdict = Verdict::wrong;
  run_of(before).perturbed_verdicts = {Verdict::wrong};
  const GateResult result = compare(before, elsewhere(baseline()));
  ASSERT_EQ(result.regressions.size(), 1u);
  EXPECT_EQ(result.regressions[0].change, Change::better);
  EXPECT_FALSE(result.passed());
}

TEST(Compare, AllowsVerdictsOfPerturbedRunsOnAnotherPlatformOnly) {
  Baseline before = baseline();
  run_of(before).perturbed_verdicts = {Verdict::right, Verdict::wrong};
  Baseline now = before;
  run_of(now).verdict = Verdict::wrong;
  EXPECT_TRUE(compare(before, elsewhere(now)).passed());
  EXPECT_EQ(caught_by(compare(before, now), run_key()), Rule::verdict);
}

TEST(Compare, FindsAChangedStatusOfAStableCheck) {
  Baseline now = elsewhere(baseline());
  check_of(now).status = CheckStatus::broken;
  const GateResult result = compare(baseline(), now);
  ASSERT_EQ(result.regressions.size(), 1u);
  EXPECT_EQ(result.regressions[0].before, "held (0.25 m)");
  EXPECT_EQ(result.regressions[0].change, Change::worse);
  Baseline unstable = baseline();
  check_of(unstable).unstable = true;
  EXPECT_TRUE(compare(unstable, now).passed());
}

TEST(Compare, FindsAWiderTolerance) {
  Baseline now = baseline();
  check_of(now).tolerance = 1;
  const GateResult result = compare(baseline(), now);
  ASSERT_EQ(result.regressions.size(), 1u);
  EXPECT_THAT(result.regressions[0].why, HasSubstr("allowed 0.5, now 1"));
}

TEST(Compare, FindsNumbersThatAreNoLongerFinite) {
  for (const double lost : {infinity, std::numeric_limits<double>::quiet_NaN()}) {
    Baseline now = elsewhere(baseline());
    metric_of(now).value = lost;
    const GateResult result = compare(baseline(), now);
    ASSERT_EQ(result.regressions.size(), 1u);
    EXPECT_EQ(result.regressions[0].change, Change::worse);
    EXPECT_EQ(result.regressions[0].times, infinity);
  }
}

TEST(Compare, FindsMissingAndNewNumbersUnlessTheyAreUnbounded) {
  Baseline without = elsewhere(baseline());
  run_of(without).numbers.erase("penetration_max");
  EXPECT_EQ(compare(baseline(), without).regressions.at(0).change, Change::missing);
  EXPECT_EQ(compare(without, baseline()).regressions.at(0).change, Change::added);

  Baseline loose = baseline();
  metric_of(loose).bound = infinity;
  EXPECT_TRUE(compare(loose, without).passed());
  metric_of(loose).value = std::numeric_limits<double>::quiet_NaN();  // only perturbed runs have it
  EXPECT_TRUE(compare(loose, without).passed());
  without.platform = loose.platform;
  EXPECT_TRUE(compare(loose, without).passed());
}

TEST(Compare, FindsMissingAndNewRuns) {
  Baseline more = baseline();
  more.runs[run_key("other")] = run_of(more);
  const GateResult gone = compare(more, baseline());
  EXPECT_EQ(gone.regressions.at(0).change, Change::missing);
  EXPECT_EQ(gone.verdict, "NOT as accepted: 1 of 2 runs differ (1 missing)");
  const GateResult came = compare(baseline(), more);
  EXPECT_EQ(came.regressions.at(0).change, Change::added);
  EXPECT_EQ(came.runs.size(), 2u);
  EXPECT_EQ(caught_by(came, run_key("other")), Rule::presence);
}

TEST(Compare, DoesNotJudgeNumbersWithoutABound) {
  Baseline before = baseline();
  metric_of(before).bound.reset();
  Baseline now = before;
  metric_of(now).value = 2;
  const GateResult result = compare(before, elsewhere(now));
  EXPECT_TRUE(result.passed());
  EXPECT_THAT(result.notes.back(), HasSubstr("1 number from another platform"));
  EXPECT_FALSE(compare(before, now).passed());
}

TEST(Compare, TreatsAnotherVersionOfAnEngineAsAnotherPlatform) {
  Baseline now = baseline();
  run_of(now).bits = "00000000000000ab";
  now.engines["impulse"] = "there";
  const GateResult result = compare(baseline(), now);
  EXPECT_TRUE(result.passed());
  EXPECT_THAT(result.notes.at(0), HasSubstr("impulse: there, was here"));
}

TEST(Compare, ReportsOnlyTheVerdictAndTheBitsOfAFailedRun) {
  Baseline now = baseline();
  run_of(now) = {.verdict = Verdict::failed, .reason = "diverged at t = 1 s", .bits = "00000000000000ab"};
  const GateResult result = compare(baseline(), now);
  ASSERT_EQ(result.regressions.size(), 2u) << "the verdict and the bits, not every number that is missing";
  EXPECT_EQ(result.regressions[0].why, "diverged at t = 1 s");
}

TEST(Compare, RefusesDifferentTimeSteps) {
  Baseline now = baseline();
  now.dt /= 2;
  EXPECT_THROW(compare(baseline(), now), std::invalid_argument);
}

TEST(Compare, PutsTheWorstFirst) {
  Baseline before = baseline();
  for (const char* engine : {"a", "b", "c"}) before.runs[run_key(engine)] = run_of(before);
  before.engines = {};
  Baseline now = elsewhere(before);
  now.runs[run_key("a")].numbers["penetration_max"].value = 2;
  now.runs[run_key("b")].numbers["penetration_max"].value = 4;
  now.runs[run_key("c")].verdict = Verdict::wrong;
  const GateResult result = compare(before, now);
  ASSERT_EQ(result.regressions.size(), 3u);
  EXPECT_EQ(result.regressions[0].run.engine, "c");
  EXPECT_EQ(result.regressions[1].run.engine, "b");
  EXPECT_EQ(result.regressions[2].run.engine, "a");
}

}  // namespace
}  // namespace plumb::compare_test
