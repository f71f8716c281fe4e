#include "reports/find/shrink.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "reports/find/admissible.h"
#include "reports/find/edit.h"
#include "reports/find/kind.h"
#include "scenarios/catalog.h"

namespace plumb::shrink_test {
namespace {

Complaint off_by(double ratio, double time = 0.5) {
  return {.judge = "invariant", .what = "energy", .ratio = ratio, .time = time};
}

const Scene& heap() {
  static const Scene scene = [] {
    const Kind& kind = *Catalog<Kind>::find("heap");
    for (int n = 0;; ++n) {
      Scene one = drawn(kind, 1, n);
      if (one.bodies.size() > 20) return one;
    }
  }();
  return scene;
}

TEST(Shrink, KeepsTheTwoBodiesThatMatterAndNothingElse) {
  const std::string a = heap().bodies[5].name;
  const std::string b = heap().bodies[17].name;
  const Failing both_there = [&](const Scene& scene) -> std::optional<Complaint> {
    const auto has = [&](const std::string& name) {
      return std::ranges::any_of(scene.bodies,
                                 [&](const Body& one) { return one.name == name && one.type == BodyType::dynamic; });
    };
    return has(a) && has(b) ? std::optional(off_by(10)) : std::nullopt;
  };
  const Shrunk shrunk = shrink(heap(), off_by(10), both_there, 400);
  ASSERT_EQ(shrunk.scene.bodies.size(), 2U);
  EXPECT_EQ(shrunk.scene.bodies[0].velocity, Vec{});
  EXPECT_EQ(shrunk.scene.bodies[0].shapes[0].surface.density, 1);
  EXPECT_LE(shrunk.scene.duration, 0.6);
  EXPECT_LE(shrunk.runs, 400);
}

TEST(Shrink, StaysWithinItsBudget) {
  int runs = 0;
  const Failing never = [&](const Scene&) -> std::optional<Complaint> {
    ++runs;
    return std::nullopt;
  };
  const Shrunk shrunk = shrink(heap(), off_by(10), never, 25);
  EXPECT_EQ(runs, 25);
  EXPECT_EQ(shrunk.scene.bodies.size(), heap().bodies.size());
}

TEST(Shrink, DoesNotTradeAClearFailureForOneAtTheLimit) {
  const Failing barely = [](const Scene&) { return std::optional(off_by(1.01)); };
  EXPECT_EQ(shrink(heap(), off_by(10), barely, 50).scene.bodies.size(), heap().bodies.size());
  EXPECT_LT(shrink(heap(), off_by(1.01), barely, 50).scene.bodies.size(), heap().bodies.size());
}

TEST(Shrink, NeverPutsBodiesIntoEachOther) {
  for (const char* name : {"tower", "drop", "chain", "door"}) {
    const Scene scene = drawn(*Catalog<Kind>::find(name), 1, 1);
    const Failing always = [](const Scene&) { return std::optional(off_by(10)); };
    const Failing moving = [&](const Scene& one) {
      const bool moves = std::ranges::any_of(one.bodies, [](const Body& b) { return b.type == BodyType::dynamic; });
      return moves ? always(one) : std::nullopt;
    };
    EXPECT_TRUE(no_worse(shrink(scene, off_by(10), moving, 200).scene, contradictions(scene))) << name;
  }
}

TEST(WithoutBodies, TakesTheirJointsAndForcesAndRenumbersTheRest) {
  Scene scene;
  for (const char* name : {"a", "b", "c", "d"}) scene.bodies.push_back({.name = name});
  scene.joints = {Revolute{.a = 0, .b = 1}, Revolute{.a = 0, .b = 3}};
  scene.forces = {Spring{.a = 1, .b = 2}, Constant{.body = 2}, Attraction{.from = 3}};
  const Scene rest = without_bodies(scene, 1, 2);
  ASSERT_EQ(rest.bodies.size(), 3U);
  ASSERT_EQ(rest.joints.size(), 1U);
  EXPECT_EQ(std::get<Revolute>(rest.joints[0]).b, 2U);
  ASSERT_EQ(rest.forces.size(), 2U);
  EXPECT_EQ(std::get<Constant>(rest.forces[0]).body, 1U);
  EXPECT_EQ(std::get<Attraction>(rest.forces[1]).from, 2U);
}

TEST(Contradictions, TellOverlapsAndJointsThatMoveApart) {
  Scene scene;
  for (const char* name : {"a", "b"}) scene.bodies.push_back({.name = name, .shapes = {{.geometry = Circle{}}}});
  scene.bodies[1].position = {0.9, 0};
  EXPECT_NEAR(contradictions(scene).overlap, 0.1, 1e-12);
  scene.joints = {Distance{.a = 0, .b = 1, .anchor_a = {0, 0}, .anchor_b = {0.9, 0}, .length = 0.7}};
  EXPECT_EQ(contradictions(scene).overlap, 0) << "joined bodies do not collide";
  EXPECT_NEAR(contradictions(scene).joint_gap, 0.2, 1e-12);
  scene.bodies[1].velocity = {2, 1};
  EXPECT_NEAR(contradictions(scene).joint_speed, 2, 1e-12);
  scene.joints = {Weld{.a = 0, .b = 1, .anchor = {0, 0}}};
  scene.bodies[1].velocity = {};
  scene.bodies[1].angular_velocity = 3;
  EXPECT_NEAR(contradictions(scene).joint_speed, 3 + 3 * 0.9, 1e-12);
}

}  // namespace
}  // namespace plumb::shrink_test
