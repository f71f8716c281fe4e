#include "reports/timing/side_by_side.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <set>
#include <stdexcept>

#include "reports/run/selection.h"
#include "scenarios/scene/scene_json.h"

namespace plumb::side_by_side_test {
namespace {

namespace fs = std::filesystem;
using testing::SizeIs;

const fs::path plumb_program = PLUMB_PROGRAM;

// Each test has its own folder for temporary files.
class ProgramCopyTest : public testing::Test {
 protected:
  ProgramCopyTest() {
    fs::create_directories(folder_);
    setenv("TMPDIR", folder_.c_str(), 1);
    std::ofstream(program_) << "a program";
  }
  ~ProgramCopyTest() override {
    setenv("TMPDIR", usual_.c_str(), 1);
    fs::remove_all(folder_);
  }

  std::set<fs::path> folders() const {
    std::set<fs::path> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
      if (entry.is_directory()) found.insert(entry.path());
    }
    return found;
  }

  fs::path usual_ = fs::temp_directory_path();
  fs::path folder_ = usual_ / ("plumb-copies-" + std::to_string(getpid()));
  fs::path program_ = folder_ / "program";
};

TEST_F(ProgramCopyTest, IsRemovedInTheEnd) {
  {
    const ProgramCopy copy(program_);
    EXPECT_EQ(fs::file_size(copy.path()), fs::file_size(program_));
  }
  EXPECT_TRUE(folders().empty());
}

TEST_F(ProgramCopyTest, NamesAProgramThatCannotBeCopiedAndLeavesNothing) {
  EXPECT_THROW(ProgramCopy(folder_ / "missing"), std::invalid_argument);
  EXPECT_TRUE(folders().empty());
}

TEST_F(ProgramCopyTest, OfAKilledProcessIsRemovedWithTheNextCopy) {
  const pid_t process = fork();
  if (process == 0) {
    const ProgramCopy copy(program_);
    raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(process, &status, 0), process);
  ASSERT_TRUE(WIFSIGNALED(status));
  ASSERT_EQ(folders().size(), 1U);
  const ProgramCopy next(program_);
  EXPECT_EQ(folders(), std::set{next.path().parent_path()});
}

TEST_F(ProgramCopyTest, StaysWhileItsProcessLives) {
  const ProgramCopy first(program_);
  const ProgramCopy second(program_);
  EXPECT_EQ(folders(), (std::set{first.path().parent_path(), second.path().parent_path()}));
}

// Workers that are shell scripts.
class SideBySideTest : public testing::Test {
 protected:
  SideBySideTest() { fs::create_directories(folder_); }
  ~SideBySideTest() override { fs::remove_all(folder_); }

  // Greets as it should before it runs the text.
  fs::path worker(const std::string& text) {
    const fs::path path = folder_ / "program";
    std::ofstream(path) << "#!/bin/sh\necho '{\"pace\":1,\"facts\":{},\"uncounted\":\"\"}'\n" << text;
    fs::permissions(path, fs::perms::owner_all);
    return path;
  }

  fs::path folder_ = fs::temp_directory_path() / ("plumb-sides-" + std::to_string(getpid()));
};

SideBySide sides(const fs::path& before, const char* words = "bounce:e=0.5") {
  constexpr double dt = 1.0 / 60;
  std::vector<TimedScene> scenes;
  for (const Case& one : parse_cases(words)) {
    scenes.push_back({.name = one.scenario->name + ":" + one.variant,
                      .scene = write_scene({*one.scene, {}}),
                      .steps = steps_in(one.scene->duration, dt)});
  }
  return {before, plumb_program, scenes, "impulse", dt};
}

TEST_F(SideBySideTest, GivesNoResultForInvalidAnswers) {
  for (const char* const answer :
       {"{\"refused\":\"not today\"}", "{}", "{\"cpu\":[]}", "{\"cpu\":[-1]}", "{\"cpu\":\"long\"}"}) {
    const fs::path before = worker(std::string("read x; echo '{}'; while read x; do echo '") + answer + "'; done\n");
    const auto pairs = sides(before).measure(std::vector<std::size_t>{0}, 2, [](const auto&) {});
    ASSERT_THAT(pairs, SizeIs(1));
    EXPECT_NE(pairs[0].no_result, "") << answer;
    EXPECT_TRUE(pairs[0].now.cpu.empty());
  }
}

TEST_F(SideBySideTest, TimesTwoPrograms) {
  std::vector<std::string> names;
  const SideBySide both = sides(plumb_program, "bounce");
  const auto pairs = both.measure(std::vector<std::size_t>{0, 2}, 2, [&](const auto& name) { names.push_back(name); });
  ASSERT_THAT(pairs, SizeIs(2));
  EXPECT_THAT(names, testing::ElementsAre("bounce:e=0.5", "bounce:e=1", "bounce:e=0.5", "bounce:e=1"));
  for (const TimedPair& pair : pairs) {
    EXPECT_EQ(pair.no_result, "");
    EXPECT_EQ(pair.steps, pair.of);
    for (const StepCosts* cost : {&pair.before, &pair.now, &pair.again}) {
      EXPECT_THAT(cost->cpu, testing::AllOf(SizeIs(2), testing::Each(testing::Gt(0))));
      EXPECT_THAT(cost->wall, SizeIs(2));
    }
  }
}

TEST_F(SideBySideTest, GivesNoResultForASceneThatTheOtherProgramCannotRun) {
  const fs::path before = worker("read x; echo '{\"refused\":\"has no capsules\"}'\n");
  EXPECT_EQ(sides(before).measure(std::vector<std::size_t>{0}, 1, [](const auto&) {})[0].no_result, "has no capsules");
}

}  // namespace
}  // namespace plumb::side_by_side_test
