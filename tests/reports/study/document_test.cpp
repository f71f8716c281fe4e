#include "reports/study/document.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "study_files.h"

namespace plumb::document_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const std::vector<JobResult> results{
    {.key = "a,1", .output = {{{"x", 0.1}, {"word", "contains \"no\""}, {"list", {1, 2}}}, {{"median", 2.0}}}},
    {.key = "b", .ending = Ending::crashed, .reason = "signal 6", .output = {{{"y", true}, {"x", nullptr}}, {}}}};

TEST(StudyDocument, IsATableOfAllColumnsThatAnyResultHas) {
  EXPECT_EQ(csv_of(results),
            "key,ending,reason,x,word,y,time_median\n"
            "\"a,1\",done,,0.1,\"contains \"\"no\"\"\",,2.0\n"
            "b,crashed,signal 6,,,true,\n");
}

TEST(StudyDocument, SeparatesWhatDependsOnTheClock) {
  const Study study{.name = "fake", .about = "one"};
  const Findings found{.findings = {{"f", 1}}, .timings = {{"t", 2}}};
  auto json = document_of(study, {.study = "fake", .configuration = {{"c", 3}}}, results, found);
  EXPECT_EQ(json["timings"]["results"]["a,1"]["median"], 2.0);
  EXPECT_EQ(json["timings"]["t"], 2);
  EXPECT_EQ(json["results"][1]["ending"], "crashed");
  json.erase("timings");
  EXPECT_EQ(json.dump().find("median"), std::string::npos);
}

class MergeShards : public StudyFiles {
 protected:
  std::string shard(int k, int n, const std::string& out = "shards") const {
    return at(out) + "/study-speed-" + std::to_string(k) + "-of-" + std::to_string(n) + ".jsonl";
  }

  void make(int k, int n) const {
    ASSERT_EQ(say(words("shards", {"--shard", std::to_string(k) + "/" + std::to_string(n)})).code, 0);
  }

  Said merged(std::vector<std::string> files) const {
    std::vector<std::string> all{"merge", "--out", at("merged")};
    all.insert(all.end(), files.begin(), files.end());
    return say(all);
  }
};

TEST_F(MergeShards, EqualsTheUndividedStudyApartFromTimings) {
  std::vector<std::string> files;
  for (const int k : {3, 1, 4, 2}) {
    make(k, 4);
    files.push_back(shard(k, 4));
  }
  EXPECT_EQ(merged(files).code, 0);
  EXPECT_EQ(say(words("whole")).code, 0);
  EXPECT_EQ(document("merged").dump(1), document("whole").dump(1));
}

TEST_F(MergeShards, NamesWhatIsMissingOverlappingOrOfAnotherStudy) {
  make(1, 2);
  make(2, 2);
  make(1, 3);
  const std::string all = text(shard(2, 2));
  put(at("cut"), all.substr(0, all.rfind("{\"key\"")));
  std::string other = all;
  other.replace(other.find("1/240"), 5, "1/250");
  put(at("other"), other);
  put(at("strange"), all + to_line({.key = "stranger"}));

  const auto refusal = [&](std::vector<std::string> files) {
    const Said said = merged(std::move(files));
    EXPECT_EQ(said.code, 2) << said.out;
    return said.err;
  };
  EXPECT_THAT(refusal({shard(1, 2)}), HasSubstr("shard 2/2 is missing"));
  EXPECT_THAT(refusal({shard(1, 2), shard(1, 2)}), HasSubstr("are both shard 1/2"));
  EXPECT_THAT(refusal({shard(1, 2), shard(1, 3)}), AllOf(HasSubstr("1-of-3"), HasSubstr("they overlap")));
  EXPECT_THAT(refusal({shard(1, 2), at("cut")}),
              AllOf(HasSubstr("cut: 1 of 14 results are missing"), HasSubstr("dt=")));
  EXPECT_THAT(refusal({shard(1, 2), at("other")}), HasSubstr("other does not belong to"));
  EXPECT_THAT(refusal({shard(1, 2), at("strange")}), HasSubstr("\"stranger\" is not in shard 2/2"));
  EXPECT_THAT(refusal({shard(1, 2), at("none")}), HasSubstr("none: cannot be read"));
  EXPECT_FALSE(std::filesystem::exists(at("merged") + "/study-speed.json"));
  EXPECT_EQ(merged({shard(2, 2), shard(1, 2)}).code, 0);
}

}  // namespace
}  // namespace plumb::document_test
