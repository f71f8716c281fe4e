#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <variant>

#include "forged_runs.h"
#include "reports/judge/mechanics.h"
#include "scenarios/scene/mass.h"

namespace plumb::displacement_test {
namespace {

constexpr double dt = 0.01;
const Stepping exact{.dt = dt, .h = dt, .drift = 0, .impact_lag = 0, .epsilon = 1e-16};
const Stepping first_order{
    .dt = dt, .h = dt, .drift = 0.5, .impact_lag = 1, .skin = 0.01, .slop = 0.005, .epsilon = 1e-16};

// Thrown up at 1 m/s and spinning, by the exact motion or by Euler's methods.
Trace thrown(double order, double faster = 1) {
  Trace trace(2);
  for (int i = 0; i <= 100; ++i) {
    const double t = i * dt;
    std::vector<BodyState> states = box_at({3 * faster * t, 9 + t - 5 * t * t - order * 10 * t * dt}, {3, 1 - 10 * t});
    states[1].angle = 2 * faster * t;
    states[1].angular_velocity = 2;
    trace.record(t, states, {});
  }
  return trace;
}

TEST(DisplacementInvariant, IsHeldByMethodsOfAnyOrder) {
  const Scene scene = box_on_ground(0.5, {0, -10});
  for (const double order : {0.0, 0.5, -0.5}) {
    for (const Stepping& stepping : {exact, first_order}) {
      const InvariantCheck check = checked("displacement", scene, thrown(order), stepping).value();
      EXPECT_EQ(check.status, CheckStatus::held) << order << ": " << check.value << " of " << check.tolerance;
      EXPECT_TRUE(is_evidence(check));
    }
  }
  EXPECT_EQ(status("displacement", scene, thrown(0.6), exact), CheckStatus::broken);
}

TEST(DisplacementInvariant, IsBrokenByABodyThatMovesOtherThanItsVelocity) {
  const Scene scene = box_on_ground(0.5, {0, -10});
  EXPECT_EQ(status("displacement", scene, thrown(0, 1.001), first_order), CheckStatus::broken);
  EXPECT_EQ(status("displacement", scene, thrown(0, 0), first_order), CheckStatus::broken);
}

TEST(DisplacementInvariant, IsBrokenByAnEngineThatFreezesAndKeepsItsVelocities) {
  const auto frozen = [](Vec velocity, double spin) {
    std::vector<BodyState> states = box_at({0, 5}, velocity);
    states[1].angular_velocity = spin;
    return forged(dt, {{states}, {states}});
  };
  EXPECT_EQ(status("displacement", box_on_ground(), frozen({1, 0}, 0), first_order), CheckStatus::broken);
  EXPECT_EQ(status("displacement", box_on_ground(), frozen({}, 1), first_order), CheckStatus::broken);
  EXPECT_EQ(status("displacement", box_on_ground(), frozen({}, 0), first_order), CheckStatus::held);
}

// At 9 rad/s in sub-steps of 1/240 s, atan(w h) is (w h)^2/3 = 4.7e-4 short of w h.
TEST(DisplacementInvariant, AllowsRotationsAlongTheTangentIfTheyAreStated) {
  constexpr double w = 9;
  constexpr double h = dt / 4;
  const auto turns = [&](double angle) {
    std::vector<BodyState> then = box_at({0, 5});
    then[1].angular_velocity = w;
    std::vector<BodyState> now = then;
    now[1].angle = angle;
    return forged(dt, {{then}, {now}});
  };
  Stepping stated{.dt = dt, .h = h, .epsilon = 1e-16};
  const Trace short_of_it = turns(4 * std::atan(w * h));
  EXPECT_EQ(status("displacement", box_on_ground(), short_of_it, stated), CheckStatus::broken);
  stated.tangent_rotation = true;
  EXPECT_EQ(status("displacement", box_on_ground(), short_of_it, stated), CheckStatus::held);
  EXPECT_EQ(status("displacement", box_on_ground(), turns(w * dt * 0.999), stated), CheckStatus::broken);
}

// A post on a path carries a cart that slides along its rail and slows down: up with the post's new velocity at once,
// and along with the mean of its own.
TEST(DisplacementInvariant, AllowsForWhatBodiesOnPathsCarryAlong) {
  Scene scene = box_on_ground();
  scene.bodies[0] = {.name = "post", .type = BodyType::kinematic, .path = Path{.amplitude = {0, 0.05}}};
  scene.joints = {Prismatic{.a = 0, .b = 1, .anchor = {0, 0.5}, .axis = {1, 0}}};
  const auto carried = [&](double ahead) {
    const std::vector<BodyState> then{{.velocity = {0, 0.3}}, {.position = {0, 0.5}, .velocity = {2, 0.3}}};
    const std::vector<BodyState> now{{.position = {0, 0.2 * dt}, .velocity = {0, 0.2}},
                                     {.position = {1.95 * dt + ahead, 0.5 + 0.2 * dt}, .velocity = {1.9, 0.2}}};
    return forged(dt, {{then}, {now}});
  };
  EXPECT_EQ(status("displacement", scene, carried(0), exact), CheckStatus::held);
  EXPECT_EQ(status("displacement", scene, carried(0.05 * dt), exact), CheckStatus::broken) << "by more than the jump";
  scene.bodies[0].path.reset();
  EXPECT_EQ(status("displacement", scene, carried(0), exact), CheckStatus::broken) << "nothing turned its velocity";
}

// A motor of the strength S may move a mass m by S dt^2/4m beyond its velocities in the step in which it switches.
TEST(DisplacementInvariant, AllowsForMotorsThatReachTheirSpeedWithinAStep) {
  Scene scene = box_on_ground();
  scene.bodies[1].position = {0, 5};
  constexpr double way = 0.01;  // m
  const double mass = mass_of(scene.bodies[1]).mass;
  scene.joints = {Prismatic{.a = 0, .b = 1, .anchor = {0, 5}, .axis = {1, 0}}};
  std::get<Prismatic>(scene.joints[0]).motor = Motor{.speed = 2, .strength = 4 * mass * way / (dt * dt)};
  const auto driven = [&](double before, double after, double beyond) {
    const std::vector<BodyState> then{{}, {.position = {0, 5}, .velocity = {before, 0}}};
    const double moved = dt * std::max(before, after) + beyond;
    const std::vector<BodyState> now{{}, {.position = {moved, 5}, .velocity = {after, 0}}};
    return forged(dt, {{then}, {now}});
  };
  EXPECT_EQ(status("displacement", scene, driven(1, 2, 0.99 * way), exact), CheckStatus::held);
  EXPECT_EQ(status("displacement", scene, driven(1, 2, 1.01 * way), exact), CheckStatus::broken);
  EXPECT_EQ(status("displacement", scene, driven(2, 1, 0.99 * way), exact), CheckStatus::held);
  EXPECT_EQ(status("displacement", scene, driven(1, 3, 0.99 * way), exact), CheckStatus::held);
  EXPECT_EQ(status("displacement", scene, driven(1, 1.5, 0.01 * way), exact), CheckStatus::broken)
      << "not at its speed";
  EXPECT_EQ(status("displacement", scene, driven(2, 2, 0.01 * way), exact), CheckStatus::broken) << "at it throughout";
}

// The spring of one box gives its change of force to the box that is welded to it, too.
TEST(DisplacementInvariant, AllowsForForcesOnWhatJointsAttach) {
  Scene scene = box_on_ground();
  scene.bodies[1].position = {0, 50};
  scene.bodies.push_back(scene.bodies[1]);
  scene.bodies[2].name = "other";
  scene.bodies[2].position = {5, 50};
  const double mass = mass_of(scene.bodies[1]).mass;
  constexpr double gained = 1;  // m/s, in the step
  constexpr double way = 1.5 * gained * dt;
  const std::vector<BodyState> then{{}, {.position = {0, 50}}, {.position = {5, 50}}};
  const std::vector<BodyState> now{
      {}, {.position = {way, 50}, .velocity = {gained, 0}}, {.position = {5 + way, 50}, .velocity = {gained, 0}}};
  const auto with_spring = [&](double stiffness) {
    scene.forces = {Spring{.b = 1, .anchor_a = {0, 50}, .stiffness = stiffness}};
    return status("displacement", scene, forged(dt, {{then}, {now}}), exact);
  };
  EXPECT_EQ(with_spring(mass / (dt * dt)), CheckStatus::broken) << "not attached";
  scene.joints = {Weld{.a = 1, .b = 2, .anchor = {2, 50}}};
  EXPECT_EQ(with_spring(mass / (dt * dt)), CheckStatus::held);
  EXPECT_EQ(with_spring(0.1 * mass / (dt * dt)), CheckStatus::broken);
}

TEST(DisplacementInvariant, IsBrokenByATeleport) {
  const auto jumps = [](double to) { return forged(dt, {{box_at({0, 0.5})}, {box_at({to, 0.5})}}); };
  // It lies on the ground, which may push it out by the stated gap.
  EXPECT_EQ(status("displacement", box_on_ground(), jumps(0.0099), first_order), CheckStatus::held);
  EXPECT_EQ(status("displacement", box_on_ground(), jumps(0.0101), first_order), CheckStatus::broken);
  EXPECT_EQ(status("displacement", box_on_ground(), jumps(1e-6), exact), CheckStatus::broken);
}

// From 1 m/s down to 1 m/s up within a step; the box moves by anything between.
TEST(DisplacementInvariant, AllowsAnImpactWithinAStep) {
  const auto bounced = [](double by) {
    return forged(dt, {{box_at({0, 0.505}, {0, -1})}, {box_at({0, 0.505 + by}, {0, 1})}});
  };
  for (const double by : {-0.005, 0.0, 0.009}) {
    EXPECT_EQ(status("displacement", box_on_ground(), bounced(by), exact), CheckStatus::held) << by;
  }
  EXPECT_EQ(status("displacement", box_on_ground(), bounced(0.05), exact), CheckStatus::broken);
}

// A box 0.1 m above the end of its rail, at rest, falls on it within a step of 0.2 s, and rests there.
TEST(DisplacementInvariant, AllowsALimitThatForcesReachWithinAStep) {
  const auto fell = [](double to) { return forged(0.2, {{box_at({0, 5})}, {box_at({0, to})}}); };
  Scene rail = box_on_ground(0.5, {0, -10});
  rail.bodies[1].position = {0, 5};
  rail.joints.push_back(Prismatic{.a = 0, .b = 1, .anchor = {0, 5}, .axis = {0, 1}});
  EXPECT_EQ(status("displacement", rail, fell(4.9), exact), CheckStatus::broken) << "it has no end";
  std::get<Prismatic>(rail.joints[0]).limits = Limits{-0.1, 1};
  EXPECT_EQ(status("displacement", rail, fell(4.9), exact), CheckStatus::held);
  EXPECT_EQ(status("displacement", rail, fell(5.9), exact), CheckStatus::broken) << "no force acts upwards";
}

// A box that hangs out level from a hinge 2 m away falls within a step of 0.2 s to its lower limit, and rests there.
TEST(DisplacementInvariant, AllowsALimitToWhichAHingeSwingsWithinAStep) {
  constexpr double turned = -0.05;
  Scene door = box_on_ground(0.5, {0, -10});
  door.bodies[1].position = {2, 5};
  door.joints.push_back(Revolute{.a = 0, .b = 1, .anchor = {0, 5}});
  const auto fell_to = [&](double angle) {
    std::vector<BodyState> there = box_at({2 * std::cos(angle), 5 + 2 * std::sin(angle)});
    there[1].angle = angle;
    return status("displacement", door, forged(0.2, {{box_at({2, 5})}, {there}}), exact);
  };
  EXPECT_EQ(fell_to(turned), CheckStatus::broken) << "it has no end";
  std::get<Revolute>(door.joints[0]).limits = Limits{turned, 1};
  EXPECT_EQ(fell_to(turned), CheckStatus::held);
  std::get<Revolute>(door.joints[0]).limits = Limits{5 * turned, 1};
  EXPECT_EQ(fell_to(5 * turned), CheckStatus::broken) << "it cannot swing so far in that time";
}

// A post that slows down by .71 m/s in a step lets its door swing to its limit, and both stop.
TEST(DisplacementInvariant, AllowsALimitToWhichAPostThatSlowsDownLetsADoorSwing) {
  constexpr double frame = 1.0 / 60;
  const Stepping stated{.dt = frame, .h = frame / 4, .drift = 0, .impact_lag = 0, .epsilon = 1e-16};
  const auto slows_down = [&](std::optional<Limits> limits) {
    const Scene scene{.gravity = {},
                      .bodies = {{.name = "post", .type = BodyType::kinematic, .path = Path{.amplitude = {0.1279, 0}}},
                                 {.name = "door",
                                  .position = {0.5945, 0},
                                  .shapes = {{Box{.size = {1.189, 0.2605}}, {.density = 1.611}}}}},
                      .joints = {Revolute{.a = 0, .b = 1, .limits = limits}}};
    const BodyState post_then{.position = {-0.2495401, 0}, .velocity = {-1.090011, 0}};
    const BodyState post_now{.position = {-0.2558, 0}, .velocity = {-0.375592, 0}};
    const BodyState door_then{.position = {0.3345097, 0.1109775},
                              .angle = 0.1877752,
                              .velocity = {-1.183949, 0.494373},
                              .angular_velocity = 0.846456};
    const BodyState door_now{.position = {0.3263484, 0.120555}, .angle = 0.2042, .velocity = {-0.375592, 0}};
    return status("displacement", scene, forged(frame, {{{post_then, door_then}}, {{post_now, door_now}}}), stated);
  };
  EXPECT_EQ(slows_down(Limits{-0.4187, 0.2042}), CheckStatus::held);
  EXPECT_EQ(slows_down({}), CheckStatus::broken) << "nothing stops it";
}

// A torque swings a box on a hinge, at rest 2 cm above the ground, down to it within the step, and it rests there.
TEST(DisplacementInvariant, AllowsAContactThatATorqueReachesWithinAStep) {
  Scene scene = box_on_ground();
  scene.bodies[1].position = {0, 0.52};
  scene.bodies.push_back({.name = "post", .type = BodyType::fixed, .position = {-1, 0.52}});
  scene.joints = {Revolute{.a = 2, .b = 1, .anchor = {-1, 0.52}}};
  const Mass box = mass_of(scene.bodies[1]);
  const double enough = 0.02 / (dt * dt) * std::sqrt(box.mass * box.inertia);
  const BodyState post{.position = {-1, 0.52}};
  const std::vector<BodyState> then{{}, {.position = {0, 0.52}}, post};
  const std::vector<BodyState> now{{}, {.position = {0, 0.5}, .angle = -0.02}, post};
  const auto swung_by = [&](double torque) {
    scene.forces = {Constant{.body = 1, .torque = torque}};
    return status("displacement", scene, forged(dt, {{then}, {now}}), exact);
  };
  EXPECT_EQ(swung_by(-1.1 * enough), CheckStatus::held);
  EXPECT_EQ(swung_by(-0.5 * enough), CheckStatus::broken);
}

// 9 m less 9 m is nothing to within the rounding of 9 m, 64 u of it in a step.
TEST(DisplacementInvariant, KnowsThatAPlaceNearTheOriginMayBeADifferenceOfLargerOnes) {
  Scene scene = box_on_ground();
  scene.bodies[0].position = {0, -20};
  const auto stopped_at = [&](double left) {
    std::vector<std::vector<BodyState>> states{box_at({9, 0}, {-900, 0}), box_at({0, 0}), box_at({left, 0})};
    for (auto& one : states) one[0].position = {0, -20};
    return forged(dt, {{states[0]}, {states[1]}, {states[2]}});
  };
  EXPECT_EQ(status("displacement", scene, stopped_at(1e-14), exact), CheckStatus::held);
  EXPECT_EQ(status("displacement", scene, stopped_at(1e-12), exact), CheckStatus::broken);
}

}  // namespace
}  // namespace plumb::displacement_test
