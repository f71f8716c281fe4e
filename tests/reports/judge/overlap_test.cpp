#include "reports/judge/overlap.h"

#include <gtest/gtest.h>

#include "reports/judge/conserved.h"
#include "scenarios/scenario.h"

namespace plumb {
namespace {

Body box_at(double x, double y) {
  return {.name = "box", .position = {x, y}, .shapes = {{.geometry = Box{.size = {1, 1}}}}};
}

Body context() { return {.name = "context", .type = BodyType::fixed, .shapes = {{.geometry = HalfSpace{}}}}; }

double deepest(const Scene& scene) { return Overlap(scene).deepest(initial_states(scene)).depth; }

TEST(Overlap, FindsTheDeepestPair) {
  EXPECT_NEAR(deepest({.bodies = {context(), box_at(0, 0.49), box_at(0, 1.46), box_at(8, 4)}}), 0.03, 1e-12);
  EXPECT_EQ(deepest({.bodies = {context(), box_at(0, 0.5), box_at(0, 1.5)}}), 0);
}

TEST(Overlap, LeavesOutWhatMayNotTouch) {
  Scene layers{.bodies = {box_at(0, 0), box_at(0.5, 0)}};
  EXPECT_NEAR(deepest(layers), 0.5, 1e-12);
  layers.bodies[0].layers = 1;
  layers.bodies[1].layers = 2;
  EXPECT_EQ(deepest(layers), 0);

  Scene jointed{.bodies = {box_at(0, 0), box_at(0.5, 0)}};
  jointed.joints = {Revolute{.a = 1, .b = 0}};
  EXPECT_EQ(deepest(jointed), 0);

  Scene fixed{.bodies = {box_at(0, 0), box_at(0.5, 0)}};
  fixed.bodies[0].type = fixed.bodies[1].type = BodyType::fixed;
  EXPECT_EQ(deepest(fixed), 0);
}

TEST(Overlap, PlacesShapesAroundTheCentreOfMass) {
  Body shifted = box_at(0, 0.4);
  shifted.shapes[0].geometry = Box{.size = {1, 1}, .center = {3, 0}};
  EXPECT_NEAR(deepest({.bodies = {context(), shifted}}), 0.1, 1e-12);
}

// Round-off alone, whatever a family is asked for; the largest scenes only repeat their pattern.
TEST(Overlap, IsThereInNoSceneOfTheCatalogAtItsStart) {
  for (const Scenario* scenario : Catalog<Scenario>::all()) {
    std::vector<Parameters> settings{complete(*scenario, {})};
    for (const Variant& variant : scenario->variants) settings.push_back(complete(*scenario, variant.changes));
    for (const Parameter& parameter : scenario->parameters) {
      settings.push_back(complete(*scenario, {{parameter.name, parameter.min}}));
      settings.push_back(complete(*scenario, {{parameter.name, parameter.max}}));
    }
    for (const Parameters& parameters : settings) {
      const Scene scene = scenario->scene(parameters);
      if (scene.bodies.size() > 2000) continue;
      EXPECT_LT(deepest(scene), 1e-9) << scenario->name << ' ' << scene.bodies.size();
    }
  }
}

}  // namespace
}  // namespace plumb
