#include "reports/writers/json.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "sample.h"

namespace plumb::json_test {
namespace {

using Json = nlohmann::ordered_json;

TEST(Json, HasWhatTheFormatPromises) {
  const Json report = to_json(sample_report());
  EXPECT_EQ(report["plumb"], 4);
  EXPECT_EQ(report["environment"]["compiler"], "some");
  const Json& run = report["runs"][1];
  for (const char* key : {"scenario", "parameters", "engine", "method", "dt", "status", "reason", "metrics", "truth",
                          "verdict", "variant", "exact"}) {
    EXPECT_TRUE(run.contains(key)) << key;
  }
  for (const char* key : {"body", "quantity", "time", "expected", "measured", "error", "tolerance", "scale",
                          "relative_error", "evidence", "passed"}) {
    EXPECT_TRUE(run["truth"][0].contains(key)) << key;
  }
  EXPECT_EQ(run["metrics"]["energy_rise"]["unit"], "1");
  EXPECT_EQ(report["runs"][2]["status"], "failed");
  EXPECT_EQ(report["comparisons"].size(), 1u);
}

TEST(Json, HasTheKeyDifferencesOfTwoRuns) {
  Report report = sample_report();
  const Json key = to_json(report)["comparisons"][0]["key_differences"];
  EXPECT_EQ(key["energy"]["largest"], 0.25);
  EXPECT_EQ(key["energy"]["end"], 0.125);
  EXPECT_EQ(key["energy"]["scale"], 4);
  EXPECT_EQ(key["resting"], "one");
  EXPECT_TRUE(key["rest_a"].is_null());
  EXPECT_EQ(key["rest_b"], 3);
  EXPECT_EQ(key["overlap_a"], 0.015);
  EXPECT_EQ(key["diverged_at"], 0.5);
  report.comparisons[0].key.reset();
  EXPECT_TRUE(to_json(report)["comparisons"][0]["key_differences"].is_null());
}

TEST(Json, KeepsAllThatHangsOnTheClockApart) {
  Report report = sample_report();
  Json before = to_json(report);
  report.timings.clear();
  report.clock["outside_step"] = 0.9;
  Json after = to_json(report);
  EXPECT_NE(before.dump(), after.dump());
  before.erase("timings");
  after.erase("timings");
  EXPECT_EQ(before.dump(), after.dump());
}

TEST(Json, WritesNumbersThatReadBackToTheSameBits) {
  const Json back = Json::parse(to_json(sample_report()).dump());
  EXPECT_EQ(back["runs"][1]["truth"][0]["expected"].get<double>(), 1.0 / 3);
}

TEST(Json, WritesNullForWhatIsNotFinite) {
  const Json back = Json::parse(to_json(sample_report()).dump());
  EXPECT_TRUE(back["runs"][1]["truth"][0]["measured"].is_null());
  EXPECT_FALSE(back["runs"][1]["truth"][0]["passed"].get<bool>());
}

}  // namespace
}  // namespace plumb::json_test
