#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "reference/simulation.h"
#include "reports/run/experiment.h"
#include "reports/run/selection.h"
#include "scenes.h"

namespace plumb::impulse_test {
namespace {

using namespace adapter_tests;

constexpr double dt = 1.0 / 60;

const Engine& engine() { return *Catalog<Engine>::find("impulse"); }

const Option& option(const std::string& key) {
  for (const Option& known : engine().options) {
    if (known.key == key) return known;
  }
  throw std::out_of_range(key);
}

Scene falling(Geometry geometry) {
  Scene scene = scene_of({body_of(BodyType::dynamic, {0, 10}, std::move(geometry))});
  scene.bodies[0].shapes[0].surface = {};
  return scene;
}

BodyState last(const Scene& scene, const Settings& settings, int steps) {
  return last_state(engine(), scene, settings, steps);
}

TEST(Impulse, OffersEveryMethodOfTheEngineWithADescription) {
  for (const char* key : {"solver", "integrator", "broad-phase"}) {
    EXPECT_FALSE(option(key).choices.empty()) << key;
    for (const auto& [choice, about] : option(key).choices) EXPECT_NE(about, "") << choice;
  }
}

TEST(Impulse, FallsByTheDriftOfTheIntegratorChosen) {
  for (const auto& [integrator, about] : option("integrator").choices) {
    const Settings settings{{"solver", "article"}, {"integrator", integrator}};
    const Stepping stated = engine().stepping(settings, dt);
    const int n = 60;
    const double error = last(falling(Circle{}), settings, n).position.y - 5;
    // n roundings of heights below 16 m.
    EXPECT_NEAR(error, -10 * stated.drift * n * dt * stated.h, n * 16 * stated.epsilon) << integrator;
  }
}

TEST(Impulse, RunsInEitherPrecision) {
  EXPECT_EQ(engine().stepping({{"precision", "float"}}, dt).epsilon, std::ldexp(1.0, -24));
  EXPECT_EQ(engine().stepping({{"precision", "double"}}, dt).epsilon, std::ldexp(1.0, -53));
  const double in_float = last(falling(Circle{}), {{"precision", "float"}}, 31).position.y;
  EXPECT_EQ(in_float, static_cast<double>(static_cast<float>(in_float)));
  // After 31/60 s the height has no finite binary expansion: the two precisions must round it differently.
  EXPECT_NE(in_float, last(falling(Circle{}), {}, 31).position.y);
}

// 25 m in a step, through a disc 1 m wide.
TEST(Impulse, TunnelsOnlyWithoutContinuousCollision) {
  const auto end = [](const char* continuous) {
    Scene scene = falling(Circle{});
    scene.gravity = {};
    Body wall = scene.bodies[0];
    wall.type = BodyType::fixed;
    scene.bodies[0].velocity = {0, 1500};
    scene.bodies[0].position = {0, -3};
    scene.bodies.insert(scene.bodies.begin(), wall);
    return last(scene, {{"solver", "article"}, {"continuous", continuous}}, 3).position.y;
  };
  EXPECT_GT(end("off"), 10);
  EXPECT_LT(end("auto"), 10);
  EXPECT_LT(end("on"), 10);
}

TEST(Impulse, SleepsOnlyIfTheOptionIsOn) {
  Scene scene = falling(Circle{.5});
  scene.gravity = {};
  scene.bodies[0].velocity = {1e-5, 0};
  EXPECT_GT(last(scene, {}, 120).velocity.x, 0);
  EXPECT_EQ(last(scene, {{"sleeping", "on"}}, 120).velocity.x, 0);
}

TEST(Impulse, RefusesPolygonsThatTheEngineRejects) {
  EXPECT_NE(engine().unsupported(falling(Polygon{regular_polygon(9)}), {}), "");
  EXPECT_EQ(engine().unsupported(falling(Circle{}), {}), "");
}

TEST(Impulse, RunsJoints) {
  Scene scene = falling(Circle{});
  scene.bodies.push_back(scene.bodies[0]);
  scene.bodies[1].position = {2, 10};
  scene.joints.push_back(Revolute{0, 1, {1, 10}});
  EXPECT_EQ(engine().unsupported(scene, {{"solver", "article"}}), "");
  EXPECT_EQ(engine().unsupported(scene, {{"solver", "accurate"}}), "");
}

// The engine evaluates forces itself, so a second-order method keeps its order: halving the step quarters the error of
// an oscillation. Forces applied from outside once a step would reduce it to first order.
TEST(Impulse, KeepsTheOrderOfItsIntegratorUnderForces) {
  Scene scene = falling(Box{});
  scene.gravity = {};
  scene.bodies[0].position = {1, 0};
  scene.forces.push_back(Spring{{}, 0, {0, 0}, {0, 0}, 25, 0, 0});
  const auto error = [&](int steps) {
    const std::unique_ptr<Simulation> simulation =
        engine().build(scene, {{"solver", "article"}, {"integrator", "velocity-verlet"}});
    for (int i = 0; i < steps; ++i) simulation->step(1.0 / steps);
    std::vector<BodyState> states(1);
    simulation->read(states);
    return std::abs(states[0].position.x - std::cos(5.0));
  };
  EXPECT_NEAR(error(60) / error(120), 4, .1);
}

TEST(Impulse, ChoosesOnlyOptionsThatAreAtTheirDefault) {
  const Scene alone = falling(Circle{});
  EXPECT_TRUE(engine().chooses(alone, {}).empty());
  const auto chosen = [&](Settings settings) {
    settings["model"] = "auto";
    std::vector<std::string> keys;
    for (const Choice& choice : engine().chooses(alone, settings)) keys.push_back(choice.option);
    return keys;
  };
  const auto all = chosen({});
  EXPECT_NE(std::find(all.begin(), all.end(), "rotation"), all.end());
  const auto less = chosen({{"friction", "dynamic"}});
  EXPECT_EQ(less.size() + 1, all.size());
  EXPECT_EQ(std::find(less.begin(), less.end(), "friction"), less.end());
}

TEST(Impulse, LeavesOutRotationFrictionAndRestitution) {
  Scene scene = falling(Box{});
  scene.bodies[0].angular_velocity = 3;
  EXPECT_NEAR(last(scene, {}, 60).angle, 3, 1e-12);
  EXPECT_EQ(last(scene, {{"rotation", "off"}}, 60).angle, 0);
  scene.bodies[0].angular_velocity = 0;
  scene.bodies[0].position = {0, 0.5};
  scene.bodies[0].velocity = {1, 0};
  Body ground;
  ground.type = BodyType::fixed;
  ground.shapes = {{HalfSpace{}, {1, 0.5, 0.5, 0}}};
  scene.bodies[0].shapes[0].surface = {1, 0.5, 0.5, 0};
  scene.bodies.insert(scene.bodies.begin(), ground);
  EXPECT_LT(last(scene, {}, 60).velocity.x, 0.01);
  EXPECT_NEAR(last(scene, {{"friction", "off"}}, 60).velocity.x, 1, 1e-9);
  for (Body& body : scene.bodies) body.shapes[0].surface.restitution = 1;
  scene.bodies[1].position.y = 2;
  EXPECT_GT(last(scene, {}, 60).velocity.y, 0.5);
  EXPECT_NEAR(last(scene, {{"restitution", "off"}}, 60).velocity.y, 0, 0.01);
}

}  // namespace
}  // namespace plumb::impulse_test
