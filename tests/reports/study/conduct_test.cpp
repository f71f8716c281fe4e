#include "reports/study/conduct.h"

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <stdexcept>

#include "reports/study/job.h"
#include "scenarios/catalog.h"
#include "study_files.h"

namespace plumb::conduct_test {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::HasSubstr;

class Conduct : public StudyFiles {
 protected:
  std::string results(const std::string& out) const { return at(out) + "/study-speed.jsonl"; }

  static std::ptrdiff_t lines(const std::string& path) {
    const std::string all = text(path);
    return std::count(all.begin(), all.end(), '\n');
  }

  // Runs a study in a child process until its first results are in the file, then sends it a signal. Returns the exit
  // status.
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

constexpr int jobs = 28;

TEST_F(Conduct, ResumesAfterKill9AsIfNothingHadHappened) {
  ASSERT_TRUE(WIFSIGNALED(interrupted_by(SIGKILL, "killed")));
  const auto kept = lines(results("killed")) - 1;
  ASSERT_LT(kept, jobs) << "it was killed in the middle";
  put(results("killed"), text(results("killed")) + "{\"key\":\"cut off");
  const Said said = say(words("killed", {"--resume"}));
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_EQ(lines(results("killed")) - 1, jobs) << "nothing lost, nothing twice";
  EXPECT_EQ(say(words("calm", {"--jobs", "1"})).code, 0);
  EXPECT_EQ(document("killed").dump(1), document("calm").dump(1));
}

TEST_F(Conduct, SaysHowToResumeWhenInterrupted) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string out = "s" + std::to_string(signal);
    const int status = interrupted_by(signal, out);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
    EXPECT_LT(lines(results(out)) - 1, jobs);
    EXPECT_EQ(say(words(out, {"--resume"})).code, 0);
    EXPECT_EQ(document(out)["results"].size(), static_cast<std::size_t>(jobs));
  }
}

TEST_F(Conduct, KeepsAnInterruptedStudyUnlessToldOtherwise) {
  say(words("out"));
  const std::string all = text(results("out"));
  put(results("out"), all.substr(0, all.size() / 2));
  const Said said = say(words("out"));
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("--resume continues it"));
  EXPECT_EQ(text(results("out")), all.substr(0, all.size() / 2));
  EXPECT_EQ(say(words("out", {"--fresh"})).code, 0);
  EXPECT_EQ(say(words("out")).code, 0) << "a complete study starts over";
  EXPECT_EQ(say(words("out", {"--fresh", "--resume"})).code, 2);
}

TEST_F(Conduct, RefusesToResumeFromAnotherStudysResults) {
  say(words("out"));
  std::vector<std::string> other = words("out", {"--resume"});
  *std::find(other.begin(), other.end(), "1/240") = "1/200";
  const Said said = say(other);
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("study-speed.jsonl has the configuration"));
  EXPECT_EQ(lines(results("out")) - 1, jobs);
}

TEST_F(Conduct, TakesItsShardFromASlurmArray) {
  for (const auto& [name, value] : {std::pair("SLURM_ARRAY_TASK_ID", "1"), std::pair("SLURM_ARRAY_TASK_COUNT", "4"),
                                    std::pair("SLURM_ARRAY_TASK_MIN", "0"), std::pair("SLURM_ARRAY_TASK_MAX", "3")}) {
    setenv(name, value, 1);
  }
  EXPECT_EQ(say(words("out")).code, 0);
  EXPECT_EQ(lines(at("out") + "/study-speed-2-of-4.jsonl") - 1, jobs / 4);
  EXPECT_EQ(say(words("own", {"--shard", "1/1", "--resume"})).code, 0) << "nothing to resume is no error";
  EXPECT_EQ(lines(results("own")) - 1, jobs);
  for (const char* name :
       {"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_MAX"}) {
    unsetenv(name);
  }
}

TEST_F(Conduct, ExitsWith2ForMistakesOfTheUser) {
  EXPECT_EQ(say({"study", "speed", "--shard", "5/4", "--out", at("out")}).code, 2);
  EXPECT_EQ(say({"study", "spede"}).code, 2);
  EXPECT_EQ(say({"study"}).code, 2);
  EXPECT_EQ(say({"study", "speed", "--dt", "0", "--out", at("out")}).code, 2);
  EXPECT_EQ(say({"study", "speed", "--scenarios", "sprin", "--out", at("out")}).code, 2);
  EXPECT_EQ(say({"study", "speed", "--out", "/dev/null/out"}).code, 2);
  EXPECT_FALSE(std::filesystem::exists(at("out")));
  EXPECT_THAT(say({"study", "speed", "--scenario", "spring"}).err, HasSubstr("did you mean \"--scenarios\"?"));
}

TEST_F(Conduct, ExitsWith1IfJobsRunOutOfTime) {
  const Said said = say(words("out", {"--time-limit", "0.001"}));
  EXPECT_EQ(said.code, 1);
  EXPECT_THAT(said.err, HasSubstr("took more than 0.001 s, and the study does not know their results: --time-limit"));
  EXPECT_EQ(document("out")["results"].size(), static_cast<std::size_t>(jobs)) << "it is written all the same";
}

// A study that squares numbers and adds them up.
Study squares() {
  return {.name = "squares",
          .about = "The sum of squares",
          .examples = "",
          .attach = [](CLI::App& app) -> std::function<Json()> {
            const auto numbers = std::make_shared<std::vector<int>>(std::vector<int>{1, 2, 3, 4});
            app.add_option("--numbers", *numbers);
            return [numbers] { return Json{{"numbers", *numbers}}; };
          },
          .plan = [](const Json& configuration) -> StudyPlan {
            std::vector<Job> list;
            for (const int number : configuration.at("numbers")) {
              list.push_back({.key = std::to_string(number), .run = [number] {
                                JobOutput output;
                                output.values["square"] = number * number;
                                return output;
                              }});
            }
            return {list, [](const std::vector<JobResult>& results) {
                      int sum = 0;
                      for (const JobResult& result : results) sum += result.output.values.at("square").get<int>();
                      Findings found;
                      found.findings["sum"] = sum;
                      return found;
                    }};
          },
          .summary = [](const std::vector<std::string>&) -> std::optional<std::vector<std::string>> {
            return {{"--numbers", "2", "3"}};
          }};
}

TEST_F(Conduct, ExitsWith1IfTheFindingsShowWhatMustNotBe) {
  for (const bool failed : {false, true}) {
    Study study = squares();
    study.plan = [plan = study.plan, failed](const Json& configuration) {
      StudyPlan with = plan(configuration);
      with.conclude = [conclude = with.conclude, failed](const std::vector<JobResult>& results) {
        Findings found = conclude(results);
        found.failed = failed;
        return found;
      };
      return with;
    };
    EXPECT_EQ(conduct(study, {{"numbers", {1, 2}}}, {.out = at("out")}), failed ? 1 : 0);
  }
}

TEST(StudySummary, RunsAShortStudyAndReportsEachJob) {
  std::vector<std::string> progress;
  const Json document = summary_document(
      squares(), {"--numbers", "2", "3"}, 1, [&](const std::string& key, std::size_t done, std::size_t of) {
        progress.push_back(key + " " + std::to_string(done) + "/" + std::to_string(of));
      });
  EXPECT_THAT(progress, testing::ElementsAre("2 1/2", "3 2/2"));
  EXPECT_EQ(document.at("study"), "squares");
  EXPECT_EQ(document.at("command"), "plumb study squares --numbers 2 3");
  EXPECT_EQ(document.at("configuration").at("numbers"), Json({2, 3}));
  EXPECT_EQ(document.at("findings").at("sum"), 13);
  EXPECT_EQ(document.at("results").size(), 2U);
}

TEST(StudySummary, RefusesOptionsThatTheStudyDoesNotHave) {
  const auto silent = [](const std::string&, std::size_t, std::size_t) {};
  EXPECT_THROW(summary_document(squares(), {"--nombres", "2"}, 1, silent), std::logic_error);
}

TEST(StudySummary, OfEveryStudyIsOfTheReportsEngines) {
  const std::vector<std::string> some{"impulse", "box2d:velocity=4"};
  for (const Study* study : Catalog<Study>::all()) {
    if (!study->summary) continue;
    const auto options = study->summary(some);
    ASSERT_TRUE(options) << study->name;
    CLI::App app;
    const auto configuration = study->attach(app);  // owns what the options write to
    EXPECT_NO_THROW(app.parse(std::vector<std::string>(options->rbegin(), options->rend()))) << study->name;
    const bool one_engine = study->name == "model";
    EXPECT_THAT(configuration().dump(), HasSubstr("\"impulse\"")) << study->name;
    EXPECT_EQ(configuration().dump().find("\"box2d:velocity=4\"") == std::string::npos, one_engine) << study->name;
    EXPECT_THAT(*study->summary({}), testing::Not(testing::Contains("--engine"))) << study->name;
  }
  EXPECT_FALSE(Catalog<Study>::find("model")->summary({"box2d"})) << "it can't leave features out";
}

}  // namespace
}  // namespace plumb::conduct_test
