#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "../../../reference/programs/faults.h"
#include "../../saying.h"

namespace plumb::diff_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

class DiffCommand : public ::testing::Test {
 protected:
  ~DiffCommand() override { fs::remove(file_); }

  Json diff(std::vector<std::string> words, int code) const {
    words.insert(words.begin(), "diff");
    words.insert(words.end(), {"--json", file_.string()});
    const Said said = say(words);
    EXPECT_EQ(said.code, code) << said.out << said.err;
    return Json::parse(std::ifstream(file_));
  }

  fs::path file_ = fs::path(::testing::TempDir()) / ("plumb-diff-" + std::to_string(getpid()) + ".json");
};

TEST_F(DiffCommand, NeverPartsARunFromItself) {
  const Json same = diff({"bounce", "impulse", "impulse:workers=2"}, 0);
  EXPECT_TRUE(same["divergence"].is_null());
  EXPECT_EQ(same["steps"], 600);
  EXPECT_THAT(say({"diff", "bounce", "impulse", "impulse:workers=2"}).out,
              HasSubstr("never diverge in 600 steps (10 s)"));
}

TEST_F(DiffCommand, PartsTwoIntegratorsInTheirFirstStep) {
  const Json divergence = diff({"spring", "impulse:solver=article,integrator=explicit-euler",
                                "impulse:solver=article,integrator=symplectic-euler"},
                               1)["divergence"];
  EXPECT_EQ(divergence["stage"], "integration");
  EXPECT_EQ(divergence["step"], 1);
  EXPECT_EQ(divergence["first"]["what"], "x of disc") << "v is the same; x moved with the old one or the new one";
}

TEST_F(DiffCommand, PartsTwoSolversAtTheImpulse) {
  const Json divergence = diff({"stacking", "impulse", "impulse:solver=article"}, 1)["divergence"];
  EXPECT_EQ(divergence["stage"], "impulse");
  EXPECT_EQ(divergence["step"], 1);
}

TEST_F(DiffCommand, PartsAnEngineFromAnotherByWhatTheyState) {
  const Json divergence = diff({"bounce:e=0.5", "impulse", "box2d"}, 1)["divergence"];
  EXPECT_EQ(divergence["stage"], "integration");
  EXPECT_THAT(divergence["advice"].get<std::string>(), HasSubstr("Their integrators explain it"));
}

TEST_F(DiffCommand, TellsImpactsAtTheirOwnTimeFromThoseAtAStepsEnd) {
  const Json within = diff({"pi-billiard", "impulse", "chipmunk", "--tolerance", "0.01"}, 1)["divergence"];
  EXPECT_EQ(within["stage"], "event time");
  const Json later = diff({"bounce:e=0.5", "impulse", "impulse:solver=article", "--tolerance", "0.2"}, 1)["divergence"];
  EXPECT_EQ(later["stage"], "event time");
  EXPECT_EQ(later["figures"][6]["what"], "step of the impact");
  EXPECT_LT(later["figures"][6]["a"], later["figures"][6]["b"]);
}

TEST_F(DiffCommand, ShowsSkinsAsAnotherManifold) {
  const Json divergence = diff({"slope", "box2d", "impulse", "--tolerance", "0.001"}, 1)["divergence"];
  EXPECT_EQ(divergence["stage"], "manifold");
}

TEST_F(DiffCommand, HoldsAnEngineAgainstTheTruthAtAnyStep) {
  const Json near = diff({"pendulum", "exact", "impulse", "--dt", "1/240", "--tolerance", "0.1"}, 0);
  EXPECT_EQ(near["dt"], 1.0 / 240);
  EXPECT_LT(near["largest"]["difference"], 0.1);
  EXPECT_GT(near["largest"]["difference"], 0);
  EXPECT_EQ(diff({"pendulum", "exact", "impulse", "--dt", "1/240", "--tolerance", "0"}, 1)["divergence"]["body"],
            "rod");
}

TEST_F(DiffCommand, ExitsWith1IfAnEngineFailsBeforeItsFirstStep) {
  for (const char* fault : {"crashes-in-build", "crashes-when-asked-how"}) {
    const std::string program = faulty_program(PLUMB_SOURCE_DIR, fault);
    const Json found = diff({"spinning-obb:free-fall", "impulse", program}, 1);
    EXPECT_EQ(found["steps"], 0) << fault;
    ASSERT_EQ(found["failed"].size(), 1u) << fault;
    EXPECT_EQ(found["failed"][0]["engine"], program);
    EXPECT_THAT(found["failed"][0]["reason"].get<std::string>(), HasSubstr("ended by signal 11")) << fault;
  }
}

TEST_F(DiffCommand, TakesSceneFiles) {
  const std::string scene = file_.string() + ".scene.json";
  ASSERT_EQ(say({"export", "spring", "--out", scene}).code, 0);
  EXPECT_EQ(diff({scene, "impulse", "impulse"}, 0)["scenario"], scene);
  fs::remove(scene);
}

TEST_F(DiffCommand, ExitsWith2ForWhatCannotBeCompared) {
  const std::pair<std::vector<std::string>, const char*> wrong[] = {
      {{"diff", "bounce", "impulse"}, "second"},
      {{"diff", "bounce", "impulse", "box3d"}, "did you mean \"box2d\"?"},
      {{"diff", "bonce", "impulse", "box2d"}, "did you mean \"bounce\"?"},
      {{"diff", "pyramid", "exact", "box2d"}, "pyramid has no closed form"},
      {{"diff", "bounce", "impulse", "box2d", "--dt", "0"}, "--dt"},
      {{"diff", "bounce", "impulse", "box2d", "--tolerance", "-1"}, "must not be below 0"},
      {{"diff", "bounce", "impulse", "box2d", "--json", "/dev/null/out"}, "cannot be written"},
      {{"diff", "bounce", "impulse", "box2d", "--json", ::testing::TempDir()}, "cannot be written"},
      {{"diff", "pendulum", "impulse", "impulse:solver=exact"}, "does not support joints"},
  };
  for (const auto& [words, advice] : wrong) {
    const Said said = say(words);
    EXPECT_EQ(said.code, 2) << advice;
    EXPECT_THAT(said.err, HasSubstr(advice));
    EXPECT_EQ(said.out, "");
  }
}

}  // namespace
}  // namespace plumb::diff_test
