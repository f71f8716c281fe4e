#include "reports/history/snapshot.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "../writers/sample.h"
#include "reports/writers/json.h"
#include "sample.h"

namespace plumb {
namespace {

using ::testing::HasSubstr;

TEST(Snapshot, ReadsBackToTheSameLine) {
  Snapshot snapshot = sample_snapshot(3);
  snapshot.answers.begin()->second.metrics["odd"] = {0.1 + 0.2, "m"};
  snapshot.answers.begin()->second.metrics["small"] = {5e-324, "\u00b5m \"quoted\""};
  const std::string line = to_line(snapshot);
  EXPECT_EQ(to_line(snapshot_of_line(line, "line")), line);
  EXPECT_THAT(line, HasSubstr("0.30000000000000004"));
  EXPECT_THAT(line, HasSubstr("\"horizon\":[null,\"s\"]"));
}

TEST(Snapshot, IsTheSameWithAnyZero) {
  Snapshot a = sample_snapshot(0), b = a;
  a.answers.begin()->second.metrics["drift"] = {0.0, "m"};
  b.answers.begin()->second.metrics["drift"] = {-0.0, "m"};
  EXPECT_EQ(id_of(a), id_of(b));
}

TEST(Snapshot, HasAnotherIdWhereAnythingDiffers) {
  const Snapshot one = sample_snapshot(0);
  Snapshot other = one;
  other.answers.begin()->second.verdict += "!";
  EXPECT_NE(id_of(one), id_of(other));
  other = one;
  other.commit += "0";
  EXPECT_NE(id_of(one), id_of(other));
  other = one;
  other.answers.rbegin()->second.time->high += 1e-15;
  EXPECT_NE(id_of(one), id_of(other));
}

TEST(Snapshot, RefusesALineThatIsNoneWithThePlace) {
  const auto refusal = [](const std::string& line) -> std::string {
    try {
      snapshot_of_line(line, "lines: line 7");
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refusal("{}"), HasSubstr("lines: line 7: "));
  EXPECT_THAT(refusal(R"({"plumb_history":2})"), HasSubstr("plumb_history: expected a number from 1 to 1, found 2"));
  std::string line = to_line(sample_snapshot(0));
  line.replace(line.find("2026-01-01T00:00:00Z"), 20, "2026-01-01T00:00:00+");
  EXPECT_THAT(refusal(line), HasSubstr("is no moment"));
}

Snapshot recorded(const nlohmann::ordered_json& report) { return snapshot_of_report(report.dump(), "report.json"); }

TEST(Snapshot, KeepsOfAReportItsMetricsVerdictsTimesAndWorstShare) {
  const auto json = to_json(sample_report());
  const Snapshot snapshot = recorded(json);
  EXPECT_EQ(snapshot.answers.size(), json["runs"].size());
  const Answered& exact = snapshot.answers.at({"slide", "on ice", "sliding", 1.0 / 60});
  EXPECT_EQ(exact.verdict, "right");
  EXPECT_EQ(exact.metrics.at("energy_rise").value, 0);
  EXPECT_FALSE(exact.metrics.contains("share_of_allowed"));
  for (const auto& [subject, answered] : snapshot.answers) {
    if (answered.verdict != "wrong") continue;
    // A reading that is no number, and a law without any allowance broken.
    EXPECT_TRUE(std::isnan(answered.metrics.at("share_of_allowed").value)) << subject.engine;
  }
}

TEST(Snapshot, KeepsTheWorstOfWhatIsReported) {
  RunRecord run{.scenario = "fall", .variant = "one", .engine = "e", .dt = 0.01, .verdict = Verdict::right};
  run.truth = {{.error = 1, .tolerance = 4, .passed = true},
               {.error = 9, .tolerance = 1, .passed = false, .reported = false}};
  run.invariants = {{.name = "energy", .ratio = 0.5},
                    {.name = "push", .status = CheckStatus::not_reported, .ratio = 3}};
  Report report;
  report.runs = {run};
  report.timings = {{.scenario = "fall",
                     .variant = "one",
                     .engine = "e",
                     .step_us = 2,
                     .step_us_low = 1,
                     .step_us_high = 3,
                     .repetitions = 5}};
  const Snapshot snapshot = recorded(to_json(report));
  const Answered& answered = snapshot.answers.at({"fall", "one", "e", 0.01});
  EXPECT_EQ(answered.metrics.at("share_of_allowed").value, 0.5);
  ASSERT_TRUE(answered.time);
  EXPECT_EQ(answered.time->median, 2);
  EXPECT_EQ(answered.time->repetitions, 5);
}

TEST(Snapshot, RefusesAReportOfAnotherFormat) {
  auto json = to_json(Report{});
  json["plumb"] = 2;
  EXPECT_THROW(recorded(json), std::invalid_argument);
  EXPECT_THROW(recorded(nlohmann::ordered_json::array()), std::invalid_argument);
}

}  // namespace
}  // namespace plumb
