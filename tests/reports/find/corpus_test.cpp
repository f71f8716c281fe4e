#include <gmock/gmock.h>

#include <algorithm>

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
TEST_F(Corpus, OfOtherEnginesStillShowsWhatIsSaidOfThem) {
  const std::string folder = PLUMB_SOURCE_DIR "/reference/found";
  for (const char* engine : {"box2d", "chipmunk"}) {
    if (Catalog<Engine>::find(engine) == nullptr) GTEST_SKIP() << "built without " << engine;
  }
  const Said said = again(folder);
  EXPECT_EQ(said.code, 1) << said.err;
  const auto scenes = std::ranges::count_if(std::filesystem::directory_iterator(folder),
                                            [](const auto& file) { return file.path().extension() == ".json"; });
  EXPECT_THAT(said.out, HasSubstr(std::to_string(scenes) + " of " + std::to_string(scenes) + " fail."));
}

}  // namespace
}  // namespace plumb::corpus_test
