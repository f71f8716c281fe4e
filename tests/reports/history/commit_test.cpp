#include "reports/history/commit.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <stdexcept>

#include "sample.h"

namespace plumb::commit_test {
namespace {

// A repository with one commit.
class FindCommit : public InFolder {
 protected:
  void SetUp() override {
    if (std::system("git --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "git is not installed";
    std::filesystem::current_path(path(""));
    ASSERT_EQ(
        std::system(
            "git init -q . && echo one >file && git add file && "
            "GIT_COMMITTER_DATE='2026-11-21T10:06:10+01:00' git -c user.name=n -c user.email=e commit -q -m one && "
            "git -c user.name=n -c user.email=e tag -a v1 -m tagged"),
        0);
  }
  ~FindCommit() override { std::filesystem::current_path(before_); }

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
};

TEST_F(FindCommit, ReturnsTheHashAndTheTime) {
  const auto head = find_commit("");
  ASSERT_TRUE(head);
  EXPECT_EQ(head->hash.size(), 40u);
  EXPECT_EQ(head->at, "2026-11-21T09:06:10Z");
  const auto tagged = find_commit("v1");
  ASSERT_TRUE(tagged);
  EXPECT_EQ(tagged->hash, head->hash);
}

TEST_F(FindCommit, MarksUncommittedChanges) {
  put("file", "two");
  EXPECT_THAT(find_commit("")->hash, ::testing::EndsWith("-dirty"));
  EXPECT_THAT(find_commit("HEAD")->hash, ::testing::Not(::testing::EndsWith("-dirty")));
}

TEST_F(FindCommit, ReturnsNulloptForAnUnknownRevision) {
  EXPECT_FALSE(find_commit("no-such-thing"));
  EXPECT_FALSE(find_commit("--all"));
}

TEST(Utc, ConvertsDatesAndTimes) {
  EXPECT_EQ(utc("2026-11-21"), "2026-11-21T00:00:00Z");
  EXPECT_EQ(utc("2026-11-21T09:06:10Z"), "2026-11-21T09:06:10Z");
  EXPECT_EQ(utc("2026-11-21T10:06:10+01:00"), "2026-11-21T09:06:10Z");
  EXPECT_EQ(utc("2024-02-28T22:30:00-05:30"), "2024-02-29T04:00:00Z");
  EXPECT_EQ(utc("2026-01-01T00:30:00+01:00"), "2025-12-31T23:30:00Z");
}

TEST(DaysBefore, CountsAcrossMonths) {
  EXPECT_EQ(days_before("2026-11-21T09:06:10Z", 7), "2026-11-14T09:06:10Z");
  EXPECT_EQ(days_before("2024-03-01T00:00:00Z", 1), "2024-02-29T00:00:00Z");
}

TEST(Utc, RefusesOtherText) {
  for (const char* text : {"", "now", "2026-13-01", "2026-02-29", "2026-11-21T09:06:10", "2026-11-21T24:00:00Z",
                           "2026-11-21T09:06:10+0100", "2026-11-21 09:06:10Z", "20261121", "2026-1-1"}) {
    EXPECT_THROW(utc(text), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace plumb::commit_test
