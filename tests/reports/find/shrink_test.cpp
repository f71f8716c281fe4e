#include "reports/find/shrink.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "reports/find/judge.h"
#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"
#include "scenarios/scene/vec.h"

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
  const CutTrial both_there{[&](const Scene& scene) -> std::optional<Complaint> {
    const auto has = [&](const std::string& name) {
      return std::ranges::any_of(scene.bodies,
                                 [&](const Body& one) { return one.name == name && one.type == BodyType::dynamic; });
    };
    return has(a) && has(b) ? std::optional(off_by(10)) : std::nullopt;
  }};
  const Shrunk shrunk = shrink(heap(), off_by(10), both_there, 400);
  ASSERT_EQ(shrunk.scene.bodies.size(), 2U);
  EXPECT_EQ(shrunk.scene.bodies[0].velocity, Vec{});
  EXPECT_EQ(shrunk.scene.bodies[0].shapes[0].surface.density, 1);
  EXPECT_LE(shrunk.scene.duration, 0.6);
  EXPECT_LE(shrunk.runs, 400);
}

TEST(Shrink, StaysWithinItsBudget) {
  int runs = 0;
  const CutTrial never{[&](const Scene&) -> std::optional<Complaint> {
    ++runs;
    return std::nullopt;
  }};
  const Shrunk shrunk = shrink(heap(), off_by(10), never, 25);
  EXPECT_EQ(runs, 25);
  EXPECT_EQ(shrunk.scene.bodies.size(), heap().bodies.size());
}

TEST(Shrink, DoesNotTradeAClearFailureForOneAtTheLimit) {
  const CutTrial barely{[](const Scene&) { return std::optional(off_by(1.01)); }};
  EXPECT_EQ(shrink(heap(), off_by(10), barely, 50).scene.bodies.size(), heap().bodies.size());
  EXPECT_LT(shrink(heap(), off_by(1.01), barely, 50).scene.bodies.size(), heap().bodies.size());
}

TEST(Shrink, DoesNotTradeALargeErrorForNextToNothing) {
  const auto off_by_joules = [](double value) {
    Complaint one = off_by(10);
    one.value = value;
    return one;
  };
  const CutTrial tiny{[&](const Scene&) { return std::optional(off_by_joules(1e-6)); }};
  EXPECT_EQ(shrink(heap(), off_by_joules(1), tiny, 50).scene.bodies.size(), heap().bodies.size());
}

TEST(Shrink, NeverPutsBodiesIntoEachOther) {
  for (const char* name : {"tower", "drop", "chain", "door"}) {
    const Scene scene = drawn(*Catalog<Kind>::find(name), 1, 1);
    const CutTrial moving{[](const Scene& one) {
      const bool moves = std::ranges::any_of(one.bodies, [](const Body& b) { return b.type == BodyType::dynamic; });
      return moves ? std::optional(off_by(10)) : std::nullopt;
    }};
    EXPECT_TRUE(no_worse(shrink(scene, off_by(10), moving, 200).scene, contradictions(scene))) << name;
  }
}

// A ball falls, and fails when it is 1 m below where it was at 5 m.
TEST(Shrink, StartsFromWhatTheRunReachedShortlyBeforeTheFailure) {
  Scene fall{.name = "fall", .duration = 2, .bodies = {disc("ball", {0.3, 5}, 0.5, {})}};
  const auto reached = [](const Scene& scene, double t) {
    const Body& ball = scene.bodies[0];
    const Vec at{ball.position.x, ball.position.y + t * (ball.velocity.y - t * standard_gravity / 2)};
    return std::vector<BodyState>{{.position = at, .velocity = {0, ball.velocity.y - t * standard_gravity}}};
  };
  const CutTrial trial{.fails = [&](const Scene& scene) -> std::optional<Complaint> {
                         if (scene.bodies[0].type == BodyType::fixed) return std::nullopt;
                         if (scene.gravity != Vec{0, -standard_gravity}) return std::nullopt;
                         for (double t = 0; t <= scene.duration; t += 1.0 / 60) {
                           const BodyState ball = reached(scene, t).front();
                           if (ball.position.y < 4 && ball.velocity.y < -4) return off_by(10, t);
                         }
                         return std::nullopt;
                       },
                       .states = reached};
  const Shrunk shrunk = shrink(fall, off_by(10, 0.46), trial, 400);
  EXPECT_LE(shrunk.scene.duration, 0.1);
  EXPECT_LT(shrunk.scene.bodies[0].position.y, 4.5);
  EXPECT_LT(shrunk.scene.bodies[0].velocity.y, -3);
}

TEST(Shrink, TakesALaterStartOnlyAsFarFromItsContactsAsTheEngineStates) {
  Scene scene{.name = "ball", .duration = 1, .bodies = {level_ground({}), disc("ball", {0, 0.5}, 0.5, {})}};
  const auto deep = [](const Scene&, double) { return std::vector<BodyState>{{}, {.position = {0, 0.49}}}; };
  const auto sunk = [](const Scene& one) -> std::optional<Complaint> {
    const bool both = one.bodies.size() == 2 && one.bodies[1].type == BodyType::dynamic;
    return both && one.bodies[1].position.y < 0.495 ? std::optional(off_by(10, 0.2)) : std::nullopt;
  };
  const auto overlap_of = [&](double stated) {
    const CutTrial trial{.fails = sunk, .states = deep, .stated = {.overlap = stated}};
    return contradictions(shrink(scene, off_by(10, 0.2), trial, 300).scene).overlap;
  };
  EXPECT_LE(overlap_of(0.001), 1e-9);
  EXPECT_NEAR(overlap_of(0.02), 0.01, 1e-9);
}

TEST(StartedAt, GoesOnAsTheRunDid) {
  const EngineConfig impulse = parse_suspects("impulse").front().config;
  for (const char* name : {"flight", "chain", "door", "slider", "belt"}) {
    for (int n = 0; n < 6; ++n) {
      const Scene scene = drawn(*Catalog<Kind>::find(name), 1, n);
      const double time = 6 * search_step;
      const Outcome whole = run(scene, impulse, search_step);
      ASSERT_EQ(whole.status, Status::ok) << scene.name;
      const auto states = whole.trace->states(6);
      const Scene rest = started_at(scene, states, time);
      EXPECT_DOUBLE_EQ(rest.duration, scene.duration - time);
      const Outcome later = run(rest, impulse, search_step);
      ASSERT_EQ(later.status, Status::ok) << scene.name;
      // A contact that began before is new to it.
      for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const Vec apart = later.trace->states(6)[i].position - whole.trace->states(12)[i].position;
        EXPECT_NEAR(length(apart), 0, 2e-3) << scene.name << ": " << scene.bodies[i].name;
      }
    }
  }
}

TEST(WithDigits, RoundsAllButDirections) {
  Scene scene{
      .name = "rail", .duration = 0.8867, .bodies = {level_ground({}), disc("ball", {0.123456, 1e-17}, 0.5, {})}};
  const Vec axis = unit_at(0.1);
  scene.joints = {Prismatic{.a = 0, .b = 1, .axis = axis}};
  const auto rounder = with_digits(scene, 2);
  ASSERT_TRUE(rounder.has_value());
  EXPECT_EQ(rounder->bodies[1].position, (Vec{0.12, 0}));
  EXPECT_EQ(rounder->duration, 0.89);
  EXPECT_EQ(std::get<Prismatic>(rounder->joints[0]).axis, axis);
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
