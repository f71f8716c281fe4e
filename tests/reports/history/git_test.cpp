#include "reports/history/git.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include "sample.h"

namespace plumb {
namespace {

// In a repository of its own with one commit.
class Git : public InFolder {
 protected:
  void SetUp() override {
    if (std::system("git --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "git is not installed";
    std::filesystem::current_path(place(""));
    ASSERT_EQ(
        std::system(
            "git init -q . && echo one >file && git add file && "
            "GIT_COMMITTER_DATE='2026-11-21T10:06:10+01:00' git -c user.name=n -c user.email=e commit -q -m one && "
            "git -c user.name=n -c user.email=e tag -a v1 -m tagged"),
        0);
  }
  ~Git() override { std::filesystem::current_path(before_); }

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
};

TEST_F(Git, TellsTheCommitAndItsMoment) {
  const auto head = find_commit("");
  ASSERT_TRUE(head);
  EXPECT_EQ(head->hash.size(), 40u);
  EXPECT_EQ(head->at, "2026-11-21T09:06:10Z");
  const auto tagged = find_commit("v1");
  ASSERT_TRUE(tagged);
  EXPECT_EQ(tagged->hash, head->hash);
}

TEST_F(Git, TellsWhatIsNotCommitted) {
  put("file", "two");
  EXPECT_THAT(find_commit("")->hash, ::testing::EndsWith("-dirty"));
  EXPECT_THAT(find_commit("HEAD")->hash, ::testing::Not(::testing::EndsWith("-dirty")));
}

TEST_F(Git, KnowsNoOtherRevision) {
  EXPECT_FALSE(find_commit("no-such-thing"));
  EXPECT_FALSE(find_commit("--all"));
}

}  // namespace
}  // namespace plumb
