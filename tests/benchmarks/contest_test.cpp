#include "contest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace plumb::benchmarks {
namespace {

using testing::HasSubstr;

// Two rounds of ten steps: "fast" is twice as fast as "slow", once disturbed; "lost" has lost the scene.
Contest small() {
  const std::vector<Lap> slow{{.wall = 0.02, .cpu = 0.02}, {.wall = 0.02, .cpu = 0.02}};
  const std::vector<Lap> fast{{.wall = 0.01, .cpu = 0.01}, {.wall = 0.03, .cpu = 0.01}};
  Contest contest{.scene = "heap", .about = "of things", .window = {5, 15}, .rounds = 2, .against = "slow"};
  const auto enter = [&](const char* name, const std::vector<Lap>& laps) {
    Contest::Row& row = contest.rows.emplace_back();
    row.engine = name;
    row.finish.laps = laps;
    row.finish.overlap = {0.004, 0.05};
    row.figures = figures(laps, slow, 10, Basis::cpu);
  };
  enter("slow", slow);
  enter("fast", fast);
  enter("lost", {});
  contest.rows.back().finish.no_result = "body 3 has left";
  return contest;
}

TEST(Table, TellsTimeSpeedAndWhoHasNoResult) {
  const std::string text = table(small());
  EXPECT_THAT(text, HasSubstr("heap: of things\nsteps 5 to 15"));
  EXPECT_THAT(text, testing::ContainsRegex("fast +1000 +1000 - 1000 +2000 +2.00 +2.00 - 2.00 +4.00 +50.0 +1 of 2\n"));
  EXPECT_THAT(text, testing::ContainsRegex("lost +no result: body 3 has left\n"));
}

TEST(GoogleJson, HoldsRoundsMediansAndErrors) {
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
  EXPECT_EQ(all[6]["error_message"], "body 3 has left");
  EXPECT_FALSE(all[6].contains("cpu_time"));
}

}  // namespace
}  // namespace plumb::benchmarks
