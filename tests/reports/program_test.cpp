#include "reports/program.h"

#include <gmock/gmock.h>

namespace plumb {
namespace {

using ::testing::HasSubstr;

struct Said {
  int code;
  std::string out, err;
};

Said say(std::vector<std::string> arguments) {
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  const int code = program(std::move(arguments));
  std::fflush(stdout);
  std::fflush(stderr);
  return {code, ::testing::internal::GetCapturedStdout(), ::testing::internal::GetCapturedStderr()};
}

TEST(Program, HelpsWithExamples) {
  for (const char* command : {"run", "report", "list"}) {
    const Said said = say({command, "--help"});
    EXPECT_EQ(said.code, 0);
    EXPECT_THAT(said.out, HasSubstr(std::string("plumb ") + command)) << "an example";
  }
  const Said said = say({"--help"});
  EXPECT_EQ(said.code, 0);
  EXPECT_THAT(said.out, HasSubstr("Exit codes"));
}

TEST(Program, TellsItsVersion) {
  const Said said = say({"--version"});
  EXPECT_EQ(said.code, 0);
  EXPECT_THAT(said.out, HasSubstr("plumb 0."));
}

TEST(Program, SuggestsTheNearestNameAndExitsWith2) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> slips{
      {{"reprot"}, "unknown command \"reprot\", did you mean \"report\"?"},
      {{"run", "--engin", "impulse"}, "unknown option \"--engin\", did you mean \"--engine\"?"},
      {{"list", "engine"}, "unknown list \"engine\", did you mean \"engines\"?"}};
  for (const auto& [words, advice] : slips) {
    const Said said = say(words);
    EXPECT_EQ(said.code, 2);
    EXPECT_THAT(said.err, HasSubstr(advice));
    EXPECT_EQ(said.out, "");
  }
}

TEST(Program, ExitsWith2WhereItCannotWrite) {
  const Said said = say({"run", "--out", "/dev/null/out"});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("/dev/null/out"));
}

TEST(Program, ExitsWith2ForAStepThatIsNone) {
  EXPECT_EQ(say({"run", "--dt", "0"}).code, 2);
  EXPECT_EQ(say({"run", "--dt"}).code, 2);
  EXPECT_EQ(say({}).code, 2);
}

}  // namespace
}  // namespace plumb
