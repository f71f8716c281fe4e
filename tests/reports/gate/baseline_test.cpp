#include "reports/gate/baseline.h"

#include <gmock/gmock.h>

#include "../writers/sample.h"

namespace plumb::baseline_test {
namespace {

TEST(BaselineRunOf, HasEveryMetricAndCheck) {
  const Report report = sample_report();
  const BaselineRun run = baseline_run_of(report.runs[1]);
  EXPECT_EQ(run.verdict, Verdict::wrong);
  EXPECT_EQ(run.numbers.at("energy_rise").unit, "1");
  EXPECT_EQ(run.numbers.at("truth: x of box, \"the\" first at 2 s").status, CheckStatus::broken);
  EXPECT_EQ(run.numbers.at("invariant: cone").status, CheckStatus::not_reported);
  EXPECT_EQ(run.numbers.at("invariant: push").value, 0.5);
  EXPECT_EQ(run.numbers.size(), 5u);
}

TEST(BaselineRunOf, LeavesOutTheHorizonBecauseItNeedsAnEnsemble) {
  RunRecord run;
  run.metrics = {{"horizon", {0.9, "s"}}, {"energy_rise", {0.1, "1"}}};
  EXPECT_EQ(baseline_run_of(run).numbers.size(), 1u);
}

TEST(BaselineRunOf, NamesEventsWithoutTheirTime) {
  RunRecord run;
  for (const double time : {0.5, 0.75}) {
    run.truth.push_back({.body = "ball", .quantity = name_of(Quantity::apex), .time = time});
  }
  const BaselineRun all = baseline_run_of(run);
  EXPECT_EQ(all.numbers.count(std::string("truth: ") + name_of(Quantity::apex) + " of ball"), 1u);
  EXPECT_EQ(all.numbers.count(std::string("truth: ") + name_of(Quantity::apex) + " of ball (2)"), 1u);
}

TEST(BaselineOfAReport, HasEveryRunAndItsPlatform) {
  Report report = sample_report();
  report.environment = {{"compiler", "some"}, {"processor", "any"}};
  report.engines = {{.name = "lost", .source = "1.0"}, {.name = "sliding", .source = "a book", .exact = true}};
  const Baseline baseline = baseline_of(report);
  EXPECT_EQ(baseline.runs.size(), 3u);
  EXPECT_EQ(baseline.dt, 1.0 / 60);
  EXPECT_EQ(baseline.platform, (std::map<std::string, std::string>{{"compiler", "some"}}));
  EXPECT_EQ(baseline.engines, (std::map<std::string, std::string>{{"lost", "1.0"}}));
  const BaselineRun& failed = baseline.runs.at({"slide", "on ice", "lost", ""});
  EXPECT_EQ(failed.bits, "");
  EXPECT_THAT(failed.reason, ::testing::HasSubstr("diverged"));
}

}  // namespace
}  // namespace plumb::baseline_test
