#include "reports/run/scene_case.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "reports/run/experiment.h"
#include "reports/run/selection.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

TEST(MeansFile, TakesJsonAndPathsThatExist) {
  EXPECT_TRUE(means_file("mine.json"));
  EXPECT_TRUE(means_file("/dev/null"));
  EXPECT_FALSE(means_file("bounce"));
  EXPECT_FALSE(means_file("bounce:restitution=1/2"));
  EXPECT_FALSE(means_file("no/such/place"));
}

class SceneCase : public ::testing::Test {
 protected:
  ~SceneCase() override { fs::remove_all(folder_); }

  std::string write(const std::string& text) const {
    fs::create_directories(folder_);
    std::ofstream(folder_ / "scene.json") << text;
    return folder_ / "scene.json";
  }

  fs::path folder_ = fs::path(::testing::TempDir()) / ("plumb-scene-case-" + std::to_string(getpid()));
};

const std::string falling =
    R"({"plumb": 1, "name": "drop", "about": "Does it fall?", "gravity": [0, -10], "duration": 1,
  "bodies": [{"name": "disc", "type": "dynamic", "position": [0, 5], "shapes": [{"type": "circle", "radius": 1}]}],
  "truth": [{"body": "disc", "quantity": "vy", "time": 0.5, "value": -5, "tolerance": 0.001, "source": "g t"}]})";

TEST_F(SceneCase, AsksWhatTheFileAsks) {
  const std::string path = write(falling);
  const Case asked = case_of_file(path);
  EXPECT_EQ(asked.scenario->name, "drop");
  EXPECT_EQ(asked.scenario->question, "Does it fall?");
  EXPECT_EQ(asked.variant, path);
  const auto expectations = asked.scenario->expectations({});
  ASSERT_EQ(expectations.size(), 1u);
  EXPECT_EQ(expectations[0].time, 0.5);
  EXPECT_EQ(expectations[0].expected, -5);
  EXPECT_EQ(expectations[0].within, 0.001);
}

TEST_F(SceneCase, HasTheClosedFormThatKnowsIt) {
  ASSERT_NE(case_of_file(write(falling)).closed_form, nullptr);
  EXPECT_EQ(case_of_file(write(falling)).closed_form->name, "ballistic");
}

TEST_F(SceneCase, IsJudgedByItsTruthsForEveryEngine) {
  std::string wrong = falling;
  wrong.replace(wrong.find("-5,"), 3, "-6,");
  for (const auto& [text, verdict] : {std::pair{falling, Verdict::right}, {wrong, Verdict::wrong}}) {
    const Report report = carry_out({.cases = {case_of_file(write(text))}, .configs = default_engines()},
                                    [](const std::string&, std::size_t, std::size_t) {});
    for (const RunRecord& run : report.runs) {
      EXPECT_EQ(run.verdict, run.exact ? Verdict::right : verdict) << run.engine;
    }
  }
}

// Bounce is known to several closed forms; the first impact's ends at the second.
TEST(WitnessOf, IsTheClosedFormThatHoldsLongest) {
  const Engine* witness = witness_of(*parse_case("bounce").scene);
  ASSERT_NE(witness, nullptr);
  EXPECT_EQ(witness->name, "bounce");
  EXPECT_EQ(witness_of({.bodies = {{.name = "none"}}, .joints = {Weld{}}}), nullptr);
}

TEST(TruthsOf, AreTheExpectationsWithAFirstOrderMethodsAllowance) {
  const Case asked = parse_case("spring");
  const auto expectations = asked.scenario->expectations(asked.parameters);
  const StatedTruths stated = truths_of(asked);
  ASSERT_EQ(stated.truth.size(), expectations.size());
  EXPECT_TRUE(stated.left_out.empty());
  for (std::size_t i = 0; i < expectations.size(); ++i) {
    EXPECT_EQ(stated.truth[i].quantity, expectations[i].quantity);
    EXPECT_EQ(stated.truth[i].tolerance, expectations[i].allowed(reference_stepping()));
    EXPECT_THAT(stated.truth[i].source, HasSubstr(expectations[i].source));
    EXPECT_THAT(stated.truth[i].source, HasSubstr("1/60 s"));
  }
}

TEST(TruthsOf, SayWhatNoSceneFileCanSay) {
  const StatedTruths stated = truths_of(parse_case("bounce"));
  EXPECT_EQ(stated.truth.size(), 1u);
  EXPECT_EQ(stated.left_out.size(), 6u);
  EXPECT_THAT(stated.left_out.at(0), HasSubstr("disc apex 1"));
  EXPECT_THAT(stated.left_out.at(3), HasSubstr("disc landing"));
}

// All that the catalogue knows can be asked from a file: what the closed form says is what the file states.
TEST_F(SceneCase, OfAnExportedScenarioExpectsTheSame) {
  for (const Case& asked : default_cases(true)) {
    const StatedTruths stated = truths_of(asked);
    EXPECT_EQ(stated.truth.size() + stated.left_out.size(), asked.scenario->expectations(asked.parameters).size());
    const Case read = case_of_file(write(write_scene({*asked.scene, stated.truth})));
    const auto expectations = read.scenario->expectations({});
    ASSERT_EQ(expectations.size(), stated.truth.size());
    for (std::size_t i = 0; i < expectations.size(); ++i) EXPECT_EQ(expectations[i].expected, stated.truth[i].value);
    // What falls beyond the limit of a family is beyond its closed form too.
    const bool solved = asked.closed_form != nullptr && asked.closed_form->unsupported(*asked.scene, {}).empty();
    EXPECT_EQ(read.closed_form != nullptr, solved) << asked.scenario->name << ' ' << asked.variant;
  }
}

}  // namespace
}  // namespace plumb
