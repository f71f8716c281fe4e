#include <gmock/gmock.h>

#include <filesystem>
#include <sstream>

#include "scene_files.h"

namespace plumb::run_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

class RunFile : public SceneFiles {
 protected:
  // What was measured in a run and its verdict, by engine.
  Json answers(const std::string& scenario, const char* out) const {
    say({"run", scenario, "--out", at(out)});
    const Json report = json(at(out) + "/report.json");
    Json all;
    for (const Json& run : report["runs"]) {
      if (!run["exact"].get<bool>())
        all[run["engine"].get<std::string>() + run["method"].get<std::string>()] = {run["metrics"], run["verdict"]};
    }
    return all;
  }
};

TEST_F(RunFile, AgreesWithTheCatalogueOnWhatItExported) {
  for (const char* scenario : {"bounce:e=0.8", "stacking:ten", "motor-arm:holds"}) {
    EXPECT_EQ(say({"export", scenario, "--out", at("f.json"), "--force"}).code, 0);
    EXPECT_EQ(answers(at("f.json"), "file").dump(1), answers(scenario, "built-in").dump(1));
  }
}

TEST_F(RunFile, WarnsOfWhatIsRarelyMeant) {
  say({"export", "stacking:ten", "--out", at("f.json")});
  EXPECT_EQ(say({"run", at("f.json"), "--engine", "impulse", "--no-converged", "--out", at("out")}).err, "");
  Json scene = json(at("f.json"));
  scene["bodies"][1]["angle"] = 90;
  put("f.json", scene.dump());
  EXPECT_THAT(say({"run", at("f.json"), "--engine", "impulse", "--no-converged", "--out", at("out")}).err,
              HasSubstr("f.json: bodies[1] (\"box 1\").angle: 90 is more than a full turn"));
}

TEST_F(RunFile, MixesFilesWithScenarios) {
  say({"export", "spring", "--out", at("f.json")});
  const Said said = say({"run", at("f.json"), "orbit:round", "--engine", "impulse", "--out", at("out")});
  EXPECT_EQ(said.code, 0) << said.out << said.err;
  const Json report = json(at("out/report.json"));
  EXPECT_EQ(report["scenarios"].size(), 2u);
  EXPECT_THAT(report["command"].dump(), HasSubstr("f.json"));
}

TEST_F(RunFile, IsJudgedAlikeWithoutTimings) {
  const auto report = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"--engine", "impulse", "--out", at("out")});
    EXPECT_EQ(say(words).code, 0);
    return json(at("out/report.json"));
  };
  const Json timed = report({"run", "bounce:e=0.5"});
  const Json untimed = report({"run", "bounce:e=0.5", "--no-timings"});
  EXPECT_EQ(timed["runs"].dump(1), untimed["runs"].dump(1));
  EXPECT_FALSE(timed["timings"]["steps"].empty());
  EXPECT_TRUE(untimed["timings"]["steps"].empty());
}

TEST_F(RunFile, OrAScenarioIsReportedToo) {
  const Said said = say({"report", "bounce:e=0.5", "--engine", "impulse", "--no-studies", "--out", at("out")});
  EXPECT_EQ(said.code, 0) << said.err;
  const Json runs = json(at("out") + "/report.json")["runs"];
  EXPECT_FALSE(runs.empty());
  for (const Json& one : runs) EXPECT_EQ(one["variant"], "e=0.5");
  EXPECT_EQ(say({"report", "bonce", "--no-studies", "--out", at("out")}).code, 2);
}

TEST_F(RunFile, FindsTheReadmesExampleRight) {
  std::ostringstream readme;
  readme << std::ifstream(PLUMB_SOURCE_DIR "/README.md").rdbuf();
  const std::string fence = "```json\n";
  const auto begin = readme.str().find(fence) + fence.size();
  const std::string scene = readme.str().substr(begin, readme.str().find("```", begin) - begin);
  const Said said = say({"run", put("slope.json", scene), "--out", at("out")});
  EXPECT_EQ(said.code, 0) << said.out << said.err;
  EXPECT_THAT(said.out, HasSubstr("slide (exact)"));
  const Json report = json(at("out/report.json"));
  for (const Json& run : report["runs"]) EXPECT_EQ(run["verdict"], "right") << run["engine"];
}

TEST_F(RunFile, ExitsWith2ForAFileItDoesNotTake) {
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

TEST_F(RunFile, TakesNamesFromAFileAsText) {
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
}  // namespace plumb::run_test
