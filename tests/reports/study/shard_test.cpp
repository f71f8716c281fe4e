#include "reports/study/shard.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "reports/study/runner.h"
#include "study_files.h"

namespace plumb {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

EnvironmentLookup environment(const std::map<std::string, std::string>& variables) {
  return [variables](const char* name) {
    const auto found = variables.find(name);
    return found == variables.end() ? nullptr : found->second.c_str();
  };
}

std::map<std::string, std::string> array(int id, int count, int first, int step = 1) {
  return {{"SLURM_ARRAY_TASK_ID", std::to_string(id)},
          {"SLURM_ARRAY_TASK_COUNT", std::to_string(count)},
          {"SLURM_ARRAY_TASK_MIN", std::to_string(first)},
          {"SLURM_ARRAY_TASK_MAX", std::to_string(first + (count - 1) * step)},
          {"SLURM_ARRAY_TASK_STEP", std::to_string(step)}};
}

TEST(Shard, IsASlurmArraysTaskWhereverItsNumbersStart) {
  EXPECT_FALSE(slurm_shard(environment({})));
  for (const int first : {0, 1, 7}) {
    EXPECT_EQ(slurm_shard(environment(array(first, 4, first))), (Shard{1, 4})) << first;
    EXPECT_EQ(slurm_shard(environment(array(first + 3, 4, first))), (Shard{4, 4})) << first;
  }
  EXPECT_EQ(slurm_shard(environment(array(4, 4, 0, 2))), (Shard{3, 4})) << "--array=0-6:2";
}

TEST(Shard, RefusesAnArrayWithoutAnUnambiguousIndex) {
  auto gaps = array(3, 3, 1);
  gaps["SLURM_ARRAY_TASK_MAX"] = "7";  // --array=1,3,7
  EXPECT_THROW(slurm_shard(environment(gaps)), std::invalid_argument);
  auto lost = array(1, 4, 1);
  lost.erase("SLURM_ARRAY_TASK_COUNT");
  EXPECT_THROW(slurm_shard(environment(lost)), std::invalid_argument);
}

TEST(Shard, HasEachUnitOnceAndWholeGroups) {
  std::vector<Job> jobs;
  for (int i = 0; i < 17; ++i) {
    const std::string number = std::to_string(i);
    jobs.push_back({.key = number, .group = i < 9 ? "group " + std::to_string(i / 3) : ""});
  }
  const auto units = units_of(jobs);
  ASSERT_EQ(units.size(), 3u + 8u);
  EXPECT_EQ(units[1].size(), 3u);
  std::multiset<std::string> taken;
  for (int k = 1; k <= 4; ++k) {
    for (const auto& unit : units_in({k, 4}, units)) {
      for (const Job& job : unit) taken.insert(job.key);
    }
  }
  EXPECT_EQ(taken.size(), jobs.size());
  EXPECT_EQ(std::set<std::string>(taken.begin(), taken.end()).size(), jobs.size());
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
}  // namespace plumb
