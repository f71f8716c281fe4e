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

TEST_F(Export, SaysWhatIsLeftOut) {
  EXPECT_THAT(say({"export", "bounce", "--out", at("f.json")}).out, HasSubstr("Without disc apex 1: "));
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
