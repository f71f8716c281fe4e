#include "reports/study/results_file.h"

#include <gmock/gmock.h>

#include <chrono>
#include <optional>
#include <stdexcept>
#include <thread>

#include "study_files.h"

namespace plumb {
namespace {

using ::testing::HasSubstr;

class Results : public StudyFiles {
 protected:
  ResultsHead head_{.study = "speed",
                    .configuration = {{"dt", {"1/60"}}},
                    .plan = "abc",
                    .shard = {2, 4},
                    .points = 3,
                    .environment = {{"plumb", "0.1.0"}, {"processor", "one"}}};

  static PointResult result(const std::string& key) {
    return {.key = key, .ending = Ending::failed, .reason = "\xff\n\"", .row = {{{"x", 0.1}}, {{"median", 2.5}}}};
  }

  std::string complaint(const std::string& name) const {
    try {
      read_results(at(name));
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(Results, ReadBackAsTheyWereWritten) {
  {
    ResultsFile file = ResultsFile::begin(at("r"), head_);
    const PointResult all[] = {result("a"), result("b")};
    file.add(all);
  }
  const KeptResults kept = read_results(at("r"));
  EXPECT_EQ(kept.head.foreign_to(head_), "");
  EXPECT_EQ(kept.head.shard, head_.shard);
  EXPECT_EQ(kept.head.points, 3u);
  ASSERT_EQ(kept.results.size(), 2u);
  EXPECT_EQ(kept.results.at("b").ending, Ending::failed);
  EXPECT_EQ(kept.results.at("b").row.values.at("x"), 0.1);
  EXPECT_EQ(kept.whole, text(at("r")).size());
}

TEST_F(Results, LoseATornLastLineAndGoOnAfterTheLastWholeOne) {
  {
    ResultsFile file = ResultsFile::begin(at("r"), head_);
    const PointResult one[] = {result("a")};
    file.add(one);
  }
  const std::string whole = text(at("r"));
  put(at("r"), whole + to_line(result("b")).substr(0, 20));
  const KeptResults kept = read_results(at("r"));
  EXPECT_EQ(kept.results.size(), 1u);
  {
    ResultsFile file = ResultsFile::go_on(at("r"), kept);
    const PointResult one[] = {result("c")};
    file.add(one);
  }
  EXPECT_EQ(text(at("r")), whole + to_line(result("c")));
}

TEST_F(Results, AreForeignWhereStudyConfigurationVersionOrPlanDifferButNotTheMachine) {
  ResultsHead other = head_;
  other.environment["processor"] = "two";
  other.shard = {1, 4};
  EXPECT_EQ(head_.foreign_to(other), "");
  other.environment["plumb"] = "0.2.0";
  EXPECT_THAT(head_.foreign_to(other), HasSubstr("plumb \"0.1.0\", not \"0.2.0\""));
  other = head_;
  other.configuration["dt"] = {"1/30"};
  EXPECT_THAT(head_.foreign_to(other), HasSubstr("configuration"));
  other = head_;
  other.study = "model";
  EXPECT_THAT(head_.foreign_to(other), HasSubstr("model"));
  other = head_;
  other.plan = "abd";
  EXPECT_NE(head_.foreign_to(other), "");
}

TEST_F(Results, AreRefusedByNameAndLine) {
  EXPECT_THAT(complaint("none"), HasSubstr("none: cannot be read: No such file"));
  EXPECT_THAT(complaint(""), HasSubstr("Is a directory"));
  put(at("empty"), "");
  EXPECT_THAT(complaint("empty"), HasSubstr("has not even a first line"));
  put(at("other"), "{\"plumb\": 1}\n");
  EXPECT_THAT(complaint("other"), HasSubstr("line 1: not the beginning of a study's results"));
  { ResultsFile::begin(at("twice"), head_); }
  put(at("twice"), text(at("twice")) + to_line(result("a")) + to_line(result("a")));
  EXPECT_THAT(complaint("twice"), HasSubstr("line 3: \"a\" is there twice"));
  { ResultsFile::begin(at("broken"), head_); }
  put(at("broken"), text(at("broken")) + "{\"key\":1\n");
  EXPECT_THAT(complaint("broken"), HasSubstr("line 2"));
}

TEST_F(Results, AreWrittenByOneAtATime) {
  const ResultsFile file = ResultsFile::begin(at("r"), head_);
  EXPECT_THROW(ResultsFile::begin(at("r"), head_), std::invalid_argument);
  EXPECT_NE(text(at("r")), "") << "nor did it cut the other's";
}

// As a process does that a killed run had just begun.
TEST_F(Results, WaitForWhoLetsGoInAMoment) {
  std::optional<ResultsFile> other(ResultsFile::begin(at("r"), head_));
  std::thread letting_go([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    other.reset();
  });
  EXPECT_NO_THROW(ResultsFile::begin(at("r"), head_));
  letting_go.join();
}

TEST_F(Results, TellPlansApartByTheirKeys) {
  const std::vector<Point> a{{.key = "a"}, {.key = "b"}};
  const std::vector<Point> b{{.key = "ab"}};
  EXPECT_EQ(plan_hash(a), plan_hash(a));
  EXPECT_NE(plan_hash(a), plan_hash(b));
}

}  // namespace
}  // namespace plumb
