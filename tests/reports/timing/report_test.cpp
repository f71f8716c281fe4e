#include "reports/timing/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace plumb::report_test {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

// Two cases: "heap" takes 5 % longer, "lost" was refused.
TimingReport small() {
  TimingReport report{.program_before = "old", .program_now = "new", .load_after = "3"};
  report.facts_before = {{"flags", "-O3"}, {"processor", "80486"}, {"processors", "2"}, {"load", "1"}};
  report.facts_now = {{"flags", "-O2"}, {"processor", "80486"}, {"processors", "2"}, {"load", "4"}};
  report.uncounted = "no counter";
  JudgedTime heap{.change = TimeChange::slower, .time = {1.05, 0.001, 1}, .measured_again = true};
  heap.pair = {.name = "heap", .steps = 50, .of = 100};
  heap.pair.before = {.cpu = {1e-4, 1e-4}, .wall = {2e-4, 2e-4}};
  heap.pair.now = {.cpu = {1.05e-4, 1.05e-4}, .wall = {2.1e-4, 2.1e-4}};
  JudgedTime lost{.change = TimeChange::no_result};
  lost.pair = {.name = "lost", .no_result = "refused"};
  report.cases = {heap, lost};
  return report;
}

TEST(TimingReport, BeginsWithTheVerdict) {
  EXPECT_THAT(timing_text(small()), StartsWith("Times: 1 of 2 cases take longer than before; 1 without a result.\n"));
  TimingReport calm = small();
  calm.cases[0].change = TimeChange::same;
  EXPECT_THAT(timing_text(calm), StartsWith("Times: no case takes longer than before by 2.5 % or more; 1 without"));
  EXPECT_THAT(timing_text(calm), Not(HasSubstr("heap")));
}

TEST(TimingReport, GivesTheSizeAndSignificanceOfEachChange) {
  const std::string text = timing_text(small());
  EXPECT_THAT(text, ContainsRegex("slower +heap +100 -> +105 us a step, .5.0 %"));
  EXPECT_THAT(text, HasSubstr("p = 0.001, effect 1.00, 2 rounds, first 50 of 100 steps"));
  EXPECT_THAT(text, ContainsRegex("no result +lost +refused"));
}

TEST(TimingReport, DescribesTheMachine) {
  const std::string text = timing_text(small());
  EXPECT_THAT(text, HasSubstr("80486, 2 processors, governor unknown, load 4 to 3: busy"));
  EXPECT_THAT(text, HasSubstr("Instructions are not counted: no counter"));
  EXPECT_THAT(text, HasSubstr("built differently: flags: -O3, now -O2"));
}

TEST(TimingReport, HasTheFormatOfGoogleBenchmark) {
  const auto json = nlohmann::json::parse(timing_json(small()));
  EXPECT_EQ(json["context"]["facts_now"]["load"], "4");
  const auto& all = json["benchmarks"];
  ASSERT_EQ(all.size(), 8U);  // two rounds and the median of each side; two errors
  EXPECT_EQ(all[0]["name"], "before/heap");
  EXPECT_EQ(all[0]["run_type"], "iteration");
  EXPECT_DOUBLE_EQ(all[0]["cpu_time"], 100);
  EXPECT_EQ(all[5]["name"], "now/heap_median");
  EXPECT_DOUBLE_EQ(all[5]["real_time"], 210);
  EXPECT_EQ(all[6]["error_message"], "refused");
}

}  // namespace
}  // namespace plumb::report_test
