#include <gmock/gmock.h>

#include <limits>
#include <sstream>
#include <stdexcept>

#include "../cli/commands/scene_files.h"
#include "../writers/sample.h"
#include "reports/gate/baseline.h"
#include "reports/gate/result.h"
#include "reports/writers/json.h"
#include "sample.h"

namespace plumb::baseline_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

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

class BaselineFile : public SceneFiles {
 protected:
  static Baseline sample() {
    Baseline baseline = fakes::baseline();
    BaselineRun& run = fakes::run_of(baseline);
    run.numbers["loose \"one\""] = {.value = 0.1, .bound = std::numeric_limits<double>::infinity(), .unstable = true};
    run.numbers["unknown"] = {.value = std::numeric_limits<double>::quiet_NaN()};
    run.perturbed_verdicts.insert(Verdict::wrong);
    baseline.scenarios = {"bounce:<img src=x>"};
    baseline.runs[{"<img src=x>", "", "box2d", "a=1,b=2"}] = {.verdict = Verdict::not_supported, .reason = "no \\"};
    return baseline;
  }
  std::string complaint(const std::string& text) const {
    try {
      read_results(put("wrong.json", text));
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "none";
  }
  static std::string with(const std::string& what, const std::string& instead) {
    std::string text = to_text(sample());
    return text.replace(text.find(what), what.size(), instead);
  }
};

TEST_F(BaselineFile, ReadsBackToTheSameBytes) {
  const std::string text = to_text(sample());
  const Baseline back = read_baseline(put("one.json", text));
  EXPECT_EQ(to_text(back), text);
  const GateResult result = compare(sample(), back);
  EXPECT_TRUE(result.passed()) << result.verdict;
  EXPECT_EQ(back.runs.at(fakes::run_key()).numbers.at("penetration_max"),
            sample().runs.at(fakes::run_key()).numbers.at("penetration_max"));
  EXPECT_EQ(back.scenarios, sample().scenarios);
}

TEST_F(BaselineFile, ChangesOneLineForOneNumber) {
  Baseline other = sample();
  other.runs.at(fakes::run_key()).numbers["penetration_max"].value = 2;
  const auto lines = [](const Baseline& baseline) {
    std::vector<std::string> all;
    std::istringstream in(to_text(baseline));
    for (std::string line; std::getline(in, line);) all.push_back(line);
    return all;
  };
  const auto a = lines(sample());
  const auto b = lines(other);
  ASSERT_EQ(a.size(), b.size());
  int differ = 0;
  for (std::size_t i = 0; i < a.size(); ++i) differ += a[i] == b[i] ? 0 : 1;
  EXPECT_EQ(differ, 1);
}

TEST_F(BaselineFile, NamesThePlaceOfDamage) {
  EXPECT_THAT(complaint(to_text(sample()).substr(0, 300)), HasSubstr("wrong.json: line "));
  EXPECT_THAT(complaint(with("\"value\":1.0", "\"value\":\"x\"")),
              AllOf(HasSubstr("runs[1].numbers.penetration_max.value"), HasSubstr("expected a number")));
  EXPECT_THAT(complaint(with("\"verdict\": \"right\"", "\"verdict\": \"rihgt\"")),
              HasSubstr("did you mean \"right\"?"));
  EXPECT_THAT(complaint(with("\"bits\": \"00000000000000aa\",", "")), HasSubstr("the key \"bits\" is missing"));
  EXPECT_THAT(complaint(with("\"bound\":0.5", "\"bound\":-1")), HasSubstr("numbers.penetration_max.bound"));
  EXPECT_THAT(complaint(with("\"variant\": \"\"", "\"variant\": \"\\u0007\"")),
              HasSubstr("without control characters"));
}

TEST_F(BaselineFile, RefusesForeignAndNewerFiles) {
  EXPECT_THAT(complaint("[]"), HasSubstr("expected a baseline or a report.json"));
  EXPECT_THAT(complaint(R"({"plumb": 1, "bodies": []})"), HasSubstr("neither a baseline"));
  EXPECT_THAT(complaint(with("\"plumb_baseline\": 4", "\"plumb_baseline\": 5")), HasSubstr("plumb_baseline: expected"));
  EXPECT_THROW(read_baseline(put("report.json", to_json(sample_report()).dump())), std::invalid_argument);
  EXPECT_THROW(read_baseline(at("none.json")), std::invalid_argument);
}

// As version 1 wrote it.
TEST_F(BaselineFile, ReadsVersion1) {
  const Baseline back = read_baseline(put("old.json", R"({
 "plumb_baseline": 1, "dt": 0.015625, "all": false, "scenarios": ["bounce"],
 "platform": {"architecture":"one","libm":"this"}, "engines": {"impulse":"here"},
 "runs": [
  {"scenario": "bounce", "variant": "e=0.5", "engine": "impulse", "method": "", "exact": false, "verdict": "right",
   "reason": "", "neighbours": ["right","wrong"], "bits": "00000000000000aa",
   "numbers": {
    "invariant: cone": {"value":0.0,"unit":"N s","standing":"not revealed","allowed":0.0,"moves":"any"},
    "penetration_max": {"value":1.0,"unit":"m","moves":0.5},
    "truth: y of box at 2 s": {"value":0.25,"unit":"m","standing":"held","allowed":0.5,"moves":0.125,"wavers":true}}}]})"));
  Baseline expected = fakes::baseline();
  expected.scenarios = {"bounce"};
  BaselineRun& run = fakes::run_of(expected);
  run.perturbed_verdicts = {Verdict::right, Verdict::wrong};
  run.numbers["invariant: cone"] = {.unit = "N s", .status = CheckStatus::not_reported, .bound = unbounded};
  fakes::check_of(expected).unstable = true;
  EXPECT_EQ(to_text(back), to_text(expected));
}

// It called "not reported" what is now told apart as "not applicable".
TEST_F(BaselineFile, OfVersion3AgreesThatAContactLawWasNotJudgedInFlight) {
  Baseline flight = sample();
  fakes::run_of(flight).numbers["invariant: bouncing"] = {.unit = "m/s", .status = CheckStatus::not_reported};
  std::string old = to_text(flight);
  const std::string version = "\"plumb_baseline\": 4";
  const Baseline back =
      read_baseline(put("old.json", old.replace(old.find(version), version.size(), "\"plumb_baseline\": 3")));
  fakes::run_of(flight).numbers["invariant: bouncing"].status = CheckStatus::not_applicable;
  EXPECT_TRUE(compare(back, flight).passed());
  EXPECT_FALSE(compare(read_baseline(put("new.json", to_text(flight))), back).passed());
}

TEST_F(BaselineFile, SaysThatVerdictsOfVersion2MeantSomethingElse) {
  const Baseline back = read_baseline(put("old.json", with("\"plumb_baseline\": 4", "\"plumb_baseline\": 2")));
  const GateResult result = compare(back, sample());
  EXPECT_TRUE(result.passed());
  EXPECT_THAT(result.notes, testing::Contains(HasSubstr("plumb accept makes it anew")));
  EXPECT_TRUE(compare(sample(), sample()).notes.empty());
}

TEST_F(BaselineFile, RefusesARunThatIsThereTwice) {
  const std::string text = to_text(sample());
  const auto begin = text.find("  {\n");
  const auto end = text.find("\n  }", begin) + 4;
  std::string twice = text;
  twice.insert(end, ",\n" + text.substr(begin, end - begin));
  EXPECT_THAT(complaint(twice), HasSubstr("is there twice"));
}

TEST_F(BaselineFile, CanBeAReport) {
  const Report report = sample_report();
  const Baseline back = read_results(put("report.json", to_json(report).dump()));
  EXPECT_EQ(back.scenarios, std::vector<std::string>{"slide:on ice"});
  Baseline before = baseline_of(report);
  EXPECT_EQ(back.runs.size(), before.runs.size());
  for (auto& [key, run] : before.runs) run.reason = run.bits = "";  // not in a report
  const GateResult result = compare(before, back);
  EXPECT_TRUE(result.passed()) << result.regressions.at(0).why;
}

}  // namespace
}  // namespace plumb::baseline_test
