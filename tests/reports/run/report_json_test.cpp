#include "reports/run/report_json.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "../writers/sample.h"
#include "reports/writers/json.h"

namespace plumb::report_json_test {
namespace {

using ::testing::HasSubstr;

Report read_back(const nlohmann::ordered_json& report) {
  return report_from(nlohmann::json::parse(report.dump()), "report.json");
}

std::string complaint(const nlohmann::ordered_json& report) {
  try {
    read_back(report);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(ReportFromJson, ReadsBackRunsChecksAndTimes) {
  const Report report = sample_report();
  const Report back = read_back(to_json(report));
  EXPECT_EQ(back.command, report.command);
  EXPECT_EQ(back.environment, report.environment);
  EXPECT_EQ(back.engines.at(0).name, "lost");
  ASSERT_EQ(back.runs.size(), 3u);
  const RunRecord& run = back.runs[1];
  EXPECT_EQ(run.method, report.runs[1].method);
  EXPECT_EQ(run.dt, 1.0 / 60);
  EXPECT_EQ(run.verdict, Verdict::wrong);
  EXPECT_EQ(run.metrics.at("energy_rise").unit, "1");
  EXPECT_TRUE(std::isnan(run.truth.at(0).error));
  EXPECT_EQ(run.truth.at(0).tolerance, 0.1);
  EXPECT_EQ(run.invariants.at(1).status, CheckStatus::broken);
  EXPECT_EQ(run.invariants.at(1).ratio, std::numeric_limits<double>::infinity());
  EXPECT_EQ(run.invariants.at(2).status, CheckStatus::not_reported);
  ASSERT_EQ(back.timings.size(), 1u);
  EXPECT_EQ(back.timings[0].step_us, 1.5);
  EXPECT_EQ(back.timings[0].repetitions, 5);
}

TEST(ReportFromJson, ReadsBackWhatChanceExplains) {
  Report report = sample_report();
  EXPECT_FALSE(to_json(report)["runs"][1]["truth"][0].contains("chance")) << "nothing";
  TruthCheck& check = report.runs[1].truth[0];
  check.error = 0.5;
  check.scale = 2;
  check.chance = 0.25;
  const nlohmann::ordered_json json = to_json(report);
  EXPECT_EQ(json["runs"][1]["truth"][0]["relative_error"], 0.125);
  EXPECT_EQ(relative_error(read_back(json).runs[1].truth[0]), 0.125);
}

// As version 1 wrote it.
TEST(ReportFromJson, ReadsVersion1) {
  const nlohmann::ordered_json now = to_json(sample_report());
  nlohmann::json old = nlohmann::json::parse(now.dump());
  old["plumb"] = 1;
  for (nlohmann::json& run : old["runs"]) {
    for (nlohmann::json& check : run["truth"]) rename_key(check, "reported", "revealed");
    for (nlohmann::json& check : run["invariants"]) {
      if (check["status"] == "not reported") check["status"] = "not revealed";
      rename_key(check, "status", "standing");
      rename_key(check, "tolerance", "allowed");
    }
  }
  ASSERT_TRUE(old["runs"][1]["invariants"][2].contains("standing"));
  ASSERT_TRUE(old["runs"][1]["truth"][0].contains("revealed"));
  const Report report = report_from(old, "old.json");
  EXPECT_EQ(report.runs.at(1).invariants.at(1).tolerance, 0);
  EXPECT_EQ(report.runs.at(1).invariants.at(2).status, CheckStatus::not_reported);
  EXPECT_TRUE(report.runs.at(1).truth.at(0).reported);

  old["plumb"] = 2;
  EXPECT_THROW(report_from(old, "old.json"), std::invalid_argument) << "version 2 has other names";
}

TEST(ReportFromJson, TakesNoCheckOfVersion2ForEvidenceAsItHasNoScale) {
  const nlohmann::ordered_json now = to_json(sample_report());
  nlohmann::json old = nlohmann::json::parse(now.dump());
  old["plumb"] = 2;
  for (nlohmann::json& run : old["runs"]) {
    for (nlohmann::json& check : run["truth"]) check.erase("scale");
  }
  const Report report = report_from(old, "old.json");
  EXPECT_FALSE(is_evidence(report.runs.at(1).truth.at(0)));
  EXPECT_EQ(report.runs.at(1).truth.at(0).tolerance, 0.1);
}

TEST(ReportFromJson, TakesEnginesOfVersion3ByTheirNames) {
  nlohmann::json old = nlohmann::json::parse(to_json(sample_report()).dump());
  old["plumb"] = 3;
  for (nlohmann::json& engine : old["engines"]) engine.erase("word");
  EXPECT_EQ(report_from(old, "old.json").engines.at(0).word, "");
}

TEST(ReportFromJson, NamesThePlaceOfWhatItCannotRead) {
  nlohmann::ordered_json newer = to_json(sample_report());
  newer["plumb"] = 5;
  EXPECT_THAT(complaint(newer), HasSubstr("report.json: plumb: expected a number from 1 to 4, found 5"));
  EXPECT_THAT(complaint(nlohmann::ordered_json::array()), HasSubstr("report.json: top level: expected an object"));
  nlohmann::ordered_json damaged = to_json(sample_report());
  damaged["runs"][1]["invariants"][0]["status"] = "hold";
  EXPECT_THAT(complaint(damaged), HasSubstr("runs[1].invariants[0].status: "));
  damaged["runs"][1]["invariants"][0].erase("status");
  EXPECT_THAT(complaint(damaged), HasSubstr("runs[1].invariants[0]: the key \"status\" is missing"));
  damaged = to_json(sample_report());
  damaged["timings"]["steps"][0].erase("step_us");
  EXPECT_THAT(complaint(damaged), HasSubstr("timings.steps[0]: the key \"step_us\" is missing"));
}

}  // namespace
}  // namespace plumb::report_json_test
