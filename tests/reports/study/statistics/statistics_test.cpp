#include <gmock/gmock.h>

#include <map>

#include "../study_files.h"
#include "reports/study/job.h"
#include "reports/study/study.h"
#include "scenarios/catalog.h"

namespace plumb::statistics_study_test {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class StatisticsStudy : public StudyFiles {
 protected:
  std::vector<std::string> statistics(const std::string& out, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"study",    "statistics", "--ensembles", "domino-wave",
                                 "--engine", "impulse",    "--out",       at(out)};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
};

TEST_F(StatisticsStudy, PlansAJobForEverySeed) {
  const StudyPlan plan =
      Catalog<Study>::find("statistics")
          ->plan({{"ensembles", Json::array()}, {"engines", Json::array()}, {"large", false}, {"controls", true}});
  std::map<std::string, int> keys;
  for (const Job& job : plan.jobs) EXPECT_EQ(++keys[job.key], 1) << job.key;
  for (const char* key : {"statistics|galton|impulse|seed 1", "statistics|silo|box2d|seed 3",
                          "statistics|galton|control:leaning|seed 1"}) {
    EXPECT_TRUE(keys.contains(key)) << key;
  }
}

TEST_F(StatisticsStudy, AnswersInItsFirstLine) {
  const Said said = say(statistics("one", {"--controls"}));
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.out, StartsWith("impulse agrees in 1 of 1 statistics.\n"));
  EXPECT_THAT(said.out, HasSubstr("control:half-gravity differs, as it must, in domino-wave"));
  EXPECT_THAT(text(at("one") + "/statistics/intervals.csv"), HasSubstr("domino-wave,impulse,speed/sqrt(g h),16,1.7"));
  const Json found = document("one", "statistics").at("findings");
  EXPECT_EQ(found.at("looks"), 2);
  EXPECT_EQ(found.at("ensembles").at(0).at("results").at(0).at("verdict"), "agrees");
  EXPECT_EQ(found.at("ensembles").at(0).at("results").at(1).at("verdict"), "differs");
}

TEST_F(StatisticsStudy, IsTheSameInShards) {
  EXPECT_EQ(say(statistics("whole")).code, 0);
  EXPECT_EQ(say(statistics("parts", {"--shard", "1/2"})).code, 0);
  EXPECT_EQ(say(statistics("parts", {"--shard", "2/2"})).code, 0);
  const std::string parts = at("parts") + "/study-statistics-";
  EXPECT_EQ(say({"merge", parts + "1-of-2.jsonl", parts + "2-of-2.jsonl", "--out", at("merged")}).code, 0);
  EXPECT_EQ(document("merged", "statistics").dump(1), document("whole", "statistics").dump(1));
}

TEST_F(StatisticsStudy, SaysWhichEnsemblesThereAre) {
  const Said said = say({"study", "statistics", "--ensembles", "galtonn", "--out", at("none")});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("did you mean \"galton\"?"));
}

TEST_F(StatisticsStudy, SaysWhichEngineCannotRunAnEnsemble) {
  const Said said =
      say({"study", "statistics", "--ensembles", "silo", "--engine", "impulse:solver=exact", "--out", at("none")});
  EXPECT_EQ(said.code, 0);
  EXPECT_THAT(said.out, HasSubstr("impulse:solver=exact not supported in silo: 12 of 12 runs"));
}

}  // namespace
}  // namespace plumb::statistics_study_test
