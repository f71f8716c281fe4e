#include <gmock/gmock.h>

#include "reports/writers/output.h"
#include "sample.h"
#include "scenarios/catalog.h"

namespace plumb::markdown_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string text_of(const Report& report) {
  std::string why_not;
  return Catalog<Writer>::find("markdown")->text(report, why_not).value();
}

TEST(Markdown, HasARowForEachCaseOfTheFirstTwoEngines) {
  EXPECT_THAT(text_of(sample_report()),
              HasSubstr("| slide:on ice | 25 (12) | 200 (0) | 0 (0) | - | 3 | 0.015 | - | 0.5 |"));
}

TEST(Markdown, SaysWhyACaseCannotBeCompared) {
  Report report = sample_report();
  report.comparisons.push_back(report.comparisons[0]);
  report.comparisons.back().variant = "on gravel";
  report.comparisons[0].key.reset();
  EXPECT_THAT(text_of(report), HasSubstr("| slide:on ice | lost: diverged |  |"));
}

TEST(Markdown, CountsChecksAndVerdictsOfEachEngine) {
  Report report = sample_report();
  report.runs[1].truth = {{.quantity = "y", .error = 0.005, .tolerance = 0.01, .scale = 1, .passed = true},
                          {.quantity = "y", .error = 0.5, .tolerance = 1, .scale = 1, .passed = true}};
  const std::string text = text_of(report);
  EXPECT_THAT(text, HasSubstr("iterations=1000 | 2 | 50 % | 50 % | 0 % | 0 % | 1 | 0 | 0 |"));
  EXPECT_THAT(text, HasSubstr("| engine | wrong | failed |"));
  EXPECT_THAT(text, HasSubstr("| lost | 0 | 1 |"));
}

TEST(Markdown, ListsWhatIsNotATestByCase) {
  Report report = sample_report();
  report.runs[1].truth = {{.body = "box", .quantity = "y", .time = 2, .error = 0.5, .tolerance = 1, .scale = 4}};
  report.runs[1].invariants = {{.name = "energy", .tolerance = 0.5, .scale = 2}, {.name = "overlap", .scale = 2}};
  const std::string text = text_of(report);
  EXPECT_THAT(text, HasSubstr("## Not a test for an engine with a rather long name"));
  EXPECT_THAT(text, HasSubstr("| slide:on ice | y of box at 2 s: 25, energy: 25 |"));
  EXPECT_THAT(text, Not(HasSubstr("## Not a test for lost")));
}

TEST(Markdown, SaysWhichEngineKeepsWhichRelationIfTheyWereChecked) {
  Report report = sample_report();
  EXPECT_THAT(text_of(report), Not(HasSubstr("relations")));
  report.runs[1].invariants = {{.name = "relation_mirror", .unit = "m"},
                               {.name = "relation_shift", .unit = "m", .status = CheckStatus::broken}};
  report.runs[1].metrics = {{"relation_mirror", {1e-4, "1"}}, {"relation_shift", {0.5, "1"}}};
  EXPECT_THAT(text_of(report), HasSubstr("| engine | mirror | shift |"));
  EXPECT_THAT(text_of(report), HasSubstr("| 100 % of 1, 0 broken | 0 % of 1, 1 broken |"));
  EXPECT_THAT(text_of(report), HasSubstr("| lost | - | - |"));
}

TEST(Markdown, LetsNoNameBreakATableOrBecomeMarkup) {
  Report report = sample_report();
  report.comparisons[0].variant = "a|b<script>";
  EXPECT_THAT(text_of(report), HasSubstr("slide:a&#124;b&#60;script&#62;"));
}

TEST(Markdown, HasNoTableOfDifferencesForOneEngine) {
  Report report = sample_report();
  report.runs.resize(2);
  EXPECT_THAT(text_of(report), Not(HasSubstr("against")));
}

}  // namespace
}  // namespace plumb::markdown_test
