#include "reports/run/scene_file.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

#include "reports/judge/verdict.h"
#include "reports/run/experiment.h"
#include "reports/run/selection.h"

namespace plumb::scene_file_test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

namespace fs = std::filesystem;

TEST(IsSceneFile, AcceptsJsonAndPathsThatExist) {
  EXPECT_TRUE(is_scene_file("mine.json"));
  EXPECT_TRUE(is_scene_file("/dev/null"));
  EXPECT_FALSE(is_scene_file("bounce"));
  EXPECT_FALSE(is_scene_file("bounce:restitution=1/2"));
  EXPECT_FALSE(is_scene_file("no/such/place"));
}

class SceneFileCase : public ::testing::Test {
 public:
  ~SceneFileCase() override { fs::remove_all(folder_); }

 protected:
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

TEST_F(SceneFileCase, HasTheExpectationsOfTheFile) {
  const std::string path = write(falling);
  const Case test_case = case_of_file(path);
  EXPECT_EQ(test_case.scenario->name, "drop");
  EXPECT_EQ(test_case.scenario->question, "Does it fall?");
  EXPECT_EQ(test_case.variant, path);
  const auto expectations = test_case.scenario->expectations({});
  ASSERT_EQ(expectations.size(), 1u);
  EXPECT_EQ(expectations[0].time, 0.5);
  EXPECT_EQ(expectations[0].expected, -5);
  EXPECT_EQ(expectations[0].within, 0.001);
}

TEST_F(SceneFileCase, HasTheClosedFormThatRecognisesIt) {
  ASSERT_NE(case_of_file(write(falling)).closed_form, nullptr);
  EXPECT_EQ(case_of_file(write(falling)).closed_form->name, "ballistic");
}

TEST_F(SceneFileCase, IsJudgedByItsTruthsForEveryEngine) {
  std::string wrong = falling;
  wrong.replace(wrong.find("-5,"), 3, "-6,");
  for (const auto& [text, verdict] : {std::pair{falling, Verdict::right}, {wrong, Verdict::wrong}}) {
    const Report report = run_experiment({.cases = {case_of_file(write(text))}, .configs = default_engines()},
                                         [](const std::string&, std::size_t, std::size_t) {});
    for (const RunRecord& run : report.runs) {
      EXPECT_EQ(run.verdict, run.exact ? Verdict::right : verdict) << run.engine;
    }
  }
}

TEST_F(SceneFileCase, DoubtsATruthThatItsClosedFormContradicts) {
  EXPECT_THAT(case_of_file(write(falling)).doubts, ::testing::IsEmpty());
  std::string changed = falling;
  changed.replace(changed.find("-10]"), 4, "-20]");
  EXPECT_THAT(case_of_file(write(changed)).doubts,
              ::testing::ElementsAre(HasSubstr("truth[0].value: -5, but -10 by the closed form \"ballistic\"")));
}

// Several closed forms recognise bounce; that of the first impact ends at the second.
TEST(FindClosedForm, FindsTheOneThatIsValidLongest) {
  const Engine* found = find_closed_form(*parse_case("bounce").scene);
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->name, "bounce");
  EXPECT_EQ(find_closed_form({.bodies = {{.name = "none"}}, .joints = {Weld{}}}), nullptr);
}

// By each engine's own stepping.
TEST_F(SceneFileCase, OfAnExportedScenarioAllowsWhatTheScenarioAllows) {
  const Case built_in = parse_case("motor-arm:holds");
  const Case read = case_of_file(write(write_scene({*built_in.scene, truths_of(built_in).truth})));
  const auto before = built_in.scenario->expectations(built_in.parameters);
  const auto after = read.scenario->expectations({});
  ASSERT_EQ(after.size(), before.size());
  for (const EngineConfig& config : default_engines()) {
    const Stepping stepping = config.engine->stepping(config.settings, 1.0 / 60);
    for (std::size_t i = 0; i < after.size(); ++i) EXPECT_EQ(after[i].allowed(stepping), before[i].allowed(stepping));
  }
  EXPECT_TRUE(case_of_file(write(write_scene({*parse_case("bounce").scene, truths_of(parse_case("bounce")).truth})))
                  .scenario->phased);
}

// Its values are those of the scene that was exported.
TEST_F(SceneFileCase, LeavesOutTheTruthsOfAnExportedSceneThatWasChanged) {
  const Case built_in = parse_case("motor-arm:holds");
  SceneFile file{*built_in.scene, truths_of(built_in).truth};
  file.scene.name = "door";
  EXPECT_THAT(case_of_file(write(write_scene(file))).doubts, ::testing::IsEmpty());
  file.scene.bodies[1].linear_damping = 1;
  file.truth.push_back({.body = "arm", .quantity = Quantity::angle, .value = 1, .tolerance = 3, .source = "mine"});
  const Case changed = case_of_file(write(write_scene(file)));
  EXPECT_THAT(changed.doubts,
              ::testing::ElementsAre(HasSubstr("this scene differs from motor-arm:holds, whose values")));
  ASSERT_EQ(changed.scenario->expectations({}).size(), 1u);
  EXPECT_EQ(changed.scenario->expectations({})[0].source, "mine");
}

TEST_F(SceneFileCase, RefusesTheToleranceOfACaseThatAsksSomethingElse) {
  const auto complaint = [&](const std::string& of) {
    std::string text = falling;
    const std::string tolerance = "\"tolerance\": 0.001";
    text.replace(text.find(tolerance), tolerance.size(), "\"toleranceOf\": \"" + of + "\"");
    try {
      case_of_file(write(text));
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(complaint("bounce"), HasSubstr("truth[0].toleranceOf: \"bounce\" does not ask for this quantity"));
  EXPECT_THAT(complaint("bouncing"), HasSubstr("\"bouncing\" is no scenario"));
}

TEST(TruthsOf, HaveEveryCheckOfACase) {
  const Case test_case = parse_case("bounce");
  const StatedTruths stated = truths_of(test_case);
  EXPECT_EQ(stated.truth.size(), test_case.scenario->expectations(test_case.parameters).size());
  EXPECT_TRUE(stated.left_out.empty());
}

// Every scenario of the catalog can be exported: the file states the values of the closed form.
TEST_F(SceneFileCase, OfAnExportedScenarioExpectsTheSame) {
  for (const Case& test_case : default_cases(true)) {
    const StatedTruths stated = truths_of(test_case);
    EXPECT_EQ(stated.truth.size() + stated.left_out.size(),
              test_case.scenario->expectations(test_case.parameters).size());
    const Case read = case_of_file(write(write_scene({*test_case.scene, stated.truth})));
    const auto expectations = read.scenario->expectations({});
    ASSERT_EQ(expectations.size(), stated.truth.size());
    for (std::size_t i = 0; i < expectations.size(); ++i) {
      EXPECT_EQ(expectations[i].expected, stated.truth[i].value);
      EXPECT_EQ(expectations[i].relation, stated.truth[i].relation);
      EXPECT_EQ(expectations[i].index, stated.truth[i].index);
      EXPECT_EQ(expectations[i].over, stated.truth[i].over);
      EXPECT_EQ(expectations[i].other, stated.truth[i].with);
    }
    // A scene outside the limits of its scenario is outside those of its closed form too.
    const bool solved =
        test_case.closed_form != nullptr && test_case.closed_form->unsupported(*test_case.scene, {}).empty();
    EXPECT_EQ(read.closed_form != nullptr, solved) << test_case.scenario->name << ' ' << test_case.variant;
  }
}

TEST_F(SceneFileCase, AsksWithTheLinkOfItsSource) {
  std::string text = falling;
  text.insert(text.find("\"gravity\""), R"("source": "https://example.org/1", )");
  EXPECT_EQ(case_of_file(write(text)).scenario->question, "Does it fall? (https://example.org/1)");
}

// The names of the reported cases in which a truth fails.
std::set<std::string> missed_by(const std::string& engine) {
  std::set<std::string> names;
  for (const Case& one : reported_cases()) {
    const EngineConfig config = parse_engine("in-process:" + engine);
    constexpr double dt = 1.0 / 60;
    const Outcome outcome = run(*one.scene, config, dt);
    if (outcome.status != Status::ok) continue;
    const Stepping stepping = config.engine->stepping(config.settings, dt);
    const auto checks =
        check_expectations(*one.scene, one.scenario->expectations({}), *outcome.trace, stepping, nullptr);
    if (!std::ranges::all_of(checks, &TruthCheck::passed)) names.insert(one.scenario->name);
  }
  return names;
}

TEST(ReportedCases, ShowWhatWasReported) {
  const auto box2d = missed_by("box2d");
  for (const char* name :
       {"andengine-3-speed-limit", "box2d-89-minigolf", "love-1611-slow-bounce", "rapier-97-ball-on-box"})
    EXPECT_TRUE(box2d.contains(name)) << name;
}

TEST(ReportedCases, ArePassedByOurEngine) { EXPECT_THAT(missed_by("impulse"), ::testing::IsEmpty()); }

Body box(const std::string& name, Vec position) {
  return {.name = name, .position = position, .shapes = {{.geometry = Box{.size = {1, 1}}}}};
}

TEST(SceneWarnings, AreNoneForBodiesThatTouch) {
  EXPECT_THAT(warnings_about({.bodies = {box("a", {0, 0}), box("b", {0.995, 0})}}), IsEmpty());
}

TEST(SceneWarnings, NameBodiesThatStartInEachOther) {
  EXPECT_THAT(warnings_about({.bodies = {box("a", {0, 0}), box("b", {0.75, 0})}}),
              ElementsAre("bodies[1] (\"b\"): starts 0.25 m inside bodies[0] (\"a\")"));
}

TEST(SceneWarnings, NameAnglesThatMayBeDegrees) {
  Scene scene{.bodies = {box("a", {0, 0})}};
  scene.bodies[0].angle = 6.28;
  EXPECT_THAT(warnings_about(scene), IsEmpty());
  scene.bodies[0].angle = 45;
  EXPECT_THAT(warnings_about(scene),
              ElementsAre(AllOf(HasSubstr("bodies[0] (\"a\").angle: 45"), HasSubstr("0.785398"))));
}

TEST(SceneWarnings, NameDensitiesPerVolumeOfBodiesThatMove) {
  Scene scene{.bodies = {box("a", {0, 0})}};
  scene.bodies[0].shapes[0].surface.density = 1000;
  EXPECT_THAT(warnings_about(scene),
              ElementsAre(HasSubstr("bodies[0] (\"a\").shapes[0].density: 1000 kg/m^2 is per area")));
  scene.bodies[0].type = BodyType::fixed;
  EXPECT_THAT(warnings_about(scene), IsEmpty());
}

TEST(SceneWarnings, NameRodsThatStartStretched) {
  Distance rod{.a = 0, .b = 1, .anchor_a = {0, 0}, .anchor_b = {3, 0}, .length = 2};
  Scene scene{.bodies = {box("a", {0, 0}), box("b", {3, 0})}, .joints = {rod}};
  EXPECT_THAT(warnings_about(scene), ElementsAre("joints[0].length: is 2 m, but the anchors start 3 m apart"));
  rod.stiffness = 10;
  scene.joints = {rod};
  EXPECT_THAT(warnings_about(scene), IsEmpty()) << "a spring may be stretched";
}

TEST(SceneWarnings, NameScenesThatTakeMinutesWithoutTakingThem) {
  Scene heap;
  for (int i = 0; i < 5000; ++i) heap.bodies.push_back(box(std::to_string(i), {0, 0}));
  EXPECT_THAT(warnings_about(heap), ElementsAre(HasSubstr("most start in one place")));
  Scene many{.bodies = {box("a", {0, 0})}};
  many.bodies[0].shapes.assign(5000, many.bodies[0].shapes[0]);
  EXPECT_THAT(warnings_about(many), ElementsAre(HasSubstr("bodies[0] (\"a\"): has 5000 shapes")));
}

TEST(SceneWarnings, AreFewOfAKind) {
  Scene scene;
  for (int i = 0; i < 9; ++i) scene.bodies.push_back(box(std::to_string(i), {3.0 * i, 0}));
  for (Body& body : scene.bodies) body.angle = 90;
  EXPECT_THAT(warnings_about(scene), SizeIs(6));
  EXPECT_THAT(warnings_about(scene).back(), HasSubstr("and 4 more"));
}

}  // namespace
}  // namespace plumb::scene_file_test
