#include "reference/exact/closed_form.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::closed_form_test {
namespace {

TEST(ClosedForms, AreAllInTheCatalog) {
  std::vector<std::string> names;
  for (const Engine* engine : Catalog<Engine>::all()) {
    if (engine->exact) names.push_back(engine->name);
  }
  EXPECT_THAT(names, testing::ElementsAre("arch", "ballistic", "beam", "bounce", "first-impact", "ladder", "line",
                                          "orbit", "pendulum", "plank", "rest", "roll", "slide", "spring", "topple"));
}

TEST(Engines, NameTheirSource) {
  for (const Engine* engine : Catalog<Engine>::all()) {
    EXPECT_NE(engine->source, "") << engine->name;
  }
}

// Whether a variant takes expected values from the closed form. One that states them all itself may be beyond it: a
// tower that falls is not in equilibrium.
bool needs_closed_form(const Scenario& scenario, const Variant& variant) {
  const auto all = scenario.expectations(complete(scenario, variant.changes));
  return std::any_of(all.begin(), all.end(), [](const Expectation& one) { return !one.expected; });
}

TEST(ClosedForms, AcceptEveryVariantThatNeedsThem) {
  for (const Scenario* scenario : Catalog<Scenario>::all()) {
    if (scenario->closed_form.empty()) continue;
    const Engine* form = Catalog<Engine>::find(scenario->closed_form);
    ASSERT_NE(form, nullptr) << scenario->name;
    for (const Variant& variant : scenario->variants) {
      if (!needs_closed_form(*scenario, variant)) continue;
      const Scene scene = scenario->scene(complete(*scenario, variant.changes));
      EXPECT_EQ(form->unsupported(scene, {}), "") << scenario->name << ' ' << variant.label;
    }
  }
}

TEST(ClosedForms, StartWhereTheirSceneDoesAndHoldUntilTheLastExpectation) {
  for (const Scenario* scenario : Catalog<Scenario>::all()) {
    if (scenario->closed_form.empty()) continue;
    for (const Variant& variant : scenario->variants) {
      if (!needs_closed_form(*scenario, variant)) continue;
      const Parameters parameters = complete(*scenario, variant.changes);
      const Scene scene = scenario->scene(parameters);
      const auto simulation = Catalog<Engine>::find(scenario->closed_form)->build(scene, {});
      std::vector<BodyState> states(scene.bodies.size());
      simulation->read(states);
      for (std::size_t i = 0; i < states.size(); ++i) {
        EXPECT_NEAR(states[i].position.x, scene.bodies[i].position.x, 1e-14) << scenario->name;
        EXPECT_NEAR(states[i].position.y, scene.bodies[i].position.y, 1e-14) << scenario->name;
        EXPECT_NEAR(states[i].angle, scene.bodies[i].angle, 1e-14) << scenario->name;
        EXPECT_NEAR(states[i].velocity.x, scene.bodies[i].velocity.x, 1e-15) << scenario->name;
      }
      for (const Expectation& expectation : scenario->expectations(parameters)) {
        if (expectation.expected) continue;
        EXPECT_LE(expectation.time.value_or(scene.duration), simulation->valid_until())
            << scenario->name << ' ' << variant.label;
      }
    }
  }
}

TEST(ClosedForm, RefusesToBuildWhatItDoesNotSupport) {
  EXPECT_THROW(Catalog<Engine>::find("bounce")->build(Scene{.name = "empty"}, {}), std::invalid_argument);
}

TEST(ClosedForm, RefusesBodiesOnPaths) {
  Scene scene{.name = "drop", .bodies = {disc("ball", {0, 0}, 0.5, {}), disc("lift", {9, 0}, 0.5, {})}};
  scene.bodies[0].layers = 1;
  scene.bodies[1].layers = 2;
  scene.bodies[1].type = BodyType::kinematic;
  const Engine& fall = *Catalog<Engine>::find("ballistic");
  EXPECT_EQ(fall.unsupported(scene, {}), "");
  scene.bodies[1].path = Path{.amplitude = {0, 1}};
  EXPECT_NE(fall.unsupported(scene, {}), "");
  EXPECT_THROW(fall.build(scene, {}), std::invalid_argument);
}

TEST(ElapsedTime, DoesNotDriftOverAMillionSteps) {
  ElapsedTime elapsed;
  for (int i = 0; i < 1000000; ++i) elapsed.add(1.0 / 60);
  EXPECT_NEAR(elapsed.seconds(), 1000000 / 60.0, 4e-12);  // one ulp of the sum
}

}  // namespace
}  // namespace plumb::closed_form_test
