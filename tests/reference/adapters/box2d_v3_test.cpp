#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "reference/simulation.h"
#include "scenes.h"
#include "soft_step.h"

namespace plumb::box2d_v3_test {
namespace {

using namespace adapter_tests;

const Engine* box2d() { return Catalog<Engine>::find("box2d-v3"); }

// The library is optional.
class Box2dV3 : public testing::Test {
 protected:
  void SetUp() override {
    if (box2d() == nullptr) GTEST_SKIP() << "built without Box2D 3";
  }
};

std::string refusal(const Geometry& geometry) {
  return box2d()->unsupported(scene_of({body_of(BodyType::dynamic, {}, geometry)}), {});
}

TEST_F(Box2dV3, NamesTheVersionItRunsWith) { EXPECT_EQ(box2d()->source.rfind("Box2D 3.", 0), 0u); }

TEST_F(Box2dV3, RefusesPolygonsItWouldChange) {
  EXPECT_EQ(refusal(Polygon{regular_polygon(9, 1)}), "polygons have at most eight vertices");
  EXPECT_EQ(refusal(Polygon{regular_polygon(8, 1)}), "");
  EXPECT_EQ(refusal(Polygon{regular_polygon(8, .01)}), "drops vertices within 0.01 m of a line through others");
}

TEST_F(Box2dV3, SplitsStepsIntoSubSteps) {
  EXPECT_EQ(box2d()->stepping({}, 1).h, .25);
  EXPECT_EQ(box2d()->stepping({{"substeps", "10"}}, 1).h, .1);
}

// b2MakeRot would make 20 degrees 0.08 degrees steeper.
TEST_F(Box2dV3, StartsBodiesAtTheGivenAngle) {
  Scene scene = scene_of({body_of(BodyType::fixed, {}, Box{})});
  scene.bodies[0].angle = std::numbers::pi / 9;
  std::vector<BodyState> states(1);
  box2d()->build(scene, {})->read(states);
  EXPECT_NEAR(states[0].angle, std::numbers::pi / 9, 2 * std::ldexp(1.0, -24));
}

TEST_F(Box2dV3, CountsWholeTurns) {
  Scene scene = scene_of({body_of(BodyType::dynamic, {}, Circle{.5})});
  scene.gravity = {};
  scene.bodies[0].angular_velocity = -5;
  for (const int between : {1, 7, 240}) {
    const std::unique_ptr<Simulation> simulation = box2d()->build(scene, {});
    std::vector<BodyState> states(1);
    for (int i = 1; i <= 240; ++i) {
      simulation->step(1.0 / 60);
      if (i % between == 0) simulation->read(states);
    }
    simulation->read(states);
    // (w h)^2/3 of the angle is lost, for h = 1/240 s.
    EXPECT_NEAR(states[0].angle, -20, 20 * 25 / (3 * 240.0 * 240.0) + 1e-4) << "read every " << between;
  }
}

// A spinning body whose shape is beside its origin: moving the centre of mass to it must not give the body w x r.
TEST_F(Box2dV3, KeepsVelocitiesThatAreGivenForTheCentreOfMass) {
  Body body = body_of(BodyType::dynamic, {}, Box{{1, 1}, {2, 0}, 0});
  body.shapes.push_back({Circle{0.3, {-1, 0.7}}, {3, 0, 0, 0}});
  body.velocity = {0.1, -0.2};
  body.angular_velocity = 50;
  std::vector<BodyState> states(1);
  box2d()->build(scene_of({body}), {})->read(states);
  EXPECT_EQ(states[0].velocity.x, double{0.1F});
  EXPECT_EQ(states[0].velocity.y, double{-0.2F});
}

// Two boxes on the ground, one on the other, after 3 s.
struct Resting {
  Resting() : simulation(box2d()->build(scene(), {})) {
    for (int i = 0; i < 180; ++i) simulation->step(1.0 / 60);
    simulation->read(states);
    simulation->read_contacts(contacts);
  }
  static Scene scene() {
    return scene_of({body_of(BodyType::fixed, {}, HalfSpace{}), body_of(BodyType::dynamic, {0, 0.5}, Box{}),
                     body_of(BodyType::dynamic, {0, 1.5}, Box{})});
  }
  std::unique_ptr<Simulation> simulation;
  std::vector<BodyState> states = std::vector<BodyState>(3);
  std::vector<ContactState> contacts;
};

TEST_F(Box2dV3, ReportsTheWeightThatRestsAsImpulsesOfAWholeStep) {
  const Resting resting;
  double on_ground = 0;
  double between = 0;
  for (const ContactState& contact : resting.contacts) (contact.a == 0 ? on_ground : between) += contact.normal_impulse;
  const double weight = standard_gravity / 60;  // N s in a step, of 1 kg
  EXPECT_NEAR(on_ground, 2 * weight, weight / 100);
  EXPECT_NEAR(between, weight, weight / 100);
}

TEST_F(Box2dV3, SinksAsDeepAsItsStatedSlop) {
  const Resting resting;
  const double overlap = 1 - (resting.states[2].position.y - resting.states[1].position.y);
  const double slop = box2d()->stepping({}, 1.0 / 60).slop;
  EXPECT_NEAR(overlap, slop, slop / 100);
}

TEST_F(Box2dV3, KeepsSpringsBounded) { expect_bounded_spring(*box2d()); }

TEST_F(Box2dV3, FindsImpactsWithinItsStatedLag) { expect_impacts_within_the_stated_lag(*box2d()); }

TEST_F(Box2dV3, RestoresSpeedWithoutFriction) { expect_no_friction_of_restitution(*box2d()); }

// Two bodies on a spring between their centres: period 2 pi sqrt(mu/k) for the reduced mass mu.
TEST_F(Box2dV3, TunesSpringsToTheirStiffness) {
  Scene scene =
      scene_of({body_of(BodyType::dynamic, {0, 0}, Box{}), body_of(BodyType::dynamic, {3, 0}, Box{{2, 1}, {}, 0})});
  scene.gravity = {};
  scene.joints.push_back(Distance{0, 1, {0, 0}, {3, 0}, 2.5, 4, 0});
  ASSERT_EQ(box2d()->unsupported(scene, {}), "");
  const std::unique_ptr<Simulation> simulation = box2d()->build(scene, {{"substeps", "100"}});
  const double half_period = std::numbers::pi * std::sqrt(1 * 2 / (1 + 2.0) / 4);
  const int n = static_cast<int>(std::lround(half_period * 60));
  for (int i = 0; i < n; ++i) simulation->step(half_period / n);
  std::vector<BodyState> states(2);
  simulation->read(states);
  // The spring is implicit: its amplitude falls by w h/2 per radian, to first order; w half_period = pi.
  const double damped = .5 * (1 - std::numbers::pi * std::numbers::pi / (2.0 * n * 100));
  EXPECT_NEAR(states[1].position.x - states[0].position.x, 2.5 - damped, 1e-3);
}

TEST_F(Box2dV3, RefusesSpringsAwayFromTheCentres) {
  Scene scene = scene_of({body_of(BodyType::fixed, {0, 0}, Box{}), body_of(BodyType::dynamic, {3, 0}, Box{})});
  scene.joints.push_back(Distance{0, 1, {0, .5}, {3, .5}, 3, 4, 0});
  EXPECT_NE(box2d()->unsupported(scene, {}), "");
}

}  // namespace
}  // namespace plumb::box2d_v3_test
