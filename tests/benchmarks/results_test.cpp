#include "results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

namespace plumb::benchmarks::results_test {
namespace {

using testing::HasSubstr;

// Two rounds of ten steps: "fast" is twice as fast as "slow", once disturbed; the scene of "lost" has collapsed.
BenchmarkResult small() {
  const std::vector<Elapsed> slow{{.wall = 0.02, .cpu = 0.02}, {.wall = 0.02, .cpu = 0.02}};
  const std::vector<Elapsed> fast{{.wall = 0.01, .cpu = 0.01}, {.wall = 0.03, .cpu = 0.01}};
  BenchmarkResult result{.scene = "heap", .about = "of things", .window = {5, 15}, .rounds = 2, .against = "slow"};
  const auto add = [&](const char* name, const std::vector<Elapsed>& rounds) {
    EngineResult& one = result.engines.emplace_back();
    one.engine = name;
    one.times.rounds = rounds;
    one.times.overlap = {0.004, 0.05};
    one.summary = summarize(rounds, slow, 10, TimeBasis::cpu);
  };
  add("slow", slow);
  add("fast", fast);
  add("lost", {});
  result.engines.back().times.no_result = "body 3 has left the scene";
  return result;
}

TEST(BenchmarkTable, ShowsTimesSpeedsAndWhyThereIsNoResult) {
  const std::string text = table(small());
  EXPECT_THAT(text, HasSubstr("heap: of things\nsteps 5 to 15"));
  EXPECT_THAT(text, testing::ContainsRegex("fast +1000 +1000 - 1000 +2000 +2.00 +2.00 - 2.00 +4.00 +50.0 +1 of 2\n"));
  EXPECT_THAT(text, testing::ContainsRegex("lost +no result: body 3 has left the scene\n"));
}

TEST(BenchmarkJson, HoldsRoundsMediansAndErrors) {
  const auto json = nlohmann::json::parse(google_json({small()}));
  EXPECT_TRUE(json["context"].contains("date"));
  const auto& all = json["benchmarks"];
  ASSERT_EQ(all.size(), 7U);
  EXPECT_EQ(all[4]["name"], "heap/fast");
  EXPECT_EQ(all[4]["run_type"], "iteration");
  EXPECT_EQ(all[4]["repetition_index"], 1);
  EXPECT_EQ(all[4]["iterations"], 10);
  EXPECT_DOUBLE_EQ(all[4]["real_time"], 3000);
  EXPECT_DOUBLE_EQ(all[4]["cpu_time"], 1000);
  EXPECT_EQ(all[4]["time_unit"], "us");
  EXPECT_EQ(all[4]["disturbed"], 1);
  EXPECT_EQ(all[5]["name"], "heap/fast_median");
  EXPECT_EQ(all[5]["aggregate_name"], "median");
  EXPECT_DOUBLE_EQ(all[5]["speed_against_slow"], 2);
  EXPECT_EQ(all[6]["error_occurred"], true);
  EXPECT_EQ(all[6]["error_message"], "body 3 has left the scene");
  EXPECT_FALSE(all[6].contains("cpu_time"));
}

TEST(TimesSummary, HasMedianTimesPerStep) {
  const std::vector<Elapsed> rounds{{.wall = 6, .cpu = 3}, {.wall = 2, .cpu = 1}, {.wall = 4, .cpu = 2}};
  const TimesSummary all = summarize(rounds, {}, 10, TimeBasis::cpu);
  EXPECT_DOUBLE_EQ(all.wall.median, 0.4);
  EXPECT_DOUBLE_EQ(all.cpu.median, 0.2);
  EXPECT_DOUBLE_EQ(all.cpu.low, 0.15);
  EXPECT_EQ(all.speed.median, 0);
}

TEST(TimesSummary, ComparesSpeedRoundByRound) {
  const std::vector<Elapsed> rounds{{.wall = 1, .cpu = 1}, {.wall = 9, .cpu = 3}};
  const std::vector<Elapsed> reference{{.wall = 2, .cpu = 2}, {.wall = 9, .cpu = 9}};
  EXPECT_DOUBLE_EQ(summarize(rounds, reference, 1, TimeBasis::cpu).speed.median, 2.5);
  EXPECT_DOUBLE_EQ(summarize(rounds, reference, 1, TimeBasis::wall).speed.median, 1.5);
}

TEST(TimesSummary, ComparesOnlyEqualNumbersOfRounds) {
  const std::vector<Elapsed> one(1);
  EXPECT_EQ(summarize({}, one, 1, TimeBasis::cpu).speed.median, 0);
  EXPECT_THROW(summarize(std::vector<Elapsed>(2), one, 1, TimeBasis::cpu), std::invalid_argument);
}

TEST(TimesSummary, CountsDisturbedRounds) {
  EXPECT_FALSE(disturbed({.wall = 1, .cpu = 0.91}));
  EXPECT_TRUE(disturbed({.wall = 1, .cpu = 0.89}));
  const std::vector<Elapsed> rounds{{.wall = 2, .cpu = 1}, {.wall = 1, .cpu = 1}};
  EXPECT_EQ(summarize(rounds, rounds, 1, TimeBasis::cpu).disturbed, 1);
}

}  // namespace
}  // namespace plumb::benchmarks::results_test
