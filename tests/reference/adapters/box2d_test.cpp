#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/vec.h"
#include "scenes.h"

namespace plumb::box2d_test {
namespace {

using namespace adapter_tests;

const Engine& box2d() { return *Catalog<Engine>::find("box2d"); }

BodyState last(const Scene& scene, const Settings& settings, int steps) {
  return last_state(box2d(), scene, settings, steps);
}

std::string refusal(const Geometry& geometry) {
  return box2d().unsupported(scene_of({body_of(BodyType::dynamic, {}, geometry)}), {});
}

TEST(Box2d, NamesTheVersionItRunsWith) { EXPECT_NE(box2d().source.find("2.4."), std::string::npos) << box2d().source; }

TEST(Box2d, RefusesPolygonsItWouldChange) {
  EXPECT_EQ(refusal(Polygon{regular_polygon(9)}), "polygons have at most eight vertices");
  EXPECT_EQ(refusal(Polygon{regular_polygon(8)}), "");
  EXPECT_EQ(refusal(Polygon{{{0, 0}, {1, 0}, {1, .002}, {0, 1}}}), "welds vertices closer than 0.0025 m");
}

TEST(Box2d, RefusesCapsulesThinnerThanItsSkin) {
  EXPECT_NE(refusal(Capsule{{0, 0}, {1, 0}, .015}), "");
  EXPECT_EQ(refusal(Capsule{{0, 0}, {1, 0}, .1}), "");
}

TEST(Box2d, HoldsPolygonsApartByItsSkin) {
  const Scene scene =
      scene_of({body_of(BodyType::fixed, {0, 0}, HalfSpace{}), body_of(BodyType::dynamic, {0, .6}, Box{})});
  // Two skins of 0.01 m, less the slop of 0.005 m that position correction leaves.
  EXPECT_NEAR(last(scene, {}, 120).position.y, .5 + .015, 1e-3);
}

TEST(Box2d, BouncesOnlyAboveItsThreshold) {
  Scene scene =
      scene_of({body_of(BodyType::fixed, {0, 0}, HalfSpace{}), body_of(BodyType::dynamic, {0, .6}, Circle{.5}, 1)});
  scene.gravity = {};
  scene.bodies[1].velocity = {0, -.9};
  EXPECT_NEAR(last(scene, {}, 30).velocity.y, 0, 1e-3);
  EXPECT_NEAR(last(scene, {{"restitution", "0.5"}}, 30).velocity.y, .9, 1e-3);
  EXPECT_EQ(box2d().stepping({{"restitution", "0.5"}}, 1.0 / 60).restitution_threshold, .5);
}

TEST(Box2d, StopsAtThinWallsUnlessContinuousCollisionIsOff) {
  Scene scene = scene_of(
      {body_of(BodyType::fixed, {0, 0}, Segment{{-1, 0}, {1, 0}}), body_of(BodyType::dynamic, {0, 2}, Circle{.1})});
  scene.gravity = {};
  scene.bodies[1].velocity = {0, -60};
  EXPECT_GT(last(scene, {}, 10).position.y, 0);
  EXPECT_LT(last(scene, {{"continuous", "off"}}, 10).position.y, -1);
}

TEST(Box2d, SleepsOnlyIfTheOptionIsOn) {
  Scene scene = scene_of({body_of(BodyType::dynamic, {0, 0}, Circle{.5})});
  scene.gravity = {};
  scene.bodies[0].velocity = {.001, 0};
  EXPECT_GT(last(scene, {}, 120).velocity.x, 0);
  EXPECT_EQ(last(scene, {{"sleep", "on"}}, 120).velocity.x, 0);
}

// A ladder whose ends stand on the ground and on a wall: in its first step, continuous collision solves both again
// where the step met them.
TEST(Box2d, ReportsAPointOnceThatTwoSolvesOfAStepMeet) {
  constexpr double tilt = -0.84;
  Body ladder = body_of(BodyType::dynamic, {2 * std::cos(tilt), -2 * std::sin(tilt)},
                        Polygon{{{2, 0}, {0, .1}, {-2, 0}, {0, -.1}}});
  ladder.angle = tilt;
  const Scene scene = scene_of({body_of(BodyType::fixed, {0, 0}, HalfSpace{}),
                                body_of(BodyType::fixed, {0, 0}, HalfSpace{.normal = {1, 0}}), ladder});
  const std::unique_ptr<Simulation> simulation = box2d().build(scene, {});
  simulation->step(1.0 / 60);
  std::vector<ContactState> contacts;
  simulation->read_contacts(contacts);
  ASSERT_EQ(contacts.size(), 2U);
  std::vector<BodyState> states(3);
  simulation->read(states);
  Vec given{0, -standard_gravity / 60};  // m/s
  for (const ContactState& contact : contacts) {
    const Vec along{-contact.normal.y, contact.normal.x};
    given =
        given + 1 / mass_of(ladder).mass * (contact.normal_impulse * contact.normal + contact.tangent_impulse * along);
  }
  EXPECT_NEAR(length(states[2].velocity - given), 0, 1e-6);
}

}  // namespace
}  // namespace plumb::box2d_test
