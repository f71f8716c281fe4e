#include "reports/study/conduct.h"

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>

#include "study_files.h"

namespace plumb {
namespace {

using ::testing::HasSubstr;

class Conduct : public StudyFiles {
 protected:
  std::string results(const std::string& out) const { return at(out) + "/study-speed.jsonl"; }

  static std::ptrdiff_t lines(const std::string& path) {
    const std::string all = text(path);
    return std::count(all.begin(), all.end(), '\n');
  }

  // Carries out a study in a process of its own until its first points are kept, and then sends it a signal. Returns
  // how it ended.
  int interrupted_by(int signal, const std::string& out) const {
    const pid_t process = fork();
    if (process == 0) _exit(program(words(out)));
    while (lines(results(out)) < 2) usleep(200);
    kill(process, signal);
    int status = 0;
    waitpid(process, &status, 0);
    return status;
  }
};

constexpr int points = 28;

TEST_F(Conduct, GoesOnAfterKill9AsIfNothingHadHappened) {
  ASSERT_TRUE(WIFSIGNALED(interrupted_by(SIGKILL, "killed")));
  const auto kept = lines(results("killed")) - 1;
  ASSERT_LT(kept, points) << "it was killed in the middle";
  put(results("killed"), text(results("killed")) + "{\"key\":\"torn");
  const Said said = say(words("killed", {"--resume"}));
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_EQ(lines(results("killed")) - 1, points) << "nothing lost, nothing twice";
  EXPECT_EQ(say(words("calm", {"--jobs", "1"})).code, 0);
  EXPECT_EQ(document("killed").dump(1), document("calm").dump(1));
}

TEST_F(Conduct, SaysHowToGoOnWhenInterrupted) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string out = "s" + std::to_string(signal);
    const int status = interrupted_by(signal, out);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
    EXPECT_LT(lines(results(out)) - 1, points);
    EXPECT_EQ(say(words(out, {"--resume"})).code, 0);
    EXPECT_EQ(document(out)["points"].size(), static_cast<std::size_t>(points));
  }
}

TEST_F(Conduct, DoesNotDropAnInterruptedStudyUnasked) {
  say(words("out"));
  const std::string all = text(results("out"));
  put(results("out"), all.substr(0, all.size() / 2));
  const Said said = say(words("out"));
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("--resume goes on"));
  EXPECT_EQ(text(results("out")), all.substr(0, all.size() / 2));
  EXPECT_EQ(say(words("out", {"--fresh"})).code, 0);
  EXPECT_EQ(say(words("out")).code, 0) << "one that is complete is made anew";
  EXPECT_EQ(say(words("out", {"--fresh", "--resume"})).code, 2);
}

TEST_F(Conduct, RefusesToGoOnWithAnotherStudysResults) {
  say(words("out"));
  std::vector<std::string> other = words("out", {"--resume"});
  *std::find(other.begin(), other.end(), "1/240") = "1/200";
  const Said said = say(other);
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("study-speed.jsonl is of the configuration"));
  EXPECT_EQ(lines(results("out")) - 1, points);
}

TEST_F(Conduct, TakesItsShardFromASlurmArray) {
  for (const auto& [name, value] : {std::pair("SLURM_ARRAY_TASK_ID", "1"), std::pair("SLURM_ARRAY_TASK_COUNT", "4"),
                                    std::pair("SLURM_ARRAY_TASK_MIN", "0"), std::pair("SLURM_ARRAY_TASK_MAX", "3")}) {
    setenv(name, value, 1);
  }
  EXPECT_EQ(say(words("out")).code, 0);
  EXPECT_EQ(lines(at("out") + "/study-speed-2-of-4.jsonl") - 1, points / 4);
  EXPECT_EQ(say(words("own", {"--shard", "1/1", "--resume"})).code, 0) << "nothing to go on with is no error";
  EXPECT_EQ(lines(results("own")) - 1, points);
  for (const char* name :
       {"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_MAX"}) {
    unsetenv(name);
  }
}

TEST_F(Conduct, ExitsWith2ForWhatItDoesNotTake) {
  EXPECT_EQ(say({"study", "speed", "--shard", "5/4", "--out", at("out")}).code, 2);
  EXPECT_EQ(say({"study", "spede"}).code, 2);
  EXPECT_EQ(say({"study"}).code, 2);
  EXPECT_EQ(say({"study", "speed", "--dt", "0", "--out", at("out")}).code, 2);
  EXPECT_EQ(say({"study", "speed", "--scenarios", "sprin", "--out", at("out")}).code, 2);
  EXPECT_EQ(say({"study", "speed", "--out", "/dev/null/out"}).code, 2);
  EXPECT_FALSE(std::filesystem::exists(at("out")));
  EXPECT_THAT(say({"study", "speed", "--scenario", "spring"}).err, HasSubstr("did you mean \"--scenarios\"?"));
}

}  // namespace
}  // namespace plumb
