#include <gmock/gmock.h>

#include "../study/study_files.h"
#include "scenarios/catalog.h"

/// What was found once, run again.
namespace plumb::corpus_test {
namespace {

using ::testing::HasSubstr;

class Corpus : public StudyFiles {
 protected:
  Said again(const std::string& folder) const { return say({"find", "--again", folder, "--out", at("again")}); }
};

TEST_F(Corpus, OfMendedScenesHolds) {
  const Said said = again(PLUMB_SOURCE_DIR "/tests/reference/found");
  EXPECT_EQ(said.code, 0) << said.out << said.err;
}

// Where the library is of another version, or the judges changed, an author must not be sent a scene that holds.
// Engines of npm are run where they are installed.
TEST_F(Corpus, OfOtherEnginesStillShowsWhatIsSaidOfThem) {
  for (const char* engine : {"box2d", "chipmunk"}) {
    if (Catalog<Engine>::find(engine) == nullptr) GTEST_SKIP() << "built without " << engine;
  }
  const std::string folder = PLUMB_SOURCE_DIR "/reference/found";
  const Said said = again(folder);
  EXPECT_EQ(said.code, 1) << said.err;
  EXPECT_THAT(said.out, testing::Not(HasSubstr("holds")));
  EXPECT_THAT(said.out, testing::Not(HasSubstr("not supported")));
}

TEST_F(Corpus, RunsNoSceneOfAnEngineThatIsNotHere) {
  std::filesystem::create_directories(at("corpus"));
  put(at("corpus/one.json"), R"({"plumb": 1, "name": "one", "origin": {"engine": "nowhere"}, "gravity": [0, -10],
      "duration": 0.1, "bodies": [{"name": "ball", "type": "dynamic", "shapes": [{"type": "circle", "radius": 1}]}]})");
  const Said said = again(at("corpus"));
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("not run: "));
  EXPECT_THAT(said.out, HasSubstr("0 of 0 fail."));
  EXPECT_EQ(say({"find", "--again", at("corpus"), "--engine", "nowhere", "--out", at("again")}).code, 2);
}

}  // namespace
}  // namespace plumb::corpus_test
