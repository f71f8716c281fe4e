#include "scenarios/transformed.h"

#include <gtest/gtest.h>

#include "reference/simulation.h"
#include "scenarios/scene/mass.h"

namespace plumb {
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

TEST(Scaled, KeepsMassesAndSquaresArms) {
  for (const Scenario* scenario : Catalog<Scenario>::all()) {
    const Scene scene = default_scene(*scenario);
    const Scene larger = scaled(scene, 4);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      EXPECT_DOUBLE_EQ(mass_of(larger.bodies[i]).mass, mass_of(scene.bodies[i]).mass) << scenario->name;
      EXPECT_DOUBLE_EQ(mass_of(larger.bodies[i]).inertia, 16 * mass_of(scene.bodies[i]).inertia) << scenario->name;
    }
  }
}

// Free motion, joints and forces have no length of their own.
TEST(Scaled, MovesAlike) {
  Scene pushed = default_scene(*Catalog<Scenario>::find("spinning-obb"));
  pushed.bodies = {pushed.bodies.back()};
  pushed.forces = {Constant{.body = 0, .force = {3, 1}, .torque = 0.5}};
  std::vector<Scene> scenes{pushed};
  for (const char* name : {"spring", "orbit", "pendulum", "double-pendulum", "heavy-object"}) {
    scenes.push_back(default_scene(*Catalog<Scenario>::find(name)));
  }
  for (const Scene& scene : scenes) {
    const auto as_asked = end_of(scene);
    const auto larger = end_of(scaled(scene, 4));
    for (std::size_t i = 0; i < as_asked.size(); ++i) {
      EXPECT_NEAR(larger[i].position.x, 4 * as_asked[i].position.x, 1e-11) << scene.name;
      EXPECT_NEAR(larger[i].position.y, 4 * as_asked[i].position.y, 1e-11) << scene.name;
      EXPECT_NEAR(larger[i].angle, as_asked[i].angle, 1e-11) << scene.name;
    }
  }
}

}  // namespace
}  // namespace plumb
