#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "../../saying.h"

namespace plumb::prove_test {
namespace {

using ::testing::HasSubstr;

TEST(ProveCommand, PrintsWhatCaughtAFaultAndWritesIt) {
  const auto file = std::filesystem::path(::testing::TempDir()) / ("plumb-prove-" + std::to_string(getpid()) + ".json");
  const Said said =
      say({"prove", "energy-leak", "--scenario", "spinning-obb:flight", "--clean", "2", "--out", file.string()});
  EXPECT_EQ(said.code, 0) << said.out << said.err;
  EXPECT_THAT(said.out, HasSubstr("1 of 1 faults caught, 1 of them by truth or invariant; false alarms in 0 of 3 clean "
                                  "runs; cases: 1."));
  EXPECT_THAT(said.out, HasSubstr("spinning-obb flight"));
  EXPECT_EQ(nlohmann::json::parse(std::ifstream(file))["faults"][0]["name"], "energy-leak");
  std::filesystem::remove(file);
}

TEST(ProveCommand, EndsWithOneWhereAFaultIsNotSeen) {
  const Said said = say({"prove", "joints-lost", "--scenario", "spinning-obb:flight", "--clean", "0"});
  EXPECT_EQ(said.code, 1);
  EXPECT_THAT(said.out, HasSubstr("NOT SEEN: the same bits everywhere"));
}

TEST(ProveCommand, NamesTheNearestFault) {
  const Said said = say({"prove", "energy-leek"});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("did you mean \"energy-leak\"?"));
}

TEST(ProveCommand, SaysWhatBecameOfAControl) {
  const auto file =
      std::filesystem::path(::testing::TempDir()) / ("plumb-control-" + std::to_string(getpid()) + ".json");
  const Said said = say({"prove", "--controls", "frozen", "--scenario", "spinning-obb:free-fall", "--statement",
                         "impulse", "--statement", "box2d", "--out", file.string()});
  EXPECT_EQ(said.code, 0) << said.out << said.err;
  EXPECT_THAT(
      said.out,
      HasSubstr("controls: 1, judged by what box2d states; false passes: 0; cases: 1, of which 0 are left out"));
  EXPECT_THAT(said.out, HasSubstr("frozen: nothing moves"));
  EXPECT_EQ(nlohmann::json::parse(std::ifstream(file))["statements"][1]["stated_by"], "box2d");
  std::filesystem::remove(file);
}

TEST(ProveCommand, NamesTheNearestControl) {
  const Said said = say({"prove", "--controls", "frosen"});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("did you mean \"frozen\"?"));
}

TEST(ProveCommand, TakesAStatementForControlsOnly) {
  EXPECT_EQ(say({"prove", "--statement", "box2d"}).code, 2);
  EXPECT_EQ(say({"prove", "--controls", "--clean", "3"}).code, 2);
}

TEST(ProveCommand, RefusesAFileThatCannotBeWritten) {
  const Said said = say({"prove", "energy-leak", "--out", "/nowhere/at/all.json"});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("cannot be written"));
}

}  // namespace
}  // namespace plumb::prove_test
