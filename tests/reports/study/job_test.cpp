#include "reports/study/job.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <stdexcept>

namespace plumb::job_test {
namespace {

TEST(Shard, IsReadAsKOfN) {
  EXPECT_EQ(parse_shard("2/4"), (Shard{2, 4}));
  EXPECT_EQ(parse_shard("1/1").name(), "1/1");
  for (const char* wrong : {"", "2", "0/4", "5/4", "1/0", "-1/4", "a/b", "1/4 ", "1/4/2", "1.5/4"}) {
    EXPECT_THROW(parse_shard(wrong), std::invalid_argument) << wrong;
  }
}

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

}  // namespace
}  // namespace plumb::job_test
