#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/reports/saying.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

class SceneFileCommands : public ::testing::Test {
 protected:
  SceneFileCommands() { fs::create_directories(folder_); }
  ~SceneFileCommands() override { fs::remove_all(folder_); }

  std::string at(const char* name) const { return folder_ / name; }
  std::string put(const char* name, const std::string& text) const {
    std::ofstream(at(name)) << text;
    return at(name);
  }
  Json json(const std::string& path) const { return Json::parse(std::ifstream(path)); }

  // What a run said, by engine: final poses and verdict.
  Json answers(const std::string& scenario, const char* out) const {
    say({"run", scenario, "--out", at(out)});
    Json all;
    for (const Json& run : json(at(out) + "/report.json")["runs"]) {
      if (!run["exact"].get<bool>())
        all[run["engine"].get<std::string>() + run["method"].get<std::string>()] = {run["final_pose"], run["verdict"]};
    }
    return all;
  }

  fs::path folder_ = fs::path(::testing::TempDir()) / ("plumb-scene-files-" + std::to_string(getpid()));
};

TEST_F(SceneFileCommands, GoRoundAndAgreeWithTheCatalogue) {
  EXPECT_EQ(say({"export", "bounce:e=0.8", "--out", at("f.json")}).code, 0);
  EXPECT_EQ(answers(at("f.json"), "file").dump(1), answers("bounce:e=0.8", "built-in").dump(1));
}

TEST_F(SceneFileCommands, ExportTheFamilysDefaultsAVariantOrYourOwn) {
  const auto restitution = [&](const char* word) {
    EXPECT_EQ(say({"export", word, "--out", at("f.json"), "--force"}).code, 0);
    return json(at("f.json"))["bodies"][1]["shapes"][0]["restitution"];
  };
  EXPECT_EQ(restitution("bounce"), 0.8);
  EXPECT_EQ(restitution("bounce:e=1"), 1);
  EXPECT_EQ(restitution("bounce:restitution=1/4"), 0.25);
}

TEST_F(SceneFileCommands, SayWhatIsLeftOut) {
  EXPECT_THAT(say({"export", "bounce", "--out", at("f.json")}).out, HasSubstr("Without disc apex 1: "));
}

TEST_F(SceneFileCommands, ReplaceAFileOnlyWhereTold) {
  const std::string mine = put("mine.json", "mine");
  const Said said = say({"export", "bounce", "--out", mine});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("--force"));
  EXPECT_EQ(fs::file_size(mine), 4u);
  EXPECT_EQ(say({"export", "bounce", "--out", mine, "--force"}).code, 0);
  EXPECT_GT(fs::file_size(mine), 4u);
}

TEST_F(SceneFileCommands, ExportNothingWhereSomethingIsWrong) {
  const std::pair<std::vector<std::string>, const char*> wrong[] = {
      {{"export", "bouncee", "--out", at("f.json")}, "did you mean \"bounce\"?"},
      {{"export", "bounce:restitution=7", "--out", at("f.json")}, "out of range"},
      {{"export", "bounce", "--out", at("no/such/f.json")}, "cannot be written"},
      {{"export", "bounce", "--out", at("f.txt")}, "must end in .json"},
      {{"export", "bounce"}, "--out"},
      {{"export"}, "scenario"},
  };
  for (const auto& [words, advice] : wrong) {
    const Said said = say(words);
    EXPECT_EQ(said.code, 2) << advice;
    EXPECT_THAT(said.err, HasSubstr(advice));
    EXPECT_EQ(said.out, "");
  }
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(SceneFileCommands, RunMixesFilesWithScenarios) {
  say({"export", "spring", "--out", at("f.json")});
  const Said said = say({"run", at("f.json"), "orbit:round", "--engine", "impulse", "--out", at("out")});
  EXPECT_EQ(said.code, 0) << said.out << said.err;
  const Json report = json(at("out/report.json"));
  EXPECT_EQ(report["scenarios"].size(), 2u);
  EXPECT_THAT(report["command"].dump(), HasSubstr("f.json"));
}

TEST_F(SceneFileCommands, RunExitsWith2ForAFileItDoesNotTake) {
  say({"export", "spring", "--out", at("f.json")});
  Json scene = json(at("f.json"));
  scene["bodies"][0]["shapes"][0]["radius"] = -1;
  const std::pair<std::string, const char*> wrong[] = {
      {at("none.json"), "none.json: cannot be read: No such file or directory"},
      {folder_.string(), "cannot be read: Is a directory"},
      {put("broken.json", "{\"plumb\": 1,}"), "broken.json: line 1, column 13: "},
      {put("empty.json", ""), "empty.json: line 1, column 1: "},
      {put("negative.json", scene.dump()), "negative.json: bodies[0].shapes[0].radius: expected a number from 1e-06"},
      {"/dev/zero", "/dev/zero: is larger than 16 MiB"},
  };
  for (const auto& [path, advice] : wrong) {
    const Said said = say({"run", "bounce", path, "--out", at("out")});
    EXPECT_EQ(said.code, 2) << path;
    EXPECT_THAT(said.err, HasSubstr(advice));
    EXPECT_FALSE(fs::exists(at("out"))) << "nothing was run";
  }
}

TEST_F(SceneFileCommands, RunTakesNamesFromAFileAsText) {
  say({"export", "spring", "--out", at("f.json")});
  Json scene = json(at("f.json"));
  const std::string name = "</script><b>{0} %s,\"\u00fc\"";
  scene["name"] = name;
  scene["about"] = name;
  const Said said = say({"run", put("odd.json", scene.dump()), "--engine", "impulse", "--out", at("out")});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr(name));
  EXPECT_EQ(json(at("out/report.json"))["runs"][0]["scenario"], name);
}

}  // namespace
}  // namespace plumb
