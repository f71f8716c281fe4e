#include "scenarios/catalog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::catalog_test {
namespace {

TEST(Scenarios, AreInTheGroupOfTheirFolder) {
  EXPECT_EQ(Catalog<Scenario>::find("slope")->group, "friction");
  EXPECT_EQ(Catalog<Scenario>::find("stacking")->group, "stacks");
}

TEST(Scenarios, AreAllRegistered) {
  std::vector<std::string> names;
  for (const Scenario* scenario : Catalog<Scenario>::all()) names.push_back(scenario->name);
  EXPECT_THAT(
      names,
      testing::ElementsAre(
          "arc-bowl", "arch", "beam", "beats", "bifilar", "billiard", "bounce", "bowl", "box-on-box", "breakaway",
          "cantilever", "capsule-heap", "capsules", "card-house", "catenary", "chain-modes", "chain-row",
          "closing-walls", "conveyor", "corner-grip", "corner-impact", "corner-spin", "cradle", "crowd", "damped-slide",
          "disc-on-wedge", "disc-pair", "disc-pile", "dome", "dominoes", "double-pendulum", "dry-oscillator",
          "dumbbells", "flush-tiles", "flyby", "four-bar", "free-bodies", "free-four-bar", "free-wedge", "gas",
          "grazing", "hanging-chain", "head-on", "heavy-object", "held-pyramid", "hinged-hit", "joined-pair",
          "joint-grid", "joint-stop", "juggler", "kater", "ladder", "late-blow", "layers", "limiting-friction",
          "lone-bodies", "lost-support", "many-pyramids", "mass-ratio", "materials", "mixing-rules", "motor",
          "motor-arm", "motor-hub", "motor-lift", "oblique-disc", "off-center", "orbit", "overhang", "paddle",
          "painleve-rod", "peaucellier", "pendulum", "pi-billiard", "pressed-box", "pulled-chain", "pushed-plank",
          "pyramid", "rail-stop", "rain", "restitution-rules", "rocking-block", "rod-hit", "rod-pendulum",
          "rod-toppling", "rope-bridge", "settling-tower", "slider", "slider-crank", "sliding-ladder",
          "sliding-pyramid", "slip-to-roll", "slope", "slope-disc", "smash", "soft-joint", "spin-up", "spinning-obb",
          "spring", "spring-ellipse", "spring-stop", "stacking", "step-climb", "stick-slip", "stopping-distance",
          "struck-net", "struck-wall", "table-edge", "tautochrone", "teams", "thin-wall", "thrown-wall", "tipping",
          "touching-cradle", "tower-row", "tumbler", "turning-rail", "two-frictions"));
}

TEST(Scenarios, AreAsManyAsTheReadmeSays) {
  std::ifstream readme(PLUMB_SOURCE_DIR "/README.md");
  const std::string text{std::istreambuf_iterator<char>(readme), {}};
  const std::string families = std::to_string(Catalog<Scenario>::all().size()) + " families of scenes";
  EXPECT_THAT(text, testing::HasSubstr(families));
}

TEST(Scenarios, BelongToGroupsThatSayWhatIsAtStakeAsTheReadmeDoes) {
  std::ifstream readme(PLUMB_SOURCE_DIR "/scenarios/README.md");
  const std::string text{std::istreambuf_iterator<char>(readme), {}};
  std::set<std::string> used;
  for (const Scenario* scenario : Catalog<Scenario>::all()) {
    EXPECT_NE(Catalog<ScenarioGroup>::find(scenario->group), nullptr) << scenario->name;
    used.insert(scenario->group);
  }
  for (const ScenarioGroup* group : Catalog<ScenarioGroup>::all()) {
    EXPECT_TRUE(used.contains(group->name)) << group->name << " has no family";
    EXPECT_THAT(text, testing::HasSubstr("| " + group->title + " | " + group->stake + " |"));
  }
}

TEST(Scenarios, InTheShortReportAreTheFourCanonicalOnes) {
  std::vector<std::string> names;
  for (const Scenario* scenario : Catalog<Scenario>::all()) {
    if (scenario->canonical) names.push_back(scenario->name);
  }
  EXPECT_THAT(names, testing::ElementsAre("bounce", "slope", "spinning-obb", "stacking"));
}

// Every variant of every family must give a valid scene: unique names, and a duration on the grid of 1/60 s.
TEST(Scenarios, BuildWellFormedScenes) {
  for (const Scenario* scenario : Catalog<Scenario>::all()) {
    EXPECT_NE(scenario->question, "") << scenario->name;
    ASSERT_FALSE(scenario->variants.empty()) << scenario->name;
    std::set<std::string> labels;
    for (const Variant& variant : scenario->variants) {
      EXPECT_TRUE(labels.insert(variant.label).second) << scenario->name << ' ' << variant.label;
      const Scene scene = scenario->scene(complete(*scenario, variant.changes));
      EXPECT_EQ(scene.name, scenario->name);
      EXPECT_NEAR(scene.duration * 60, std::round(scene.duration * 60), 1e-9) << scenario->name;
      std::set<std::string> bodies;
      for (const Body& body : scene.bodies) {
        EXPECT_TRUE(bodies.insert(body.name).second) << scenario->name << ' ' << body.name;
        EXPECT_EQ(mass_of(body).mass > 0, body.type == BodyType::dynamic) << scenario->name << ' ' << body.name;
      }
    }
  }
}

// The defaults, and each parameter at both ends of its range.
std::vector<Parameters> corners_of(const Scenario& scenario) {
  std::vector<Parameters> all{complete(scenario, {})};
  for (const Parameter& parameter : scenario.parameters) {
    for (const double value : {parameter.min, parameter.max})
      all.push_back(complete(scenario, {{parameter.name, value}}));
  }
  return all;
}

bool is_finite(const Body& body) {
  return std::isfinite(body.position.x) && std::isfinite(body.position.y) && std::isfinite(body.angle) &&
         std::isfinite(body.velocity.x) && std::isfinite(body.velocity.y) && std::isfinite(body.angular_velocity);
}

TEST(Scenarios, CanBeBuiltAtBothEndsOfEveryParameter) {
  for (const Scenario* scenario : Catalog<Scenario>::all()) {
    for (const Parameters& parameters : corners_of(*scenario)) {
      const Scene scene = scenario->scene(parameters);
      EXPECT_FALSE(scene.bodies.empty()) << scenario->name;
      for (const Body& body : scene.bodies) {
        EXPECT_TRUE(is_finite(body)) << scenario->name << ' ' << body.name;
        EXPECT_EQ(mass_of(body).mass > 0, body.type == BodyType::dynamic) << scenario->name << ' ' << body.name;
      }
      for (const Expectation& expectation : scenario->expectations(parameters)) {
        EXPECT_TRUE(std::isfinite(expectation.expected.value_or(0))) << scenario->name << ' ' << expectation.body;
      }
    }
  }
}

TEST(Scenarios, AreDeterministic) {
  for (const Scenario* scenario : Catalog<Scenario>::all()) {
    const Scene once = scenario->scene(complete(*scenario, {}));
    const Scene again = scenario->scene(complete(*scenario, {}));
    ASSERT_EQ(once.bodies.size(), again.bodies.size()) << scenario->name;
    for (std::size_t i = 0; i < once.bodies.size(); ++i) {
      const Body& a = once.bodies[i];
      const Body& b = again.bodies[i];
      EXPECT_EQ(a.name, b.name) << scenario->name;
      EXPECT_EQ(a.position, b.position) << scenario->name << ' ' << a.name;
      EXPECT_EQ(a.velocity, b.velocity) << scenario->name << ' ' << a.name;
      EXPECT_EQ(a.angle, b.angle) << scenario->name << ' ' << a.name;
      EXPECT_EQ(mass_of(a).mass, mass_of(b).mass) << scenario->name << ' ' << a.name;
    }
  }
}

TEST(Scenarios, ExpectOnlyOfBodiesThatExist) {
  for (const Scenario* scenario : Catalog<Scenario>::all()) {
    for (const Variant& variant : scenario->variants) {
      const Parameters parameters = complete(*scenario, variant.changes);
      const Scene scene = scenario->scene(parameters);
      std::set<std::string> bodies{""};
      for (const Body& body : scene.bodies) bodies.insert(body.name);
      for (const Expectation& expectation : scenario->expectations(parameters)) {
        EXPECT_TRUE(bodies.count(expectation.body)) << scenario->name << ' ' << expectation.body;
        EXPECT_NE(expectation.source, "") << scenario->name;
        EXPECT_TRUE(bodies.count(expectation.other)) << scenario->name << ' ' << expectation.other;
        // A closed form has no value for a quantity of a whole run.
        const bool of_a_moment = expectation.quantity < Quantity::load && expectation.over == 0;
        EXPECT_TRUE(expectation.expected || (of_a_moment && !scenario->closed_form.empty())) << scenario->name;
      }
    }
  }
}

// A tolerance is derived from the method: it must be finite at 60 steps a second, decrease with the step, and be only
// round-off for an exact method.
TEST(Scenarios, AllowLessWithFinerStepsAndOnlyRoundOffIfExact) {
  const auto stepping = [](double h) { return Stepping{.dt = h, .h = h, .drift = 0.5, .epsilon = 0x1p-53}; };
  const Stepping exact{.dt = 1e-11, .impact_lag = 0, .epsilon = 0x1p-53};
  for (const Scenario* scenario : Catalog<Scenario>::all()) {
    for (const Variant& variant : scenario->variants) {
      for (const Expectation& expectation : scenario->expectations(complete(*scenario, variant.changes))) {
        const std::string what =
            scenario->name + ' ' + variant.label + ' ' + expectation.body + ' ' + name_of(expectation.quantity);
        const double coarse = expectation.allowed(stepping(1.0 / 60));
        const double fine = expectation.allowed(stepping(1.0 / 960));
        EXPECT_TRUE(std::isfinite(coarse) && fine > 0) << what;
        // Three tolerances are physical: the last sector of pi-billiard, half a wall that nothing may pass, and the
        // distance of a few hundred discs from Maxwell's law.
        if (what == "thin-wall fast bullet x" || (scenario->name == "pi-billiard" && !expectation.body.empty()) ||
            expectation.quantity == Quantity::speed_spread)
          continue;
        EXPECT_TRUE(coarse < 1e-6 || fine < coarse / 4) << what << ' ' << coarse << ' ' << fine;
        EXPECT_LT(expectation.allowed(exact), 1e-8) << what;
      }
    }
  }
}

}  // namespace
}  // namespace plumb::catalog_test
