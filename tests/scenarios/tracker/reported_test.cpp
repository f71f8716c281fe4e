#include "scenarios/tracker/reported.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "scenarios/scene/scene_json.h"

namespace plumb::reported_test {
namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::StartsWith;

TEST(ReportedScenes, AreNamedAfterTheirThreads) {
  for (const ReportedScene& scene : reported_scenes()) {
    const SceneFile file = read_scene(scene.text, scene.name);
    EXPECT_EQ(file.scene.name, scene.name);
    ASSERT_THAT(file.source, MatchesRegex("https://github.com/[^/ ]+/[^/ ]+/(issues|pull)/[0-9]+")) << scene.name;
    const std::string number = file.source.substr(file.source.rfind('/') + 1);
    EXPECT_THAT(std::string(scene.name), HasSubstr("-" + number + "-"));
  }
}

TEST(ReportedScenes, SayWhatWasReportedAndWhatMustBeTrue) {
  for (const ReportedScene& scene : reported_scenes()) {
    const SceneFile file = read_scene(scene.text, scene.name);
    EXPECT_THAT(file.scene.about, StartsWith("Reported for ")) << scene.name;
    EXPECT_THAT(file.scene.about, HasSubstr("Expected: ")) << scene.name;
    EXPECT_NEAR(file.scene.duration * 60, std::round(file.scene.duration * 60), 1e-9) << scene.name;
    EXPECT_FALSE(file.truth.empty()) << scene.name;
    for (const StatedTruth& truth : file.truth) {
      EXPECT_GT(truth.tolerance, 0) << scene.name << ' ' << name_of(truth.quantity);
    }
  }
}

TEST(ReportedScenes, AreOfDifferentThreads) {
  std::set<std::string> links;
  for (const ReportedScene& scene : reported_scenes()) {
    EXPECT_TRUE(links.insert(read_scene(scene.text, scene.name).source).second) << scene.name;
  }
  EXPECT_GE(links.size(), 24u);
}

// Its table is made by page.py from a run; this notices a scene that has not been run since.
TEST(ReportedScenes, HaveARowEachInTheReadme) {
  std::ostringstream text;
  text << std::ifstream(PLUMB_SOURCE_DIR "/scenarios/tracker/README.md").rdbuf();
  const std::string readme = text.str();
  for (const ReportedScene& scene : reported_scenes()) {
    const std::string link = read_scene(scene.text, scene.name).source;
    EXPECT_THAT(readme, HasSubstr("\n| [" + std::string(scene.name) + "](" + link + ") | "));
  }
  const std::regex row("\n\\| \\[[^\\]]+\\]\\(https://");
  const std::sregex_iterator first(readme.begin(), readme.end(), row);
  EXPECT_EQ(std::distance(first, std::sregex_iterator()), std::ssize(reported_scenes()));
}

}  // namespace
}  // namespace plumb::reported_test
