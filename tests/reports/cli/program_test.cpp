#include "reports/cli/program.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "../saying.h"
#include "reference/simulation.h"
#include "reports/cli/command_line.h"
#include "scenarios/catalog.h"

namespace plumb::program_test {
namespace {

using ::testing::HasSubstr;

// A folder of this process's own, gone after the test.
class ProgramRun : public ::testing::Test {
 protected:
  ~ProgramRun() override { std::filesystem::remove_all(out_); }

  nlohmann::ordered_json report() const { return nlohmann::ordered_json::parse(std::ifstream(out_ / "report.json")); }

  std::filesystem::path out_ = std::filesystem::path(::testing::TempDir()) / ("plumb-run-" + std::to_string(getpid()));
};

TEST_F(ProgramRun, WritesTheSameReportTwiceTimesAside) {
  const auto text = [&] {
    say({"run", "bounce", "--out", out_.string()});
    auto json = report();
    json.erase("timings");
    return json.dump();
  };
  EXPECT_EQ(text(), text());
}

TEST_F(ProgramRun, ExitsWith0WhereAllIsRight) {
  const Said said = say({"run", "spinning-obb:free-fall", "--engine", "impulse", "--out", out_.string()});
  EXPECT_EQ(said.code, 0) << said.out;
  EXPECT_THAT(said.out, HasSubstr("report.json"));
}

// w dt = 15: the spring's energy grows by 226 with every step.
TEST_F(ProgramRun, ExitsWith1WhereARunDiverges) {
  const Said said =
      say({"run", "spring:w=15", "--engine", "impulse:integrator=explicit-euler", "--dt", "1", "--out", out_.string()});
  EXPECT_EQ(said.code, 1) << said.out;
  EXPECT_THAT(said.out, HasSubstr("diverged at t = "));
}

TEST_F(ProgramRun, KeepsWhatIsAskedInTheReportButNotTheFolder) {
  say({"run", "bounce:restitution=0.5", "--engine", "impulse", "--dt", "1/120", "--out", out_.string()});
  EXPECT_EQ(report()["command"].dump(),
            R"(["plumb","run","bounce:restitution=0.5","--engine","impulse","--dt","1/120"])");
  EXPECT_EQ(report()["runs"][0]["dt"], 1.0 / 120);
}

TEST_F(ProgramRun, PrintsTheReportAsJsonOrNothing) {
  const std::vector<std::string> words{"run", "bounce", "--engine", "impulse", "--out", out_.string()};
  auto with_json = words;
  with_json.emplace_back("--json");
  const Said said = say(with_json);
  EXPECT_EQ(nlohmann::ordered_json::parse(said.out)["runs"], report()["runs"]);
  auto quiet = words;
  quiet.emplace_back("--quiet");
  EXPECT_EQ(say(quiet).out, "");
  quiet.emplace_back("--json");
  EXPECT_EQ(say(quiet).code, 2);
}

TEST_F(ProgramRun, WantsEachCaseAndEngineOnce) {
  EXPECT_EQ(say({"run", "bounce", "bounce", "--out", out_.string()}).code, 2);
  EXPECT_EQ(say({"run", "--engine", "impulse", "--engine", "impulse", "--out", out_.string()}).code, 2);
}

TEST(Program, KnowsTheseCommands) {
  std::vector<std::string> names;
  for (const Command* command : Catalog<Command>::all()) names.push_back(command->name);
  EXPECT_THAT(names, ::testing::IsSupersetOf({"accept", "check", "diff", "export", "history", "list", "merge", "open",
                                              "prove", "report", "run", "study"}));
}

TEST(Program, ListsALineForEachScenarioByGroupAndForEachEngine) {
  const Said said = say({"list"});
  EXPECT_EQ(said.code, 0);
  EXPECT_THAT(said.out, HasSubstr("\nfriction: Boxes creep"));
  EXPECT_THAT(said.out, HasSubstr("\n  slope "));
  EXPECT_THAT(said.out, HasSubstr("\n  box2d "));
  EXPECT_THAT(said.out, ::testing::Not(HasSubstr("integrator=")));
  EXPECT_LT(std::count(said.out.begin(), said.out.end(), '\n'), 140);
}

TEST(Program, ListsEnginesWithTheirOptionsMetricsAndInvariants) {
  EXPECT_THAT(say({"list", "engines"}).out, HasSubstr("integrator="));
  EXPECT_THAT(say({"list", "invariants"}).out, HasSubstr("momentum_of_bodies"));
  EXPECT_THAT(say({"list", "relations"}).out, HasSubstr("galilei"));
  EXPECT_THAT(say({"list", "kinds"}).out, HasSubstr("painleve"));
  EXPECT_THAT(say({"list", "metrics"}).out, HasSubstr("energy_rise"));
  EXPECT_THAT(say({"list", "metrics"}).out, ::testing::Not(HasSubstr("integrator")));
}

TEST(Program, HelpsWithExamples) {
  for (const char* command :
       {"run", "report", "list", "export", "history", "diff", "study", "merge", "prove", "open"}) {
    const Said said = say({command, "--help"});
    EXPECT_EQ(said.code, 0);
    EXPECT_THAT(said.out, HasSubstr(std::string("plumb ") + command)) << "an example";
  }
  const Said said = say({"--help"});
  EXPECT_EQ(said.code, 0);
  EXPECT_THAT(said.out, HasSubstr("Exit codes"));
}

TEST(Program, HasEveryExitCodeInItsHelpManualAndCompletion) {
  const std::string help = say({"--help"}).out;
  const std::string manual = say({"man"}).out;
  for (const char* text : {"internal error", "interrupted", "bad usage"}) {
    EXPECT_THAT(help, HasSubstr(text));
    EXPECT_THAT(manual, HasSubstr(text));
  }
  for (const Command* command : Catalog<Command>::all()) {
    if (command->name.starts_with("timing-worker") || command->name == "pace") continue;
    EXPECT_THAT(manual, HasSubstr(".SS plumb " + command->name));
    EXPECT_THAT(say({"completion", "bash"}).out, HasSubstr("'" + command->name + "') words="));
  }
  EXPECT_THAT(say({"completion", "zsh"}).out, HasSubstr("bashcompinit"));
  EXPECT_THAT(say({"completion", "zsh"}).out, HasSubstr("bash zsh'")) << "the shells";
  EXPECT_THAT(say({"completion", "zsh"}).out, ::testing::Not(HasSubstr(" path="))) << "the search path in zsh";
  EXPECT_EQ(say({"completion", "fish"}).code, 2);
}

TEST(Program, NeverPrintsControlCharactersOfANameOfAFile) {
  const Said said = say({"run", "no\033[2Jsuch.json"});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("no?[2Jsuch.json"));
}

TEST(Program, SaysThatAnEngineIsNotBuilt) {
  for (const LeftOutEngine& one : left_out_engines()) {
    const Said said = say({"run", "bounce", "--engine", std::string(one.name)});
    EXPECT_EQ(said.code, 2);
    EXPECT_THAT(said.err, HasSubstr("is not built: " + std::string(one.why)));
  }
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
      {{"study", "spede"}, "unknown study \"spede\", did you mean \"speed\"?"},
      {{"study", "speed", "--scenario", "x"}, "unknown option \"--scenario\", did you mean \"--scenarios\"?"},
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
}  // namespace plumb::program_test
