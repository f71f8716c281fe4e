// What every adapter must satisfy in motion and in joints, and for which engines all tests of this kind run.

#include "tests/reference/adapters/every_engine.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>

#include "scenarios/scene/mass.h"

namespace plumb::every_engine_test {
namespace {

TEST_P(EveryEngine, FallsAsItsStatedDriftSays) {
  const int n = 60;
  const BodyState fallen = run(scene_of({box({0, 10})}), n).at(0);
  const Stepping is = stated();
  const double t = n * dt;
  EXPECT_NEAR(fallen.position.y, 10 - g * t * t / 2 - is.drift * g * t * is.h, rounding(n, 2 * 10));
  EXPECT_NEAR(fallen.velocity.y, -g * t, rounding(n, g * t));
}

TEST_P(EveryEngine, ReportsStatesInSceneOrder) {
  const Scene scene = scene_of({box({0, 5}), ground(), box({3, 7}), box({6, 9})});
  const std::vector<BodyState> states = run(scene, 0);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    EXPECT_NEAR(states[i].position.x, scene.bodies[i].position.x, rounding(1, 10));
    EXPECT_NEAR(states[i].position.y, scene.bodies[i].position.y, rounding(1, 10));
  }
}

// An L of two boxes, turned: its centre of mass is not its origin.
TEST_P(EveryEngine, StartsAndSpinsAboutTheCentreOfMass) {
  Body el = body("el", BodyType::dynamic, {1, 2}, Box{{2, .5}, {1, .25}, 0});
  el.shapes.push_back({Box{{.5, 1}, {.25, 1}, 0}, {3, .5, .5, 0}});
  el.angle = .7;
  el.velocity = {.3, -.2};
  el.angular_velocity = 2;
  el.gravity_scale = 0;
  const Scene scene = scene_of({el});
  const Vec c = mass_of(el).center;
  const Vec start{1 + std::cos(.7) * c.x - std::sin(.7) * c.y, 2 + std::sin(.7) * c.x + std::cos(.7) * c.y};
  const int n = 60;
  const BodyState state = run(scene, n).at(0);
  EXPECT_NEAR(state.position.x, start.x + .3 * n * dt, rounding(n, 3));
  EXPECT_NEAR(state.position.y, start.y - .2 * n * dt, rounding(n, 3));
  // A rotation kept as cosine and sine may advance by atan(w h) = w h - (w h)^3/3.
  EXPECT_NEAR(state.angle, .7 + 2 * n * dt, rounding(n, 3) + n * dt * std::pow(2, 3) * stated().h * stated().h / 3);
  EXPECT_NEAR(state.angular_velocity, 2, rounding(n, 2));
}

TEST_P(EveryEngine, TakesMassAndInertiaFromTheScene) {
  Body el = body("el", BodyType::dynamic, {}, Box{{2, .5}, {1, .25}, 0});
  el.shapes.push_back({Circle{.4, {.25, 1}}, {3, .5, .5, 0}});
  Scene scene = scene_of({el});
  scene.gravity = {};
  scene.forces.push_back(Constant{0, {4, -2}, 3});
  if (!refusal(scene).empty()) GTEST_SKIP() << refusal(scene);
  const Mass mass = mass_of(el);
  const BodyState state = run(scene, 1).at(0);
  EXPECT_NEAR(state.velocity.x, 4 / mass.mass * dt, rounding(8, .1));
  EXPECT_NEAR(state.velocity.y, -2 / mass.mass * dt, rounding(8, .1));
  EXPECT_NEAR(state.angular_velocity, 3 / mass.inertia * dt, rounding(8, .1));
}

TEST_P(EveryEngine, FixesRotationAndScalesGravity) {
  Body still = box({0, 5});
  still.fixed_rotation = true;
  still.gravity_scale = -.5;
  Scene scene = scene_of({still});
  scene.forces.push_back(Constant{0, {}, 3});
  if (!refusal(scene).empty()) GTEST_SKIP() << refusal(scene);
  const BodyState state = run(scene, 60).at(0);
  EXPECT_EQ(state.angular_velocity, 0);
  EXPECT_NEAR(state.velocity.y, .5 * g, rounding(60, g));
}

TEST_P(EveryEngine, MovesKinematicBodiesAtTheirVelocity) {
  Body lift = body("lift", BodyType::kinematic, {0, 1}, Box{{4, 1}});
  lift.velocity = {.5, 1};
  lift.angular_velocity = -.25;
  const BodyState state = run(scene_of({lift}), 60).at(0);
  EXPECT_NEAR(state.position.x, .5, rounding(60, 1));
  EXPECT_NEAR(state.position.y, 2, rounding(60, 2));
  EXPECT_NEAR(state.angle, -.25, rounding(60, 1) + std::pow(.25, 3) * stated().h * stated().h / 3);
}

TEST_P(EveryEngine, SwingsAPendulumOnItsRod) {
  for (const bool hinge : {false, true}) {
    Scene scene = scene_of({body("pivot", BodyType::fixed, {0, 0}, Circle{.1}), box({2, 0})});
    if (hinge) {
      scene.joints.push_back(Revolute{0, 1, {0, 0}});
    } else {
      scene.joints.push_back(Distance{0, 1, {0, 0}, {2, 0}, 2, 0, 0});
    }
    if (!refusal(scene).empty()) GTEST_SKIP() << refusal(scene);
    const BodyState bob = run(scene, 30).at(1);
    EXPECT_LT(bob.position.y, -.5);
    EXPECT_NEAR(std::hypot(bob.position.x, bob.position.y), 2, .01);
  }
}

TEST_P(EveryEngine, HingesABodyToAFixedBodyWithoutShapes) {
  Scene scene = scene_of({{.name = "hook", .type = BodyType::fixed}, box({2, 0})});
  scene.joints.push_back(Revolute{0, 1, {0, 0}});
  const std::string reason = refusal(scene);
  if (reason.find("joints") != std::string::npos) GTEST_SKIP() << reason;
  EXPECT_EQ(reason, "");
  const BodyState bob = run(scene, 30).at(1);
  EXPECT_LT(bob.position.y, -.5);
  EXPECT_NEAR(std::hypot(bob.position.x, bob.position.y), 2, .01);
}

TEST_P(EveryEngine, SlidesOnARailAndKeepsAWeld) {
  Scene rail = scene_of({body("rail", BodyType::fixed, {0, 0}, Circle{.1}), box({3, 4})});
  rail.joints.push_back(Prismatic{0, 1, {3, 4}, {std::sqrt(.5), -std::sqrt(.5)}});
  if (!refusal(rail).empty()) GTEST_SKIP() << refusal(rail);
  const BodyState car = run(rail, 60).at(1);
  EXPECT_NEAR(car.position.x - 3, -(car.position.y - 4), .01);
  EXPECT_NEAR(car.position.x - 3, g / 4, g / 4 * .05);
  EXPECT_NEAR(car.angle, 0, .01);

  Scene welded = scene_of({box({0, 5}), box({1, 5})});
  welded.bodies[0].angular_velocity = 1;
  welded.joints.push_back(Weld{0, 1, {.5, 5}});
  if (!refusal(welded).empty()) GTEST_SKIP() << refusal(welded);
  const std::vector<BodyState> pair = run(welded, 60);
  EXPECT_NEAR(pair[0].angle, pair[1].angle, .01);
  EXPECT_NEAR(std::hypot(pair[1].position.x - pair[0].position.x, pair[1].position.y - pair[0].position.y), 1, .01);
}

TEST_P(EveryEngine, StopsASliderAtBothOfItsLimits) {
  for (const double way : {1.0, -1.0}) {
    Scene rail = scene_of({body("rail", BodyType::fixed, {0, 0}, Circle{.1}), box({3, 4})});
    rail.joints.push_back(Prismatic{0, 1, {3, 4}, {0, way * 2}, Limits{-.5, .75}});
    if (!refusal(rail).empty()) GTEST_SKIP() << refusal(rail);
    EXPECT_NEAR(run(rail, 120).at(1).position.y, way > 0 ? 3.5 : 3.25, .01);
  }
}

TEST_P(EveryEngine, TakesKinematicBodiesAlongTheirPaths) {
  Body lift = body("lift", BodyType::kinematic, {1, 2}, Circle{.1});
  lift.velocity = {.5, 0};
  lift.path = Path{.amplitude = {.1, .3}, .frequency = .8, .phase = .4};
  const Scene scene = scene_of({lift});
  if (!refusal(scene).empty()) GTEST_SKIP() << refusal(scene);
  constexpr int n = 100;
  const BodyState start = run(scene, 0).at(0);
  const BodyState end = run(scene, n).at(0);
  const double t = n * dt;
  const double moved = std::sin(2 * std::numbers::pi * .8 * t + .4) - std::sin(.4);
  EXPECT_NEAR(start.velocity.y, .3 * 2 * std::numbers::pi * .8 * std::cos(.4), rounding(1, 2));
  EXPECT_NEAR(end.position.x, 1 + .5 * t + .1 * moved, rounding(n, 4));
  EXPECT_NEAR(end.position.y, 2 + .3 * moved, rounding(n, 4));
}

TEST_P(EveryEngine, RefusesBodiesWithoutMass) {
  Body ghost = box({0, 1});
  ghost.shapes[0].surface.density = 0;
  EXPECT_NE(refusal(scene_of({ghost})), "");
}

TEST_P(EveryEngine, RepeatsItselfExactly) {
  Scene scene = scene_of({ground(), box({0, .6}), box({.3, 1.7}), box({-.2, 2.8})});
  const std::vector<BodyState> once = run(scene, 90);
  const std::vector<BodyState> again = run(scene, 90);
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].position, again[i].position);
    EXPECT_EQ(once[i].angle, again[i].angle);
  }
}

TEST_P(EveryEngine, StatesWhereItComesFrom) {
  EXPECT_NE(engine().about, "");
  EXPECT_NE(engine().source, "");
  EXPECT_GT(stated().h, 0);
  EXPECT_GT(stated().epsilon, 0);
}

std::vector<TestedEngine> configs() {
  std::vector<TestedEngine> all;
  for (const Engine* engine : Catalog<Engine>::all()) {
    if (engine->exact) continue;
    all.push_back({engine->name, {}});
    for (const Option& option : engine->options) {
      if (option.key != "solver" && option.key != "broad-phase" && option.key != "precision") continue;
      for (const auto& [choice, about] : option.choices) {
        if (choice != option.value) all.push_back({engine->name, {{option.key, choice}}});
      }
    }
  }
  return all;
}

// Commands of the programs that are installed.
std::vector<TestedEngine> installed() {
  std::vector<TestedEngine> all;
  const char* const folder = std::getenv("PLUMB_ENGINES_DIR");
  if (folder == nullptr) return all;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::filesystem::path adapter = entry.path() / "adapter.mjs";
    const bool half_installed = entry.path().filename().string().find(".part-") != std::string::npos;
    if (!half_installed && std::filesystem::exists(adapter)) all.push_back({"node " + adapter.string(), {}});
  }
  std::ranges::sort(all, {}, &TestedEngine::name);
  return all;
}

std::string test_name(const testing::TestParamInfo<TestedEngine>& info) {
  std::string name = testing::PrintToString(info.param);
  const std::size_t adapter = name.find("/adapter.mjs");
  if (adapter != std::string::npos) name = name.substr(name.rfind('/', adapter - 1) + 1, adapter);
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Adapters, EveryEngine, testing::ValuesIn(configs()), test_name);
INSTANTIATE_TEST_SUITE_P(Programs, EveryEngine, testing::ValuesIn(installed()), test_name);

TEST(Programs, AreInstalled) {
  if (installed().empty()) {
    GTEST_SKIP() << "no programs are tested: PLUMB_ENGINES_DIR names no folder with a sub-folder for each engine "
                    "(adapter.mjs, plumb_engine.mjs, node_modules)";
  }
}

}  // namespace
}  // namespace plumb::every_engine_test
