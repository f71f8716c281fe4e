#include <gmock/gmock.h>

#include <filesystem>

#include "scene_files.h"

namespace plumb::export_scene_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

using Export = SceneFiles;

TEST_F(Export, WritesTheFamilysDefaultsAVariantOrYourOwn) {
  const auto restitution = [&](const char* word) {
    EXPECT_EQ(say({"export", word, "--out", at("f.json"), "--force"}).code, 0);
    return json(at("f.json"))["bodies"][1]["shapes"][0]["restitution"];
  };
  EXPECT_EQ(restitution("bounce"), 0.8);
  EXPECT_EQ(restitution("bounce:e=1"), 1);
  EXPECT_EQ(restitution("bounce:restitution=1/4"), 0.25);
}

TEST_F(Export, KeepsApexesLandingsBoundsAndMeans) {
  say({"export", "bounce", "--out", at("f.json")});
  const Json truth = json(at("f.json"))["truth"];
  EXPECT_EQ(truth.size(), 7u) << truth;
  EXPECT_EQ(truth[0]["quantity"], "apex");
  EXPECT_EQ(truth[0]["index"], 1);
}

TEST_F(Export, WritesAReportedCaseAsItIs) {
  const Said said = say({"export", "tracker:box2d-76-ball-rests", "--out", at("f.json")});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(json(at("f.json"))["source"], HasSubstr("box2d"));
  EXPECT_FALSE(json(at("f.json"))["truth"].empty());
}

TEST_F(Export, WritesTheSceneThatFindDraws) {
  const auto exported = [&](const char* seed) {
    EXPECT_EQ(say({"export", "random:heap/3", "--seed", seed, "--out", at("f.json"), "--force"}).code, 0);
    return json(at("f.json"));
  };
  EXPECT_EQ(exported("7")["name"], "heap/3");
  EXPECT_EQ(exported("7"), exported("7"));
  EXPECT_NE(exported("7"), exported("8"));
}

TEST_F(Export, SaysHowRandomScenesAreNamed) {
  for (const char* word : {"random:heap", "random:heap/", "random:heap/x", "random:heap/-1", "random:heap/1/2"}) {
    const Said said = say({"export", word, "--out", at("f.json")});
    EXPECT_EQ(said.code, 2);
    EXPECT_THAT(said.err, HasSubstr("KIND/N"));
  }
  EXPECT_THAT(say({"export", "random:heip/1", "--out", at("f.json")}).err, HasSubstr("heap"));
}

TEST_F(Export, KeepsASymbolicLink) {
  put("target.json", "old");
  fs::create_symlink("target.json", at("link.json"));
  EXPECT_EQ(say({"export", "bounce", "--out", at("link.json"), "--force"}).code, 0);
  EXPECT_TRUE(fs::is_symlink(at("link.json")));
  EXPECT_GT(fs::file_size(at("target.json")), 3u);
}

TEST_F(Export, ExitsWith2ForACircleOfLinksAndAFullDisk) {
  fs::create_symlink("b.json", at("a.json"));
  fs::create_symlink("a.json", at("b.json"));
  EXPECT_EQ(say({"export", "bounce", "--out", at("a.json"), "--force"}).code, 2);
  EXPECT_EQ(say({"run", at("a.json")}).code, 2);
  fs::create_symlink("/dev/full", at("full.json"));
  const Said said = say({"export", "bounce", "--out", at("full.json"), "--force"});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("No space left"));
}

TEST_F(Export, ReplacesAFileOnlyWhereTold) {
  const std::string mine = put("mine.json", "mine");
  const Said said = say({"export", "bounce", "--out", mine});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("--force"));
  EXPECT_EQ(fs::file_size(mine), 4u);
  EXPECT_EQ(say({"export", "bounce", "--out", mine, "--force"}).code, 0);
  EXPECT_GT(fs::file_size(mine), 4u);
}

TEST_F(Export, WritesNothingWhereSomethingIsWrong) {
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

}  // namespace
}  // namespace plumb::export_scene_test
