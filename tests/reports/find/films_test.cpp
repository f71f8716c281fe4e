#include "reports/find/films.h"

#include <gtest/gtest.h>

#include "scenarios/parts.h"

namespace plumb::films_test {
namespace {

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
}  // namespace plumb::films_test
