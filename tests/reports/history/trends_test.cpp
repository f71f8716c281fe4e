#include "reports/history/trends.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "sample.h"

namespace plumb::trends_test {
namespace {

class Trends : public InFolder {
 protected:
  Trends() {
    for (int i = 0; i < 20; ++i) history_.add(sample_snapshot(i));
  }

  const Trend& find(const std::vector<Trend>& all, const std::string& metric) const {
    for (const Trend& trend : all) {
      if (trend.series.metric == metric) return trend;
    }
    throw std::logic_error("there is no trend of " + metric);
  }

  History history_ = History::to_add(path("h"));
};

TEST_F(Trends, FindChangesOfMetricsAndVerdicts) {
  const auto trends = trends_of(history_.heads(), history_.series());
  const Trend& rise = find(trends, "energy_rise");
  ASSERT_EQ(rise.changes.size(), 1u);
  EXPECT_EQ(rise.series.values[rise.changes[0].at].snapshot, 10u);
  const auto verdicts = verdict_changes(history_.verdicts());
  ASSERT_EQ(verdicts.size(), 1u);
  EXPECT_EQ(verdicts[0].subject.engine, "impulse");
  EXPECT_EQ(verdicts[0].snapshot, 10u);
  EXPECT_EQ(verdicts[0].before + " " + verdicts[0].after, "right wrong");
}

// The verdict and energy_rise change at the 11th.
TEST_F(Trends, AreToldFromAMomentOn) {
  const auto heads = history_.heads();
  const auto trends = trends_of(heads, history_.series());
  const auto verdicts = verdict_changes(history_.verdicts());
  const auto told = [&](const std::string& since) { return text_of(heads, trends, verdicts, since); };
  EXPECT_THAT(told(""), testing::HasSubstr("right -> wrong"));
  EXPECT_THAT(told(heads[10].at), testing::HasSubstr("right -> wrong"));
  EXPECT_THAT(told(heads[10].at), testing::HasSubstr("2 changes in 10 snapshots since " + heads[10].at));
  EXPECT_THAT(told(heads[11].at), testing::StartsWith("0 changes in 9 snapshots"));
}

TEST_F(Trends, OfTwoSnapshotsAreSeenInExactNumbers) {
  History two = History::to_add(path("two"));
  for (const int i : {0, 10}) two.add(sample_snapshot(i));
  const auto heads = two.heads();
  const std::string told = text_of(heads, trends_of(heads, two.series()), verdict_changes(two.verdicts()));
  EXPECT_THAT(told, testing::HasSubstr("energy_rise"));
  EXPECT_THAT(told, testing::HasSubstr("show from 6 snapshots on"));
}

TEST_F(Trends, LeaveOutValuesThatAreNotFinite) {
  const auto trends = trends_of(history_.heads(), history_.series());
  EXPECT_EQ(trends.size(), 3u);
  EXPECT_THROW(find(trends, "horizon"), std::logic_error);
}

TEST_F(Trends, SeparateStepTimesByMachine) {
  for (int i = 20; i < 30; ++i) {
    Snapshot elsewhere = sample_snapshot(i);
    elsewhere.environment["processor"] = "another";
    elsewhere.runs.rbegin()->second.time->median *= 3;
    history_.add(elsewhere);
  }
  const auto times = trends_of(history_.heads(), history_.series(step_time));
  ASSERT_EQ(times.size(), 2u);
  EXPECT_NE(times[0].machine, times[1].machine);
  for (const Trend& trend : times) EXPECT_TRUE(trend.changes.empty());
  EXPECT_EQ(trends_of(history_.heads(), history_.series("energy_rise")).size(), 1u);
}

TEST_F(Trends, GiveThePageChangesAndAllStepTimes) {
  const auto document = history_document(history_);
  EXPECT_EQ(document["study"], "history");
  EXPECT_EQ(document["results"].size(), 20u);
  EXPECT_EQ(document["findings"]["trends"].size(), 1u);
  EXPECT_EQ(document["findings"]["verdicts"][0]["snapshot"], 10);
  EXPECT_EQ(document["timings"]["trends"][0]["high"].size(), 20u);
  EXPECT_EQ(document["findings"]["trends"][0]["engine"], "impulse");
  EXPECT_EQ(document["findings"]["unchanged"], 1);
}

}  // namespace
}  // namespace plumb::trends_test
