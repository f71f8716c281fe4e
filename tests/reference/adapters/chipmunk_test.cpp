#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "reference/simulation.h"
#include "scenes.h"

namespace plumb::chipmunk_test {
namespace {

using namespace adapter_tests;

const Engine* chipmunk() { return Catalog<Engine>::find("chipmunk"); }

// The library is optional.
class Chipmunk : public testing::Test {
 protected:
  void SetUp() override {
    if (chipmunk() == nullptr) GTEST_SKIP() << "built without Chipmunk";
  }
};

BodyState last(const Scene& scene, const Settings& settings, int steps) {
  return last_state(*chipmunk(), scene, settings, steps);
}

TEST_F(Chipmunk, SaysWhyItEndsTheProcessAndNoWarning) {
  using Say = void(const char* condition, const char* file, int line, int error, int hard, const char* message, ...);
  auto* const say = reinterpret_cast<Say*>(dlsym(RTLD_DEFAULT, "cpMessage"));
  if (say == nullptr) GTEST_SKIP() << "built with a static Chipmunk, which says what it wants";
  testing::internal::CaptureStderr();
  say("n < most", "cpCollision.c", 352, 0, 0, "High GJK iterations: %d", 31);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  testing::internal::CaptureStderr();
  say("mass > 0", "cpBody.c", 7, 1, 1, "Mass must be positive: %d", -1);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "Chipmunk: Mass must be positive: -1 (mass > 0, cpBody.c:7)\n");
}

TEST_F(Chipmunk, NamesTheVersionItRunsWith) { EXPECT_EQ(chipmunk()->source.rfind("Chipmunk2D 7", 0), 0u); }

TEST_F(Chipmunk, PrintsNoGreeting) {
  testing::internal::CaptureStdout();
  last(scene_of({body_of(BodyType::dynamic, {}, Circle{.5})}), {}, 1);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

// Positions move before velocities, and forces are evaluated after the move. On a spring that is symplectic Euler with
// its two halves swapped, whose energy stays within a relative error of w h (w h = sqrt(100)/60).
TEST_F(Chipmunk, KeepsTheEnergyOfASpring) {
  Scene scene = scene_of({body_of(BodyType::dynamic, {1, 0}, Box{})});
  scene.gravity = {};
  scene.forces.push_back(Spring{{}, 0, {0, 0}, {0, 0}, 100, 0, 0});
  const std::unique_ptr<Simulation> simulation = chipmunk()->build(scene, {});
  std::vector<BodyState> states(1);
  for (int i = 0; i < 6000; ++i) {
    simulation->step(1.0 / 60);
    simulation->read(states);
    const Vec x = states[0].position;
    const Vec v = states[0].velocity;
    ASSERT_NEAR((v.x * v.x + 100 * x.x * x.x) / 2, 50, 50 * 10.0 / 60) << "step " << i;
  }
}

TEST_F(Chipmunk, DampsExponentially) {
  Scene scene = scene_of({body_of(BodyType::dynamic, {}, Box{})});
  scene.gravity = {};
  scene.bodies[0].velocity = {3, 0};
  scene.bodies[0].angular_velocity = 5;
  scene.bodies[0].linear_damping = .4;
  scene.bodies[0].angular_damping = .7;
  const BodyState state = last(scene, {}, 60);
  EXPECT_NEAR(state.velocity.x, 3 * std::exp(-.4), 1e-13);
  EXPECT_NEAR(state.angular_velocity, 5 * std::exp(-.7), 1e-13);
}

TEST_F(Chipmunk, LeavesOverlapUpToTheSlop) {
  const auto rest = [](const Settings& settings) {
    const Scene scene =
        scene_of({body_of(BodyType::fixed, {}, HalfSpace{}), body_of(BodyType::dynamic, {0, .45}, Box{})});
    return last(scene, settings, 300).position.y;
  };
  EXPECT_NEAR(rest({{"slop", "0.1"}}), .45, 1e-2);
  EXPECT_NEAR(rest({}), .5 - .005, 1e-3);
}

TEST_F(Chipmunk, BouncesAtAnySpeed) {
  Scene scene =
      scene_of({body_of(BodyType::fixed, {}, HalfSpace{}), body_of(BodyType::dynamic, {0, .51}, Circle{.5}, .5)});
  scene.gravity = {};
  scene.bodies[1].velocity = {0, -.1};
  EXPECT_NEAR(last(scene, {}, 30).velocity.y, .05, 1e-12);
}

TEST_F(Chipmunk, JoinsBodiesThatMayNotTurn) {
  Scene scene = scene_of({body_of(BodyType::fixed, {}, Circle{.1}), body_of(BodyType::dynamic, {0, -1}, Circle{.3})});
  scene.bodies[1].fixed_rotation = true;
  const auto height = [&](const Joint& joint) {
    scene.joints = {joint};
    return last(scene, {}, 60).position.y;
  };
  EXPECT_NEAR(height(Prismatic{.a = 0, .b = 1, .anchor = {0, -1}, .axis = {1, 0}}), -1, 0.01);
  EXPECT_NEAR(height(Prismatic{.a = 0, .b = 1, .anchor = {0, -1}, .axis = {0, 1}}), -1 - standard_gravity / 2, 0.1);
  EXPECT_NEAR(height(Weld{.a = 0, .b = 1, .anchor = {0, -1}}), -1, 0.01);
  EXPECT_NEAR(height(Revolute{.a = 0, .b = 1, .anchor = {0, -1}, .limits = Limits{-1, 1}}), -1, 0.01);
}

}  // namespace
}  // namespace plumb::chipmunk_test
