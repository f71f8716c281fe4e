#include "reports/run/beyond.h"

#include <gmock/gmock.h>

#include "reports/run/experiment.h"
#include "reports/run/selection.h"

namespace plumb {
namespace {

using ::testing::StartsWith;

Report report_of(const char* word, std::vector<const char*> engines) {
  Plan plan{.cases = {parse_cases(word).front()}, .ensemble = 8};
  for (const char* engine : engines) plan.configs.push_back(parse_engine(engine));
  return carry_out(plan, [](const std::string&, std::size_t, std::size_t) {});
}

TEST(Beyond, EnginesThatDifferInAChaoticSceneAreDifferentButPlausible) {
  if (Catalog<Engine>::find("chipmunk") == nullptr) GTEST_SKIP() << "built without Chipmunk";
  const Report report = report_of("rain:seed 1", {"impulse:solver=soft-step", "chipmunk"});
  EXPECT_EQ(report.runs[0].metrics.count("horizon"), 1u);
  ASSERT_EQ(report.comparisons.size(), 1u);
  const Comparison& one = report.comparisons.front();
  EXPECT_EQ(one.verdict, Verdict::plausible);
  EXPECT_THAT(one.reason, StartsWith("different: energy"));
  EXPECT_EQ(one.metrics.count("horizon"), 1u);
  EXPECT_LT(one.metrics.at("ensemble_energy_p").value, 0.01);
}

TEST(Beyond, TheSameEngineByAnotherNameIsAlike) {
  const Report report = report_of("rain:seed 1", {"impulse:solver=soft-step", "impulse:solver=soft-step,workers=2"});
  EXPECT_EQ(report.comparisons.front().verdict, Verdict::beyond_horizon);
  EXPECT_THAT(report.comparisons.front().reason, StartsWith("plausible beyond the horizon at "));
}

TEST(Beyond, WhatCanBeToldToItsEndIsComparedPointByPoint) {
  const Report report = report_of("bounce:e=0.8", {"impulse", "impulse:solver=soft-step"});
  EXPECT_EQ(report.runs[1].metrics.count("horizon"), 0u);
  for (const Comparison& one : report.comparisons) {
    EXPECT_NE(one.verdict, Verdict::beyond_horizon);
    EXPECT_EQ(one.metrics.count("ensemble_energy_p"), 0u);
  }
}

}  // namespace
}  // namespace plumb
