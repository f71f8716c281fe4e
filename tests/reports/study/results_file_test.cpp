#include "reports/study/results_file.h"

#include <gmock/gmock.h>

#include <chrono>
#include <optional>
#include <stdexcept>
#include <thread>

#include "study_files.h"

namespace plumb::results_file_test {
namespace {

using ::testing::HasSubstr;

class Results : public StudyFiles {
 protected:
  ResultsHead head_{.study = "speed",
                    .configuration = {{"dt", {"1/60"}}},
                    .plan = "abc",
                    .shard = {2, 4},
                    .jobs = 3,
                    .environment = {{"plumb", "0.1.0"}, {"processor", "one"}}};

  static JobResult result(const std::string& key) {
    return {.key = key, .ending = Ending::failed, .reason = "\xff\n\"", .output = {{{"x", 0.1}}, {{"median", 2.5}}}};
  }

  std::string error_of(const std::string& name) const {
    try {
      read_results(at(name));
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(Results, AreReadAsTheyWereWritten) {
  {
    ResultsFile file = ResultsFile::create(at("r"), head_);
    const JobResult all[] = {result("a"), result("b")};
    file.add(all);
  }
  const StoredResults stored = read_results(at("r"));
  EXPECT_EQ(stored.head.difference_from(head_), "");
  EXPECT_EQ(stored.head.shard, head_.shard);
  EXPECT_EQ(stored.head.jobs, 3u);
  ASSERT_EQ(stored.results.size(), 2u);
  EXPECT_EQ(stored.results.at("b").ending, Ending::failed);
  EXPECT_EQ(stored.results.at("b").output.values.at("x"), 0.1);
  EXPECT_EQ(stored.bytes, text(at("r")).size());
}

TEST_F(Results, DropADamagedLastLineAndAppendAfterTheLastCompleteOne) {
  {
    ResultsFile file = ResultsFile::create(at("r"), head_);
    const JobResult one[] = {result("a")};
    file.add(one);
  }
  const std::string whole = text(at("r"));
  put(at("r"), whole + to_line(result("b")).substr(0, 20));
  const StoredResults stored = read_results(at("r"));
  EXPECT_EQ(stored.results.size(), 1u);
  {
    ResultsFile file = ResultsFile::append(at("r"), stored);
    const JobResult one[] = {result("c")};
    file.add(one);
  }
  EXPECT_EQ(text(at("r")), whole + to_line(result("c")));
}

TEST_F(Results, DifferByStudyConfigurationVersionOrPlanButNotByMachine) {
  ResultsHead other = head_;
  other.environment["processor"] = "two";
  other.shard = {1, 4};
  EXPECT_EQ(head_.difference_from(other), "");
  other.environment["plumb"] = "0.2.0";
  EXPECT_THAT(head_.difference_from(other), HasSubstr("plumb \"0.1.0\", not \"0.2.0\""));
  other = head_;
  other.configuration["dt"] = {"1/30"};
  EXPECT_THAT(head_.difference_from(other), HasSubstr("configuration"));
  other = head_;
  other.study = "model";
  EXPECT_THAT(head_.difference_from(other), HasSubstr("model"));
  other = head_;
  other.plan = "abd";
  EXPECT_NE(head_.difference_from(other), "");
}

TEST_F(Results, AreRefusedWithFileAndLine) {
  EXPECT_THAT(error_of("none"), HasSubstr("none: cannot be read: No such file"));
  EXPECT_THAT(error_of(""), HasSubstr("Is a directory"));
  put(at("empty"), "");
  EXPECT_THAT(error_of("empty"), HasSubstr("has no complete line"));
  put(at("other"), "{\"plumb\": 1}\n");
  EXPECT_THAT(error_of("other"), HasSubstr("line 1: not the head of a study's results"));
  put(at("old"), "{\"plumb_study\": 1, \"study\": \"speed\", \"points\": 3}\n");
  EXPECT_THAT(error_of("old"), HasSubstr("has format 1, this plumb reads 2: run the study again with --fresh"));
  { ResultsFile::create(at("twice"), head_); }
  put(at("twice"), text(at("twice")) + to_line(result("a")) + to_line(result("a")));
  EXPECT_THAT(error_of("twice"), HasSubstr("line 3: \"a\" occurs twice"));
  { ResultsFile::create(at("broken"), head_); }
  put(at("broken"), text(at("broken")) + "{\"key\":1\n");
  EXPECT_THAT(error_of("broken"), HasSubstr("line 2"));
}

TEST_F(Results, AreWrittenByOneProcessAtATime) {
  const ResultsFile file = ResultsFile::create(at("r"), head_);
  EXPECT_THROW(ResultsFile::create(at("r"), head_), std::invalid_argument);
  EXPECT_NE(text(at("r")), "") << "the file of the other process is unchanged";
}

// A child process of a run that was just killed may hold the file for a moment.
TEST_F(Results, WaitForAProcessThatReleasesTheFileSoon) {
  std::optional<ResultsFile> other(ResultsFile::create(at("r"), head_));
  std::thread release([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    other.reset();
  });
  EXPECT_NO_THROW(ResultsFile::create(at("r"), head_));
  release.join();
}

TEST_F(Results, HashPlansByTheirKeys) {
  const std::vector<Job> a{{.key = "a"}, {.key = "b"}};
  const std::vector<Job> b{{.key = "ab"}};
  EXPECT_EQ(plan_hash(a), plan_hash(a));
  EXPECT_NE(plan_hash(a), plan_hash(b));
}

}  // namespace
}  // namespace plumb::results_file_test
