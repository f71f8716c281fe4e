#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "reports/find/finding.h"
#include "reports/find/summary.h"
#include "reports/system/files.h"
#include "reports/system/layout.h"
#include "reports/writers/junit.h"
#include "scenarios/parts.h"
#include "scenarios/scene/scene_json.h"

namespace plumb::finding_test {
namespace {

Finding finding() {
  Finding of{.engine = "box2d:velocity=2",
             .complaint = {.judge = "invariant", .what = "energy", .unit = "J", .value = 2, .tolerance = 1, .ratio = 2},
             .from = "drop/3",
             .drawn_bodies = 7};
  of.scene = {.name = "scene", .bodies = {level_ground({}), disc("ball", {0, 0.5}, 0.5, {})}};
  of.run.touching = {{0, 1}};
  return of;
}

TEST(Finding, IsNamedByItsContent) {
  Finding one = finding();
  EXPECT_EQ(one.name(), finding().name());
  EXPECT_TRUE(one.name().starts_with("box2d-velocity-2-energy-")) << one.name();
  one.scene.bodies[1].position.y = 0.6;
  EXPECT_NE(one.name(), finding().name());
  EXPECT_EQ(one.signature(), finding().signature()) << "the same fault elsewhere";
  one.scene.bodies[1] = box("ball", {0, 0.5}, {1, 1}, {});
  EXPECT_NE(one.signature(), finding().signature());
}

// Bodies that could touch, but did not before it failed, are of no matter.
TEST(Finding, IsToldOnceByThePairsThatTouch) {
  const Finding one = finding();
  Finding other = finding();
  other.scene.bodies.push_back(disc("far", {9, 9}, 0.5, {}));
  EXPECT_EQ(other.signature(), one.signature());
  other.run.touching.push_back({1, 2});
  EXPECT_NE(other.signature(), one.signature());
}

TEST(Finding, WritesTheImageWithWhichItBreaksARelation) {
  Finding one = finding();
  EXPECT_EQ(one.image_file(), "");
  one.run.image = Image{one.scene, 1.0 / 240};
  const Scene image = read_scene(one.image_file(), "image").scene;
  EXPECT_EQ(image.name, one.name() + ".image");
  EXPECT_NE(image.about.find("0.00416667 s"), std::string::npos) << image.about;
}

TEST(Finding, SaysInItsFileHowToRunItAgain) {
  for (const Posed posed : {Posed::well, Posed::ambiguous, Posed::impossible, Posed::overlapping}) {
    Finding one = finding();
    one.posed = posed;
    const SceneFile file = read_scene(one.file(5), "found");
    ASSERT_TRUE(file.origin.has_value());
    EXPECT_EQ(file.origin->engine, "box2d:velocity=2");
    EXPECT_EQ(file.origin->posed, posed);
  }
}

TEST(Finding, IsTheSameAfterWritingAndReading) {
  Finding one = finding();
  one.complaint.ratio = std::numeric_limits<double>::infinity();
  const Finding other = finding_of(as_json(one));
  EXPECT_EQ(as_json(other).dump(), as_json(one).dump());
  EXPECT_EQ(other.name(), one.name());
}

Opinion opinion(double rise, double overlap, const std::string& judge = "") {
  Opinion of{.status = "ok", .energy_rise = rise, .overlap = overlap};
  if (!judge.empty()) of.complaints.push_back({.judge = judge, .what = "x"});
  if (judge == "run") of.status = "failed";
  return of;
}

TEST(Ruler, ComparesOnlyScenesThatAllEnginesRan) {
  const auto engines = measured_alike({{"a", {opinion(0.5, 1), opinion(0.002, 0.1), opinion(0, 0.2, "invariant")}},
                                       {"b", {opinion(0, 0, "run"), opinion(0.02, 0.3), opinion(0.0005, 0.5)}}});
  ASSERT_EQ(engines.size(), 2U);
  EXPECT_EQ(engines[0].compared, 2);
  EXPECT_EQ(engines[0].wrong, 1);
  EXPECT_EQ(engines[0].failed, 0);
  EXPECT_EQ(engines[1].failed, 1);
  EXPECT_EQ(engines[1].wrong, 0);
  EXPECT_DOUBLE_EQ(engines[0].above_thousandth, 0.5);
  EXPECT_DOUBLE_EQ(engines[0].above_hundredth, 0);
  EXPECT_DOUBLE_EQ(engines[1].above_hundredth, 0.5);
  EXPECT_DOUBLE_EQ(engines[0].overlap_median, 0.15);
  EXPECT_DOUBLE_EQ(engines[1].overlap_high, 0.5);
}

TEST(Tables, ShowWhateverANameContainsAsText) {
  const std::vector<TestCase> cases{{"a<b", "e", ""}, {"c", "e&f", "off \"by\" 2"}};
  const std::string xml = junit("plumb find", cases);
  EXPECT_NE(xml.find("tests=\"2\" failures=\"1\""), xml.npos);
  EXPECT_NE(xml.find("a&lt;b"), xml.npos);
  EXPECT_NE(xml.find("off &quot;by&quot; 2"), xml.npos);
  const std::vector<std::vector<std::string>> rows{{"x", "long head"}, {"a|b", "1"}};
  EXPECT_EQ(markdown_table(rows), "| x | long head |\n|---|---|\n| a&#124;b | 1 |\n");
}

// A ball falls on the ground beside one that does not get there.
Scene two_balls() {
  Scene scene{.name = "balls", .duration = 0.3};
  scene.bodies = {level_ground({}), disc("low", {0, 0.6}, 0.5, {}), disc("high", {5, 3}, 0.5, {})};
  return scene;
}

Complaint complaint(const char* judge, const char* what) { return {.judge = judge, .what = what, .time = 0.3}; }

TEST(RunToShow, TellsWhichBodiesTouch) {
  const Suspect impulse = parse_suspects("impulse").front();
  const FailingRun shown = run_to_show(two_balls(), complaint("invariant", "energy"), impulse, {});
  EXPECT_EQ(shown.touching, (std::vector<BodyPair>{{0, 1}}));
  EXPECT_FALSE(shown.image.has_value());
}

TEST(RunToShow, FilmsAnEngineBesideAnotherInOneScene) {
  const Suspect box2d = parse_suspects("box2d").front();
  const Suspect impulse = parse_suspects("impulse").front();
  const FailingRun shown = run_to_show(two_balls(), complaint("invariant", "energy"), box2d, {&impulse, 1});
  ASSERT_EQ(shown.films.size(), 1U);
  ASSERT_EQ(shown.films[0]["runs"].size(), 2U);
  EXPECT_EQ(shown.films[0]["runs"][0]["engine"], "box2d");
  EXPECT_EQ(shown.films[0]["runs"][1]["engine"], "impulse");
}

TEST(RunToShow, FilmsAnEngineBesideTheClosedFormThatKnowsTheScene) {
  Scene scene{.name = "throw", .duration = 0.5, .bodies = {disc("ball", {}, 0.5, {})}};
  const Suspect box2d = parse_suspects("box2d").front();
  const FailingRun shown = run_to_show(scene, complaint("closed form", "y"), box2d, {});
  ASSERT_EQ(shown.films[0]["runs"].size(), 2U);
  EXPECT_TRUE(is_closed_form(shown.films[0]["runs"][1]["engine"].get<std::string>()));
}

TEST(RunToShow, FilmsASceneBesideItsImage) {
  const Suspect impulse = parse_suspects("impulse").front();
  for (const char* relation : {"mirror", "units", "halves", "stranger"}) {
    const FailingRun shown = run_to_show(two_balls(), complaint("relation", relation), impulse, {});
    ASSERT_TRUE(shown.image.has_value()) << relation;
    ASSERT_EQ(shown.films.size(), 2U) << relation;
    EXPECT_EQ(shown.films[0]["variant"], "scene");
    EXPECT_EQ(shown.films[1]["variant"], std::string("image: ") + relation);
    const FailingRun again = failing_run_of(as_json(shown));
    EXPECT_EQ(as_json(again).dump(), as_json(shown).dump());
  }
}

}  // namespace
}  // namespace plumb::finding_test
