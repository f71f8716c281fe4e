#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "forged_runs.h"
#include "reports/judge/mechanics.h"
#include "scenarios/random.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/vec.h"

namespace plumb::free_motion_test {
namespace {

constexpr double dt = 0.01;
const Stepping exact{.dt = dt, .h = dt, .drift = 0, .impact_lag = 0, .epsilon = 1e-16};
const Stepping first_order{
    .dt = dt, .h = dt, .drift = 0.5, .impact_lag = 1, .skin = 0.01, .slop = 0.005, .epsilon = 1e-16};

// A box at a height over the ground, thrown; `velocity` and `height` by time.
Trace in_the_air(const std::function<Vec(double)>& position, const std::function<Vec(double)>& velocity) {
  Trace trace(2);
  for (int i = 0; i <= 40; ++i) trace.record(i * dt, box_at(position(i * dt), velocity(i * dt)), {});
  return trace;
}

Trace falling(double gravity, double order = 0) {
  return in_the_air(
      [=](double t) {
        return Vec{t, 9 - gravity * t * (t + 2 * order * dt) / 2};
      },
      [=](double t) {
        return Vec{1, -gravity * t};
      });
}

TEST(FreeMotionInvariant, IsHeldByAFallOfAnyOrder) {
  const Scene scene = box_on_ground(0.5, {0, -10});
  for (const double order : {0.0, 0.5, -0.5}) {
    for (const Stepping& stepping : {exact, first_order}) {
      const InvariantCheck check = checked("free_motion", scene, falling(10, order), stepping).value();
      EXPECT_EQ(check.status, CheckStatus::held) << order << ": " << check.value << " of " << check.tolerance;
      EXPECT_TRUE(is_evidence(check)) << check.tolerance << " of " << check.scale;
    }
  }
}

TEST(FreeMotionInvariant, IsBrokenByWhatHangsOrCoastsInMidAir) {
  const Scene scene = box_on_ground(0.5, {0, -10});
  for (const double gravity : {0.0, 5.0, 9.99, 10.01}) {
    const InvariantCheck check = checked("free_motion", scene, falling(gravity), first_order).value();
    EXPECT_EQ(check.status, CheckStatus::broken) << gravity;
    EXPECT_EQ(check.where, "box");
    EXPECT_NEAR(check.value, std::abs(gravity - 10) * dt, 1e-12);
  }
  const auto frozen = [](double) { return Vec{0, 9}; };
  const auto still = [](double) { return Vec{}; };
  EXPECT_EQ(status("free_motion", scene, in_the_air(frozen, still), first_order), CheckStatus::broken);
}

TEST(FreeMotionInvariant, IsNotTestedByWhatMayTouch) {
  const Scene scene = box_on_ground(0.5, {0, -10});
  const auto lying = [](double gap) {
    return in_the_air([=](double) { return Vec{0, 0.5 + gap}; }, [](double) { return Vec{}; });
  };
  const InvariantCheck within_skin = checked("free_motion", scene, lying(0.0109), first_order).value();
  EXPECT_EQ(within_skin.status, CheckStatus::held);
  EXPECT_FALSE(is_evidence(within_skin));
  EXPECT_EQ(status("free_motion", scene, lying(0.0111), first_order), CheckStatus::broken);
}

TEST(FreeMotionInvariant, SeesAnEngineThatStopsWhatNothingPulls) {
  const Scene scene = box_on_ground(0.5, {});
  const auto ahead = [](double t) { return Vec{t, 5}; };
  const auto slowed = [](double by) { return [by](double t) { return Vec{1 - by * t, 0}; }; };
  const InvariantCheck check = checked("free_motion", scene, in_the_air(ahead, slowed(0)), exact).value();
  EXPECT_EQ(check.status, CheckStatus::held);
  EXPECT_TRUE(is_evidence(check));
  EXPECT_EQ(status("free_motion", scene, in_the_air(ahead, slowed(0.01)), exact), CheckStatus::broken);
}

TEST(FreeMotionInvariant, CountsDamping) {
  Scene scene = box_on_ground(0.5, {});
  scene.bodies[1].linear_damping = 2;
  const auto ahead = [](double) { return Vec{0, 5}; };
  const auto damped = [](double rate) { return [rate](double t) { return Vec{std::exp(-rate * t), 0}; }; };
  EXPECT_EQ(status("free_motion", scene, in_the_air(ahead, damped(2)), exact), CheckStatus::held);
  EXPECT_EQ(status("free_motion", scene, in_the_air(ahead, damped(1.9)), exact), CheckStatus::broken);
}

// Bars of 1 m in a row, the first held by the world, all hanging at an angle from the vertical.
Scene chain(int links, double angle) {
  Scene scene{.gravity = {0, -10}, .bodies = {{.name = "ceiling", .type = BodyType::fixed}}};
  Vec anchor;
  for (int i = 0; i < links; ++i) {
    const Vec along = rotated({0, -1}, angle);
    scene.bodies.push_back({.name = "link " + std::to_string(i + 1),
                            .position = anchor + 0.5 * along,
                            .angle = angle,
                            .shapes = {{Box{.size = {0.1, 1}}, {.density = 10}}}});
    scene.joints.push_back(
        Revolute{.a = static_cast<std::size_t>(i), .b = static_cast<std::size_t>(i) + 1, .anchor = anchor});
    anchor = anchor + along;
  }
  return scene;
}

// A compound pendulum of one bar: w' = -m g r sin(angle)/(I + m r^2), r = 1/2 m, by small steps of symplectic Euler;
// with a factor on gravity.
Trace pendulum(const Scene& scene, double angle, double factor) {
  constexpr int parts = 1000;
  const Mass mass = mass_of(scene.bodies[1]);
  const double rate = 10 * mass.mass * 0.5 / (mass.inertia + mass.mass * 0.25);
  Trace trace(2);
  double w = 0;
  for (int i = 0; i <= 40; ++i) {
    const Vec arm = rotated({0, -0.5}, angle);
    std::vector<BodyState> states = initial_states(scene);
    states[1] = {.position = arm, .angle = angle, .velocity = w * Vec{-arm.y, arm.x}, .angular_velocity = w};
    trace.record(i * dt, states, {});
    for (int part = 0; part < parts; ++part) {
      w -= dt / parts * rate * factor * std::sin(angle);
      angle += dt / parts * w;
    }
  }
  return trace;
}

TEST(FreeMotionInvariant, FitsTheImpulsesOfJoints) {
  const Scene scene = chain(1, 1);
  const InvariantCheck held = checked("free_motion", scene, pendulum(scene, 1, 1), exact).value();
  EXPECT_EQ(held.status, CheckStatus::held) << held.value << " of " << held.tolerance << " at " << held.time;
  EXPECT_TRUE(is_evidence(held)) << held.tolerance << " of " << held.scale;
  for (const double factor : {0.0, 0.5, 0.98, 1.02}) {
    EXPECT_EQ(status("free_motion", scene, pendulum(scene, 1, factor), exact), CheckStatus::broken) << factor;
  }
}

TEST(FreeMotionInvariant, LetsALimitPushOnlyWhereItIsReachedAndOnlyAway) {
  const double far = 10;
  const auto limited = [](Limits limits) {
    Scene scene = chain(1, 1);
    scene.joints = {Revolute{.a = 0, .b = 1, .limits = limits}};
    return scene;
  };
  // It swings down, and no limit is near but the upper one, where it starts.
  for (const double high : {0.0, far}) {
    const Scene scene = limited({-far, high});
    EXPECT_EQ(status("free_motion", scene, pendulum(scene, 1, 1), exact), CheckStatus::held) << high;
    for (const double factor : {0.0, 0.5, 0.98, 1.02}) {
      EXPECT_EQ(status("free_motion", scene, pendulum(scene, 1, factor), exact), CheckStatus::broken) << factor;
    }
  }
  // The lower limit, where it starts, carries it.
  const Scene carried = limited({0, far});
  EXPECT_EQ(status("free_motion", carried, pendulum(carried, 1, 0), exact), CheckStatus::held);
  // It may stop it at any moment of a step.
  const Scene stopped = limited({-0.0303, far});
  Trace trace(2);
  const Trace swings = pendulum(stopped, 1, 1);
  std::size_t last = 0;
  for (std::size_t i = 0; swings.states(i)[1].angle > 1 - 0.0303; last = i++) {
    trace.record(swings.time(i), std::vector<BodyState>(swings.states(i).begin(), swings.states(i).end()), {});
  }
  std::vector<BodyState> at_rest = initial_states(stopped);
  at_rest[1] = {.position = rotated({0, -0.5}, 1 - 0.0303), .angle = 1 - 0.0303};
  for (std::size_t i = last + 1; i < last + 4; ++i) trace.record(dt * static_cast<double>(i), at_rest, {});
  const InvariantCheck check = checked("free_motion", stopped, trace, exact).value();
  EXPECT_EQ(check.status, CheckStatus::held) << check.value << " of " << check.tolerance << " at " << check.time;
}

Trace frozen(const Scene& scene) {
  Trace trace(scene.bodies.size());
  for (int i = 0; i <= 2; ++i) trace.record(i * dt, initial_states(scene), {});
  return trace;
}

// It stops a step and a half before it would reach the limit.
TEST(FreeMotionInvariant, LetsALimitBrakeEarlyByTheStatedLead) {
  Scene scene = chain(1, 1);
  const Trace swings = pendulum(scene, 1, 1);
  constexpr std::size_t at = 10;
  const BodyState& before = swings.states(at)[1];
  const double reached = before.angle + dt * before.angular_velocity;
  const double limit = before.angle + 1.5 * dt * before.angular_velocity - 1;
  scene.joints = {Revolute{.a = 0, .b = 1, .limits = Limits{limit, 10}}};
  Trace trace(2);
  for (std::size_t i = 0; i <= at; ++i) {
    trace.record(swings.time(i), std::vector<BodyState>(swings.states(i).begin(), swings.states(i).end()), {});
  }
  std::vector<BodyState> at_rest = initial_states(scene);
  at_rest[1] = {.position = rotated({0, -0.5}, reached), .angle = reached};
  trace.record(dt * (at + 1), at_rest, {});
  Stepping stated = exact;
  EXPECT_EQ(status("free_motion", scene, trace, stated), CheckStatus::broken);
  stated.impact_lead = 1;
  EXPECT_EQ(status("free_motion", scene, trace, stated), CheckStatus::held);
}

TEST(FreeMotionInvariant, IsBrokenByAChainThatHangsFrozenInMidSwing) {
  const Scene swinging = chain(30, 0.5);
  EXPECT_EQ(status("free_motion", swinging, frozen(swinging), first_order), CheckStatus::broken);
  // Straight down it may hang: its joints carry it, and nothing is tested.
  const Scene hanging = chain(30, 0);
  const InvariantCheck held = checked("free_motion", hanging, frozen(hanging), first_order).value();
  EXPECT_EQ(held.status, CheckStatus::held) << held.value << " of " << held.tolerance;
  EXPECT_FALSE(is_evidence(held)) << held.tolerance << " of " << held.scale;
}

// A bob on a rod of 1 m that falls from above its post: the rod pushes at first and pulls later, and in the step in
// which it passes zero the mean of its impulse says nothing of its size. By velocity Verlet; with a factor on gravity.
TEST(FreeMotionInvariant, KnowsThatAnImpulseMayPassZeroWithinAStep) {
  Scene scene = chain(1, 1);
  const auto falls = [&scene](double angle, double factor) {
    constexpr int parts = 200;
    constexpr double part = dt / parts;
    const Vec start = rotated({0, -1}, angle);
    scene.bodies[1].position = start;
    scene.bodies[1].angle = 0;
    scene.joints = {Distance{.a = 0, .b = 1, .anchor_b = start, .length = 1}};
    Trace trace(2);
    double w = 0;
    for (int i = 0; i <= 80; ++i) {
      const Vec arm = rotated({0, -1}, angle);
      trace.record(i * dt, std::vector<BodyState>{{}, {.position = arm, .velocity = w * perpendicular(arm)}}, {});
      for (int k = 0; k < parts; ++k) {
        w -= part / 2 * 10 * factor * std::sin(angle);
        angle += part * w;
        w -= part / 2 * 10 * factor * std::sin(angle);
      }
    }
    return checked("free_motion", scene, trace, exact).value();
  };
  for (const double angle : {1.9, 2.0, 2.1, 2.2, 2.3, 2.4, 2.5, 2.6}) {
    const InvariantCheck held = falls(angle, 1);
    EXPECT_EQ(held.status, CheckStatus::held) << held.value << " of " << held.tolerance << " at " << held.time;
    EXPECT_EQ(falls(angle, 1.02).status, CheckStatus::broken) << angle;
  }
}

TEST(FreeMotionInvariant, FitsTheOtherJointsToo) {
  Scene scene = chain(1, 1);
  scene.joints = {Weld{.a = 0, .b = 1}};
  EXPECT_EQ(status("free_motion", scene, frozen(scene), exact), CheckStatus::held);
  scene.joints = {Prismatic{.a = 0, .b = 1, .axis = {1, 0}}};
  EXPECT_EQ(status("free_motion", scene, frozen(scene), exact), CheckStatus::held);
  scene.joints = {Prismatic{.a = 0, .b = 1, .axis = {0, 1}}};
  EXPECT_EQ(status("free_motion", scene, frozen(scene), exact), CheckStatus::broken);
  const Vec centre = scene.bodies[1].position;
  scene.joints = {Distance{.a = 0, .b = 1, .anchor_a = centre + Vec{0, 1}, .anchor_b = centre, .length = 1}};
  EXPECT_EQ(status("free_motion", scene, frozen(scene), exact), CheckStatus::held);
  scene.joints = {Distance{.a = 0, .b = 1, .anchor_a = centre + Vec{1, 1}, .anchor_b = centre, .length = std::sqrt(2)}};
  EXPECT_EQ(status("free_motion", scene, frozen(scene), exact), CheckStatus::broken);
}

// What an impact left of 1 m/s is nothing to within the rounding of 1 m/s, 64 u of it in a step.
TEST(FreeMotionInvariant, KnowsThatASmallVelocityMayBeADifferenceOfLargerOnes) {
  const Scene scene = box_on_ground();
  const auto stopped = [&](double left) {
    return forged(dt, {{box_at({0, 9}, {0, -1})},
                       {box_at({0, 8.99}, {0, -1})},
                       {box_at({0, 0.5})},  // whatever happens on the ground
                       {box_at({0, 9})},
                       {box_at({0, 9}, {0, left})}});
  };
  EXPECT_EQ(status("free_motion", scene, stopped(1e-15), exact), CheckStatus::held);
  EXPECT_EQ(status("free_motion", scene, stopped(1e-13), exact), CheckStatus::broken);
}

// 64 u of 9 m over a step of 0.01 s.
TEST(FreeMotionInvariant, KnowsThatAVelocityMayBeADifferenceOfPositions) {
  const Scene scene = box_on_ground();
  const auto thrown = [&](double gained) {
    return forged(dt, {{box_at({0, 9}, {0, 1})}, {box_at({0, 9.01}, {0, 1 + gained})}});
  };
  Stepping stepping = exact;
  EXPECT_EQ(status("free_motion", scene, thrown(2e-12), stepping), CheckStatus::broken);
  stepping.differenced_velocities = true;
  EXPECT_EQ(status("free_motion", scene, thrown(2e-12), stepping), CheckStatus::held);
  EXPECT_EQ(status("free_motion", scene, thrown(1e-10), stepping), CheckStatus::broken);
}

// Places rounded to u X of 2 m change the energy of a swinging bar by m g u X in each sub-step, and near its turning
// point that is much of its speed. Gravity that is 2 % wrong shows all the same.
TEST(FreeMotionInvariant, KnowsThatJointsRoundPlacesAndSoTheEnergy) {
  const Scene scene = chain(1, 0.3);
  Stepping single = exact;
  single.epsilon = 0x1p-24;
  const double mass = mass_of(scene.bodies[1]).mass;
  const double energy = mass * 10 * single.epsilon * 2;  // X: .5 m to the centre and as much to the anchor, or less
  const auto rounded = [&](double share, double factor, const Stepping& stepping) {
    Trace trace(2);
    const Trace exactly = pendulum(scene, 0.3, factor);
    for (std::size_t i = 0; i < exactly.size(); ++i) {
      std::vector<BodyState> states(exactly.states(i).begin(), exactly.states(i).end());
      BodyState& bar = states[1];
      const double w = bar.angular_velocity;
      const double turned = mass_of(scene.bodies[1]).inertia + mass / 4;  // about the pivot
      const double other = std::copysign(std::sqrt(w * w + 2 * share * energy / turned), w);
      bar.velocity = bar.velocity + (other - w) * Vec{-bar.position.y, bar.position.x};
      bar.angular_velocity = other;
      trace.record(exactly.time(i), states, {});
      share = -share;
    }
    return checked("free_motion", scene, trace, stepping).value();
  };
  const InvariantCheck held = rounded(0.2, 1, single);
  EXPECT_EQ(held.status, CheckStatus::held) << held.value << " of " << held.tolerance << " at " << held.time;
  EXPECT_TRUE(is_evidence(held));
  EXPECT_EQ(rounded(10, 1, single).status, CheckStatus::broken);
  EXPECT_EQ(rounded(0.2, 1, exact).status, CheckStatus::broken) << "in double precision";
  for (const double factor : {0.98, 1.02}) EXPECT_EQ(rounded(0, factor, single).status, CheckStatus::broken);
}

// Two bodies on a rail that fly side by side, so that their joint has nothing to do but what rounding leaves.
TEST(FreeMotionInvariant, FitsNothingToTheRoundingOfJointsAtRest) {
  Scene scene{.gravity = {}, .bodies = {{.name = "one"}, {.name = "other", .position = {2, -2}}}};
  for (Body& body : scene.bodies) {
    body.velocity = {-0.1, 2};
    body.shapes = {{Box{.size = {0.4, 0.6}}, {.density = 5}}};
  }
  Random random(1);
  const auto rounding = [&] { return std::round(random.between(-2, 2)) * 0x1p-53; };
  for (int rail = 0; rail < 200; ++rail) {
    const Vec anchor{random.between(-1, 1), random.between(-1, 1)};
    scene.joints = {Prismatic{.a = 0, .b = 1, .anchor = anchor, .axis = rotated({1, 0}, random.between(0, 6))}};
    Trace trace(2);
    for (int i = 0; i <= 200; ++i) {
      std::vector<BodyState> states = initial_states(scene);
      for (BodyState& state : states) {
        state.velocity = state.velocity + Vec{rounding(), rounding()};
        state.angular_velocity = rounding();
      }
      trace.record(i * dt, states, {});
    }
    const InvariantCheck check = checked("free_motion", scene, trace, first_order).value();
    EXPECT_EQ(check.status, CheckStatus::held) << check.value << " of " << check.tolerance << " at " << check.time;
    EXPECT_LT(check.tolerance, 1e-12);
  }
}

// A place is known to 30 m u, and put right in a step: 3e-13 m/s, or 2.4 times that in rad/s.
TEST(FreeMotionInvariant, LetsAJointPutPlacesRight) {
  EXPECT_EQ(status("free_motion", far_hinge(), sets_off(dt, 7e-13), exact), CheckStatus::held);
  EXPECT_EQ(status("free_motion", far_hinge(), sets_off(dt, 8e-13), exact), CheckStatus::broken);
}

}  // namespace
}  // namespace plumb::free_motion_test
