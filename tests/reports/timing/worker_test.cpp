#include "reports/timing/worker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace plumb::worker_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::SizeIs;
using Json = nlohmann::ordered_json;

class Still : public Simulation {
 public:
  void step(double) override {
    for (int i = 0; i < 1000; ++i) work_ = work_ + i;
  }
  void read(std::span<BodyState>) const override {}

 private:
  volatile int work_ = 0;
};

FreshSimulation read_still(const std::string& scene, const std::string& engine) {
  if (scene != "scene") throw std::invalid_argument("this is no scene");
  if (engine != "still") throw std::invalid_argument("there is no engine " + engine);
  return [] { return std::make_unique<Still>(); };
}

std::vector<Json> answers_to(const std::vector<Json>& requests) {
  std::string text;
  for (const Json& request : requests) text += request.dump() + "\n";
  std::istringstream in(text);
  std::ostringstream out;
  serve_timing(in, out, read_still);
  std::istringstream lines(out.str());
  std::vector<Json> answers;
  for (std::string line; std::getline(lines, line);) answers.push_back(Json::parse(line));
  return answers;
}

Json scene_request(const char* scene = "scene", const char* engine = "still") {
  return {{"scene", scene}, {"engine", engine}, {"dt", 1.0 / 60}};
}

Json run_request(int runs, int steps, int chunk, double patience = 100) {
  return {{"runs", runs}, {"steps", steps}, {"chunk", chunk}, {"patience", patience}};
}

TEST(ServeTiming, GreetsWithItsVersionAndMachine) {
  const auto answers = answers_to({});
  ASSERT_THAT(answers, SizeIs(1));
  EXPECT_EQ(answers[0]["pace"], worker_version);
  EXPECT_TRUE(answers[0]["facts"].contains("processor"));
  EXPECT_TRUE(answers[0]["uncounted"].is_string());
}

TEST(ServeTiming, GivesTimesByChunk) {
  const auto answers = answers_to({scene_request(), run_request(2, 50, 20)});
  ASSERT_THAT(answers, SizeIs(3));
  EXPECT_EQ(answers[1], Json::object());
  EXPECT_THAT(answers[2]["cpu"], SizeIs(3));  // 20, 20 and 10 steps
  EXPECT_THAT(answers[2]["wall"], SizeIs(3));
  for (const double time : answers[2]["cpu"]) EXPECT_GT(time, 0);
  EXPECT_EQ(answers[2]["count"].is_null(), !answers[0]["uncounted"].get<std::string>().empty());
}

TEST(ServeTiming, EndsARunThatTakesLongerThanItsPatience) {
  EXPECT_THAT(answers_to({scene_request(), run_request(3, 50, 10, 1e-12)})[2]["cpu"], SizeIs(1));
}

TEST(ServeTiming, RefusesWhatItCannotDoAndGoesOn) {
  const auto answers = answers_to({run_request(1, 1, 1),
                                   scene_request("scene", "stil"),
                                   {{"scene", "{"}},
                                   run_request(0, 1, 1),
                                   scene_request(),
                                   run_request(1, 5, 5)});
  ASSERT_THAT(answers, SizeIs(7));
  EXPECT_THAT(answers[1]["refused"].get<std::string>(), HasSubstr("no scene to step"));
  EXPECT_EQ(answers[2]["refused"], "there is no engine stil");
  EXPECT_TRUE(answers[3].contains("refused"));
  EXPECT_TRUE(answers[4].contains("refused"));
  EXPECT_EQ(answers[5], Json::object());
  EXPECT_THAT(answers[6]["cpu"], SizeIs(1));
}

// Workers that are shell scripts.
class TimingWorkerTest : public testing::Test {
 protected:
  TimingWorkerTest() { fs::create_directories(folder_); }
  ~TimingWorkerTest() override { fs::remove_all(folder_); }

  fs::path script(const std::string& text) {
    const fs::path path = folder_ / "program";
    std::ofstream(path) << "#!/bin/sh\n" << text;
    fs::permissions(path, fs::perms::owner_all);
    return path;
  }
  // Greets as it should before it runs the text.
  fs::path worker(const std::string& text) {
    return script("echo '{\"pace\":1,\"facts\":{},\"uncounted\":\"\"}'\n" + text);
  }

  fs::path folder_ = fs::temp_directory_path() / ("plumb-worker-" + std::to_string(getpid()));
};

std::string refusal(const fs::path& program) {
  try {
    const TimingWorker started(program);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

std::string failure(const fs::path& program, double patience = 20) {
  TimingWorker started(program, patience);
  try {
    started.ask({{"runs", 1}});
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST_F(TimingWorkerTest, NamesAProgramThatCannotBeRun) {
  EXPECT_THAT(refusal(folder_ / "missing"), testing::AllOf(HasSubstr("missing"), HasSubstr("cannot be run")));
}

TEST_F(TimingWorkerTest, NamesAProgramThatIsNoWorker) {
  EXPECT_THAT(refusal(script("echo 'plumb: unknown command \"pace\"' >&2\nexit 2\n")), HasSubstr("older than"));
  EXPECT_THAT(refusal(script("echo hello\n")), HasSubstr("older than"));
  EXPECT_THAT(refusal(script("echo '{\"pace\":99,\"facts\":{},\"uncounted\":\"\"}'\n")), HasSubstr("version 99"));
}

TEST_F(TimingWorkerTest, StartsAnOlderBuildByTheOldName) {
  EXPECT_EQ(refusal(worker("[ \"$1\" = timing-worker ]\n")), "");
  const std::string greeting = "echo '{\"pace\":1,\"facts\":{\"old\":\"yes\"},\"uncounted\":\"\"}'\n";
  const TimingWorker old(script("[ \"$1\" = pace ] || exit 2\n" + greeting));
  EXPECT_EQ(fact(old.facts(), "old"), "yes");
}

TEST_F(TimingWorkerTest, NoticesInvalidAnswers) {
  EXPECT_THAT(failure(worker("read x; echo 12\n")), HasSubstr("\"12\""));
  EXPECT_THAT(failure(worker("read x; echo '{\"cpu\":['\n")), HasSubstr("no JSON object"));
  EXPECT_THAT(failure(worker("read x; exit 1\n")), HasSubstr("ended without an answer"));
  EXPECT_THAT(failure(worker("read x; kill -9 $$\n")), HasSubstr("ended without an answer"));
  EXPECT_THAT(failure(worker("sleep 20\n"), 0.2), HasSubstr("took more than 0.2 s"));
  EXPECT_THAT(failure(worker("read x; yes | tr -d '\\n'\n")), HasSubstr("without end"));
}

}  // namespace
}  // namespace plumb::worker_test
