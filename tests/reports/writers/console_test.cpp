#include "reports/writers/console.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "sample.h"

namespace plumb::console_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Console, FitsTheWidth) {
  for (const std::size_t width : {60u, 80u, 100u, 160u}) {
    std::istringstream text(console_text(sample_report(), {.width = width}));
    for (std::string line; std::getline(text, line);) EXPECT_LE(line.size(), width) << line;
  }
}

TEST(Console, ShowsVerdictsReasonsAndTheChecksThatFailed) {
  const std::string text = console_text(sample_report(), {.width = 160});
  EXPECT_THAT(text, HasSubstr("slide: Does it slide?"));
  EXPECT_THAT(text, HasSubstr("wrong"));
  EXPECT_THAT(text, HasSubstr("0/1"));
  EXPECT_THAT(text, HasSubstr("expected 0.333333 +- 0.1 m"));
  EXPECT_THAT(text, HasSubstr("breaks push of box, \"the\" first - ground at 1.5 s: 0.5, tolerance 0 N s"));
  EXPECT_THAT(text, HasSubstr("diverged at t = 1 s"));
  EXPECT_THAT(text, HasSubstr("lost: 1 failed"));
}

TEST(Console, HasPairsOfEnginesOnlyIfAsked) {
  EXPECT_THAT(console_text(sample_report()), Not(HasSubstr("diverged at 0.5 s")));
  EXPECT_THAT(console_text(sample_report(), {.verbose = true}), HasSubstr("diverged at 0.5 s"));
}

TEST(Console, ShowsHowFarARunIsFromTheFirstEngineWhereThereIsNoTruth) {
  std::istringstream text(console_text(sample_report(), {.width = 160}));
  std::string row;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("  lost")) row = line;
  }
  std::vector<std::string> cells;
  std::istringstream words(row);
  for (std::string word; words >> word;) cells.push_back(word);
  // Engine, verdict, checks, error, tolerance, error / tolerance, differs, rest, energy, overlap, us/step.
  EXPECT_THAT(cells, ::testing::ElementsAre("lost", "failed", "-", "-", "-", "-", "0.5", "-", "25", "-", "1.5")) << row;
}

TEST(Console, HasARowForEachCaseOfTheFirstTwoEngines) {
  const std::string text = console_text(sample_report(), {.width = 160});
  EXPECT_THAT(text, ::testing::ContainsRegex("slide:on ice +25 +200 +0 +- +3 +0.015 +- +0.5\n"));
  EXPECT_THAT(text, HasSubstr("b: lost"));
}

// What failed everywhere says nothing of a difference.
TEST(Console, ComparesTheFirstTwoEnginesThatRan) {
  Report report = sample_report();
  RunRecord ran = report.runs[1];
  ran.engine = "ran";
  ran.method = "";
  report.runs.push_back(ran);
  ran.engine = "ran too";
  report.runs.push_back(ran);
  report.comparisons[0].key.reset();
  report.comparisons.push_back(report.comparisons[0]);
  report.comparisons.back().a = "ran";
  report.comparisons.back().b = "ran too";
  report.comparisons.back().key = KeyDifferences{};
  EXPECT_THAT(console_text(report, {.width = 160}), HasSubstr("a: ran, b: ran too"));
  report.comparisons.pop_back();
  EXPECT_THAT(console_text(report, {.width = 160}), Not(HasSubstr("a: ")));
}

TEST(Console, SaysHowToFindOutWhyARunIsWrong) {
  Report report = sample_report();
  report.runs[1].engine = "slow";
  report.runs[1].method = "";
  const auto said = [&] { return console_text(report, {.width = 1000}); };
  EXPECT_THAT(said(), HasSubstr("Why? plumb diff 'slide:on ice' exact slow finds the first step that differs"));
  report.runs[0].metrics["truth_estimate_max"] = {1e-9, "m"};
  EXPECT_THAT(said(), HasSubstr("plumb diff 'slide:on ice' impulse slow"));
  report.runs[1].verdict = Verdict::coarse;
  EXPECT_THAT(said(), Not(HasSubstr("Why?")));
}

TEST(Console, CountsChecksByTheirErrorRelativeToScale) {
  Report report = sample_report();
  const TruthCheck near{.quantity = "y", .unit = "m", .error = 0.005, .tolerance = 0.01, .scale = 1, .passed = true};
  TruthCheck loose = near;
  loose.tolerance = 0.1;
  report.runs[1].truth = {near, near, loose};
  report.runs[1].truth[1].error = 0.00005;
  std::string text = console_text(report);
  std::replace(text.begin(), text.end(), '\n', ' ');
  EXPECT_THAT(
      text, HasSubstr("of 3 checks 100 % within 1 % of scale, 33 % within 0.01 %; not a test: 1 checks, 0 of 0 laws"));
}

TEST(Console, SaysOnWhichSideAValueMustBeAndWhatIsNotReported) {
  Report report = sample_report();
  TruthCheck& check = report.runs[1].truth[0];
  check.relation = Relation::at_most;
  EXPECT_THAT(console_text(report), HasSubstr("expected at most 0.333333 +- 0.1 m"));
  check.reported = false;
  const std::string text = console_text(report);
  EXPECT_THAT(text, HasSubstr("not reported"));
  EXPECT_THAT(text, Not(HasSubstr("0/1")));
}

TEST(Console, ColoursOnlyWhenAsked) {
  EXPECT_THAT(console_text(sample_report()), Not(HasSubstr("\033")));
  const std::string text = console_text(sample_report(), {.colour = true});
  EXPECT_THAT(text, HasSubstr("\033[31mwrong"));
  EXPECT_THAT(text, HasSubstr("\033[32mright"));
}

}  // namespace
}  // namespace plumb::console_test
