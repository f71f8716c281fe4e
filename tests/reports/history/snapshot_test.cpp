#include "reports/history/snapshot.h"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "../writers/sample.h"
#include "reports/system/hash.h"
#include "reports/writers/json.h"
#include "sample.h"

namespace plumb::snapshot_test {
namespace {

using ::testing::HasSubstr;

TEST(Snapshot, ReadsBackToTheSameLine) {
  Snapshot snapshot = sample_snapshot(3);
  snapshot.runs.begin()->second.metrics["odd"] = {0.1 + 0.2, "m"};
  snapshot.runs.begin()->second.metrics["small"] = {5e-324, "\u00b5m \"quoted\""};
  const std::string line = to_line(snapshot);
  EXPECT_EQ(to_line(snapshot_of_line(line, "line")), line);
  EXPECT_THAT(line, HasSubstr("0.30000000000000004"));
  EXPECT_THAT(line, HasSubstr("\"horizon\":[null,\"s\"]"));
}

TEST(Snapshot, NoticesAChangedDigitInASealedLine) {
  const Snapshot snapshot = sample_snapshot(3);
  std::string line = to_sealed_line(snapshot);
  EXPECT_EQ(to_line(snapshot_of_line(line, "line")), to_line(snapshot));
  const std::size_t digit = line.find("\"dt\":") + 7;
  line[digit] = line[digit] == '5' ? '6' : '5';
  EXPECT_THROW(snapshot_of_line(line, "line"), std::invalid_argument);
}

TEST(Snapshot, DoesNotDistinguishZeros) {
  Snapshot a = sample_snapshot(0), b = a;
  a.runs.begin()->second.metrics["drift"] = {0.0, "m"};
  b.runs.begin()->second.metrics["drift"] = {-0.0, "m"};
  EXPECT_EQ(id_of(a), id_of(b));
}

TEST(Snapshot, HasAnotherIdIfAnythingDiffers) {
  const Snapshot one = sample_snapshot(0);
  Snapshot other = one;
  other.runs.begin()->second.verdict += "!";
  EXPECT_NE(id_of(one), id_of(other));
  other = one;
  other.commit += "0";
  EXPECT_NE(id_of(one), id_of(other));
  other = one;
  other.runs.rbegin()->second.time->high += 1e-15;
  EXPECT_NE(id_of(one), id_of(other));
}

TEST(Snapshot, NamesThePlaceOfWhatIsNotALine) {
  const auto refusal = [](const std::string& line) -> std::string {
    try {
      snapshot_of_line(line, "lines: line 7");
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refusal("{}"), HasSubstr("lines: line 7: "));
  EXPECT_THAT(refusal(R"({"plumb_history":3})"), HasSubstr("plumb_history: expected a number from 1 to 2, found 3"));
  std::string line = to_line(sample_snapshot(0));
  line.replace(line.find("2026-01-01T00:00:00Z"), 20, "2026-01-01T00:00:00+");
  EXPECT_THAT(refusal(line), HasSubstr("is not a date or time"));
}

// As version 1 wrote it.
TEST(Snapshot, OfAnOldLineIsTheOneOfANewLine) {
  const Snapshot snapshot = sample_snapshot(3);
  std::string old = to_line(snapshot);
  const auto replace = [&old](const std::string& what, const std::string& with) {
    for (std::size_t at = 0; (at = old.find(what, at)) != old.npos; at += with.size())
      old.replace(at, what.size(), with);
  };
  replace("\"plumb_history\":2", "\"plumb_history\":1");
  replace("\"runs\":", "\"answers\":");
  replace("\"engine\":", "\"contender\":");
  replace("\"worst_error_ratio\":[0.5,\"1\"]", "\"share_of_allowed\":[0.5,\"1\"]");
  EXPECT_EQ(old_id_of(snapshot), sha256(old));
  EXPECT_EQ(to_line(snapshot_of_line(old, "line")), to_line(snapshot));
  EXPECT_EQ(id_of(snapshot_of_line(old, "line")), id_of(snapshot));
  replace("\"plumb_history\":1", "\"plumb_history\":2");
  EXPECT_THROW(snapshot_of_line(old, "line"), std::invalid_argument) << "version 2 has other names";
}

Snapshot recorded(const nlohmann::ordered_json& report) { return snapshot_of_report(report.dump(), "report.json"); }

TEST(Snapshot, HasTheMetricsVerdictsAndWorstRatiosOfAReport) {
  const auto json = to_json(sample_report());
  const Snapshot snapshot = recorded(json);
  EXPECT_EQ(snapshot.runs.size(), json["runs"].size());
  const SnapshotRun& exact = snapshot.runs.at({"slide", "on ice", "sliding", 1.0 / 60});
  EXPECT_EQ(exact.verdict, "right");
  EXPECT_EQ(exact.metrics.at("energy_rise").value, 0);
  EXPECT_FALSE(exact.metrics.contains(worst_ratio_metric));
  for (const auto& [subject, run] : snapshot.runs) {
    if (run.verdict != "wrong") continue;
    // A reading that is NaN, and a broken invariant with a tolerance of 0.
    EXPECT_TRUE(std::isnan(run.metrics.at(worst_ratio_metric).value)) << subject.engine;
  }
}

TEST(Snapshot, TakesTheWorstRatioOfReportedChecks) {
  RunRecord record{.scenario = "fall", .variant = "one", .engine = "e", .dt = 0.01, .verdict = Verdict::right};
  record.truth = {{.error = 1, .tolerance = 4, .passed = true},
                  {.error = 9, .tolerance = 1, .passed = false, .reported = false}};
  record.invariants = {{.name = "energy", .ratio = 0.5},
                       {.name = "push", .status = CheckStatus::not_reported, .ratio = 3}};
  Report report;
  report.runs = {record};
  report.timings = {{.scenario = "fall",
                     .variant = "one",
                     .engine = "e",
                     .step_us = 2,
                     .step_us_low = 1,
                     .step_us_high = 3,
                     .repetitions = 5}};
  const Snapshot snapshot = recorded(to_json(report));
  const SnapshotRun& run = snapshot.runs.at({"fall", "one", "e", 0.01});
  EXPECT_EQ(run.metrics.at(worst_ratio_metric).value, 0.5);
  ASSERT_TRUE(run.time);
  EXPECT_EQ(run.time->median, 2);
  EXPECT_EQ(run.time->repetitions, 5);
}

TEST(Snapshot, OfAnOldReportIsTheOneOfANewReport) {
  const auto now = to_json(sample_report());
  nlohmann::ordered_json old = now;
  old["plumb"] = 1;
  for (auto& run : old["runs"]) {
    for (auto& check : run["truth"]) {
      check["revealed"] = check["reported"];
      check.erase("reported");
    }
    for (auto& check : run["invariants"]) {
      check["standing"] = check["status"] == "not reported" ? "not revealed" : check["status"];
      check["allowed"] = check["tolerance"];
      check.erase("status");
      check.erase("tolerance");
    }
  }
  EXPECT_EQ(id_of(recorded(old)), id_of(recorded(now)));
}

TEST(Snapshot, RefusesReportsOfAnotherFormat) {
  auto json = to_json(Report{});
  json["plumb"] = 1000;
  EXPECT_THROW(recorded(json), std::invalid_argument);
  EXPECT_THROW(recorded(nlohmann::ordered_json::array()), std::invalid_argument);
}

}  // namespace
}  // namespace plumb::snapshot_test
