#include "reports/timing/measure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "reports/run/selection.h"
#include "reports/timing/pacer.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::SizeIs;

const fs::path plumb_program = PLUMB_PROGRAM;

// Programs that are written for a test, as shell scripts.
class TimingMeasure : public testing::Test {
 protected:
  TimingMeasure() { fs::create_directories(folder_); }
  ~TimingMeasure() override { fs::remove_all(folder_); }

  fs::path script(const std::string& text) {
    const fs::path path = folder_ / "program";
    std::ofstream(path) << "#!/bin/sh\n" << text;
    fs::permissions(path, fs::perms::owner_all);
    return path;
  }
  // One that greets as it should, and then does as it likes.
  fs::path pacer(const std::string& text) {
    return script("echo '{\"pace\":1,\"facts\":{},\"uncounted\":\"\"}'\n" + text);
  }

  fs::path folder_ = fs::temp_directory_path() / ("plumb-pacer-" + std::to_string(getpid()));
};

std::string refusal(const fs::path& program) {
  try {
    const Pacer begun(program);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

std::string failure(const fs::path& program, double patience = 20) {
  Pacer begun(program, {.patience = patience});
  try {
    begun.ask({{"runs", 1}});
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

SideBySide sides(const fs::path& before, const char* words = "bounce:e=0.5") {
  return {before, plumb_program, parse_cases(words), "impulse", 1.0 / 60};
}

TEST_F(TimingMeasure, NamesAProgramThatCannotBeRun) {
  EXPECT_THAT(refusal(folder_ / "missing"), testing::AllOf(HasSubstr("missing"), HasSubstr("cannot be run")));
}

TEST_F(TimingMeasure, NamesAProgramThatIsTooOld) {
  EXPECT_THAT(refusal(script("echo 'plumb: unknown command \"pace\"' >&2\nexit 2\n")), HasSubstr("older than"));
  EXPECT_THAT(refusal(script("echo hello\n")), HasSubstr("older than"));
  EXPECT_THAT(refusal(script("echo '{\"pace\":99,\"facts\":{},\"uncounted\":\"\"}'\n")), HasSubstr("version 99"));
}

TEST_F(TimingMeasure, NoticesWhatIsNoAnswer) {
  EXPECT_THAT(failure(pacer("read x; echo 12\n")), HasSubstr("\"12\""));
  EXPECT_THAT(failure(pacer("read x; echo '{\"cpu\":['\n")), HasSubstr("no JSON object"));
  EXPECT_THAT(failure(pacer("read x; exit 1\n")), HasSubstr("ended without an answer"));
  EXPECT_THAT(failure(pacer("read x; kill -9 $$\n")), HasSubstr("ended without an answer"));
  EXPECT_THAT(failure(pacer("sleep 20\n"), 0.2), HasSubstr("took more than 0.2 s"));
  EXPECT_THAT(failure(pacer("read x; yes | tr -d '\\n'\n")), HasSubstr("without end"));
}

TEST_F(TimingMeasure, AnswersThatMakeNoSenseLeaveACaseWithoutAResult) {
  for (const char* const answer :
       {"{\"refused\":\"not today\"}", "{}", "{\"cpu\":[]}", "{\"cpu\":[-1]}", "{\"cpu\":\"long\"}"}) {
    const fs::path before = pacer(std::string("read x; echo '{}'; while read x; do echo '") + answer + "'; done\n");
    const auto pairs = sides(before).measure(std::vector<std::size_t>{0}, 2, [](const auto&) {});
    ASSERT_THAT(pairs, SizeIs(1));
    EXPECT_NE(pairs[0].no_result, "") << answer;
    EXPECT_TRUE(pairs[0].now.cpu.empty());
  }
}

TEST_F(TimingMeasure, TimesTwoProgramsSideBySide) {
  std::vector<std::string> heard;
  const SideBySide both = sides(plumb_program, "bounce");
  const auto pairs = both.measure(std::vector<std::size_t>{0, 2}, 2, [&](const auto& name) { heard.push_back(name); });
  ASSERT_THAT(pairs, SizeIs(2));
  EXPECT_THAT(heard, testing::ElementsAre("bounce:e=0.5", "bounce:e=1", "bounce:e=0.5", "bounce:e=1"));
  for (const TimedPair& pair : pairs) {
    EXPECT_EQ(pair.no_result, "");
    EXPECT_EQ(pair.steps, pair.of);
    for (const Cost* cost : {&pair.before, &pair.now, &pair.again}) {
      EXPECT_THAT(cost->cpu, testing::AllOf(SizeIs(2), testing::Each(testing::Gt(0))));
      EXPECT_THAT(cost->wall, SizeIs(2));
    }
  }
}

TEST_F(TimingMeasure, ASceneThatTheOlderOneCannotRunHasNoResult) {
  const fs::path before = pacer("read x; echo '{\"refused\":\"knows no capsules\"}'\n");
  EXPECT_EQ(sides(before).measure(std::vector<std::size_t>{0}, 1, [](const auto&) {})[0].no_result,
            "knows no capsules");
}

}  // namespace
}  // namespace plumb
