#include "scenarios/transformed.h"

#include <gtest/gtest.h>

#include "reference/simulation.h"
#include "scenarios/scene/mass.h"

namespace plumb::transformed_test {
namespace {

std::vector<BodyState> end_of(const Scene& scene) {
  const Engine& engine = *Catalog<Engine>::find("impulse");
  const auto simulation = engine.build(scene, complete(engine, {}));
  for (int i = 0; i < 60; ++i) simulation->step(1.0 / 60);
  std::vector<BodyState> states(scene.bodies.size());
  simulation->read(states);
  return states;
}

Scene default_scene(const Scenario& scenario) { return scenario.scene(complete(scenario, {})); }

TEST(Scaled, KeepsMassesAndScalesInertiaWithTheSquare) {
  for (const Scenario* scenario : Catalog<Scenario>::all()) {
    const Scene scene = default_scene(*scenario);
    const Scene larger = scaled(scene, 4);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      EXPECT_DOUBLE_EQ(mass_of(larger.bodies[i]).mass, mass_of(scene.bodies[i]).mass) << scenario->name;
      EXPECT_DOUBLE_EQ(mass_of(larger.bodies[i]).inertia, 16 * mass_of(scene.bodies[i]).inertia) << scenario->name;
    }
  }
}

// Free motion, joints and forces have no length scale of their own.
TEST(Scaled, ScalesTheMotion) {
  Scene pushed = default_scene(*Catalog<Scenario>::find("spinning-obb"));
  pushed.bodies = {pushed.bodies.back()};
  pushed.forces = {Constant{.body = 0, .force = {3, 1}, .torque = 0.5}};
  std::vector<Scene> scenes{pushed};
  for (const char* name : {"spring", "orbit", "pendulum", "double-pendulum", "heavy-object"}) {
    scenes.push_back(default_scene(*Catalog<Scenario>::find(name)));
  }
  for (const Scene& scene : scenes) {
    const auto original = end_of(scene);
    const auto larger = end_of(scaled(scene, 4));
    for (std::size_t i = 0; i < original.size(); ++i) {
      EXPECT_NEAR(larger[i].position.x, 4 * original[i].position.x, 1e-11) << scene.name;
      EXPECT_NEAR(larger[i].position.y, 4 * original[i].position.y, 1e-11) << scene.name;
      EXPECT_NEAR(larger[i].angle, original[i].angle, 1e-11) << scene.name;
    }
  }
}

TEST(Perturbed, MovesOnlyDynamicBodiesByAtMostTheSize) {
  const Scene scene = default_scene(*Catalog<Scenario>::find("stacking"));
  const Scene moved = perturbed(scene, 0.01, 1);
  EXPECT_EQ(moved.bodies[0].position, scene.bodies[0].position);
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
    EXPECT_NE(moved.bodies[i].position, scene.bodies[i].position);
    EXPECT_NEAR(moved.bodies[i].position.x, scene.bodies[i].position.x, 0.01);
    EXPECT_NEAR(moved.bodies[i].position.y, scene.bodies[i].position.y, 0.01);
  }
}

TEST(Perturbed, IsTheSameForTheSameSeed) {
  const Scene scene = default_scene(*Catalog<Scenario>::find("stacking"));
  EXPECT_EQ(perturbed(scene, 0.01, 1).bodies[1].position, perturbed(scene, 0.01, 1).bodies[1].position);
  EXPECT_NE(perturbed(scene, 0.01, 2).bodies[1].position, perturbed(scene, 0.01, 1).bodies[1].position);
}

}  // namespace
}  // namespace plumb::transformed_test
