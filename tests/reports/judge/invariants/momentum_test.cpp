#include <gtest/gtest.h>

#include <cmath>

#include "forged_runs.h"
#include "scenarios/scene/mass.h"

namespace plumb::momentum_test {
namespace {

constexpr double dt = 0.01;
const Stepping exact{.dt = dt, .h = dt, .drift = 0, .impact_lag = 0};
const Stepping rounded_exact{.dt = dt, .h = dt, .drift = 0, .impact_lag = 0, .epsilon = 1e-16};

Scene two_boxes() {
  const Surface surface{.density = 1};
  return {.gravity = {},
          .bodies = {{.name = "a", .shapes = {{Box{}, surface}}},
                     {.name = "b", .position = {3, 0}, .shapes = {{Box{}, surface}}}}};
}

Trace after_a_push(Vec a, Vec b, double spin = 0) {
  return forged(dt, {{{{}, {.position = {3, 0}}}},
                     {{{.velocity = a, .angular_velocity = spin}, {.position = {3, 0}, .velocity = b}}}});
}

TEST(MomentumInvariant, IsBrokenByUnequalImpulses) {
  Stepping rounded = exact;
  rounded.epsilon = 1e-3;  // three roundings of 2 kg m/s
  EXPECT_EQ(status("momentum", two_boxes(), after_a_push({1, 0}, {-1, 0}), exact), CheckStatus::held);
  EXPECT_EQ(status("momentum", two_boxes(), after_a_push({1, 0}, {-1.005, 0}), rounded), CheckStatus::held);
  EXPECT_EQ(status("momentum", two_boxes(), after_a_push({1, 0}, {-1.007, 0}), rounded), CheckStatus::broken);
}

TEST(MomentumInvariant, SeesImpulsesThatRotateTheWhole) {
  EXPECT_EQ(status("angular_momentum", two_boxes(), after_a_push({1, 0}, {-1, 0}), exact), CheckStatus::held);
  EXPECT_EQ(status("momentum", two_boxes(), after_a_push({0, 1}, {0, -1}), exact), CheckStatus::held);
  EXPECT_EQ(status("angular_momentum", two_boxes(), after_a_push({0, 1}, {0, -1}), exact), CheckStatus::broken);
  // 3 m apart: I = 1/6 spins against it.
  EXPECT_EQ(status("angular_momentum", two_boxes(), after_a_push({0, 1}, {0, -1}, 18), {.epsilon = 1e-15}),
            CheckStatus::held);
}

TEST(MomentumInvariant, DoesNotApplyWithAnImmovableBody) {
  const Scene scene = box_on_ground();
  const Trace trace = forged(dt, {{box_at({0, 5})}, {box_at({0, 5})}});
  EXPECT_FALSE(checked("momentum", scene, trace, exact).has_value());
}

TEST(BodyMomentumInvariant, HoldsBodiesToTheReportedImpulses) {
  const Scene scene = box_on_ground(0.5, {0, -10});
  const auto moved = [&](double vy) {
    return forged(dt, {{box_at({0, 0.5}, {0, -1})}, {box_at({0, 0.5}, {0, vy}), {pushing(1.1, 0)}}});
  };
  EXPECT_EQ(status("momentum_of_bodies", scene, moved(0), rounded_exact), CheckStatus::held);
  EXPECT_EQ(status("momentum_of_bodies", scene, moved(2e-14), rounded_exact), CheckStatus::held);
  const auto broken = checked("momentum_of_bodies", scene, moved(1e-12), rounded_exact).value();
  EXPECT_EQ(broken.status, CheckStatus::broken);
  EXPECT_EQ(broken.where, "box");
}

// A gap of rounding, 1e-16 of .5 m, gives a velocity of 5e-15 m/s, of which again 1e-16 may be lost.
TEST(BodyMomentumInvariant, KnowsHowSmallAVelocityAtAContactCanBe) {
  const Scene scene = box_on_ground(0.5, {0, 0});
  const auto off_by = [&](double speed) {
    return forged(dt, {{box_at({0, 0.5})}, {box_at({0, 0.5}, {0, speed}), {pushing(0, 0)}}});
  };
  EXPECT_EQ(status("momentum_of_bodies", scene, off_by(1e-32), rounded_exact), CheckStatus::held);
  EXPECT_EQ(status("momentum_of_bodies", scene, off_by(1e-20), rounded_exact), CheckStatus::broken);
}

// Two discs of 1 m, one on the other, and an impulse straight up of 2 N s: if the upper one moves 1 mm sideways within
// the step, their normal rotates by 1/2000 and gives it 1 mm/s kg sideways, although both are at rest at both ends.
TEST(BodyMomentumInvariant, AllowsForRoundBodiesThatPassEachOtherWithinAStep) {
  Scene scene = box_on_ground(0.5, {0, -200});
  for (Body& body : scene.bodies) body.shapes[0].geometry = Circle{.radius = 1};
  const double mass = mass_of(scene.bodies[1]).mass;
  const auto carried = [&](double way, double vx) {
    return forged(dt, {{box_at({0, 2})}, {box_at({way, 2}, {vx, 0}), {pushing(2 * mass, 0)}}});
  };
  EXPECT_EQ(status("momentum_of_bodies", scene, carried(1e-3, 0.9e-3), rounded_exact), CheckStatus::held);
  EXPECT_EQ(status("momentum_of_bodies", scene, carried(1e-3, 1.1e-3), rounded_exact), CheckStatus::broken);
  EXPECT_EQ(status("momentum_of_bodies", scene, carried(0, 1e-5), rounded_exact), CheckStatus::broken);
}

TEST(BodyMomentumInvariant, LetsSleepStopABodyBelowTheStatedSpeed) {
  const Scene scene = box_on_ground(0.5, {0, -10});
  Stepping sleeping = rounded_exact;
  sleeping.rest_speed = 0.01;
  const auto stopped = [&](double before, double after) {
    return forged(dt, {{box_at({0, 0.5}, {before, 0})}, {box_at({0, 0.5}, {after, 0}), {pushing(0.1, 0)}}});
  };
  EXPECT_EQ(status("momentum_of_bodies", scene, stopped(0.009, 0), sleeping), CheckStatus::held);
  EXPECT_EQ(status("momentum_of_bodies", scene, stopped(0.009, 0), rounded_exact), CheckStatus::broken);
  EXPECT_EQ(status("momentum_of_bodies", scene, stopped(0.021, 0), sleeping), CheckStatus::broken);
  EXPECT_EQ(status("momentum_of_bodies", scene, stopped(0.009, 0.001), sleeping), CheckStatus::broken);
}

// Adding the momenta of n bodies rounds by up to n u of their sum, however exact each of them is.
TEST(MomentumInvariant, KnowsThatItsOwnSumsAreRounded) {
  Scene scene = two_boxes();
  for (int i = 0; i < 398; ++i) {
    scene.bodies.push_back(scene.bodies[1]);
    scene.bodies.back().position = {6.0 + 3 * i, 0};
  }
  const auto rising = [&](double share) {
    std::vector<BodyState> before(scene.bodies.size(), {.velocity = {1, 0}});
    std::vector<BodyState> after(scene.bodies.size(), {.velocity = {1 + share, 0}});
    return forged(dt, {{before}, {after}});
  };
  EXPECT_EQ(status("momentum", scene, rising(4e-14), exact), CheckStatus::held);
  EXPECT_EQ(status("momentum", scene, rising(2e-13), exact), CheckStatus::broken);
}

// At the end of its stroke on a spring the force is the same at both ends of a step, but larger in between.
TEST(MomentumInvariant, KnowsThatASpringTurnsWithinAStep) {
  constexpr double w = 10;  // rad/s
  Scene scene{.gravity = {}, .bodies = {{.name = "disc", .shapes = {{Circle{.radius = 1}, {.density = 1}}}}}};
  const double mass = mass_of(scene.bodies[0]).mass;
  scene.forces.push_back(Spring{.b = 0, .stiffness = w * w * mass, .length = 0});
  const auto turning = [&](double factor) {
    const Vec place{std::cos(w * dt / 2), 0};
    const double speed = w * std::sin(w * dt / 2);
    return forged(dt, {{{{.position = place, .velocity = {speed, 0}}}},
                       {{{.position = place, .velocity = {speed - factor * 2 * speed, 0}}}}});
  };
  EXPECT_EQ(status("momentum", scene, turning(1), rounded_exact), CheckStatus::held);
  EXPECT_EQ(status("momentum", scene, turning(1.01), rounded_exact), CheckStatus::broken);
  EXPECT_EQ(status("momentum", scene, turning(0.99), rounded_exact), CheckStatus::broken);
}

// Four sub-steps under one force, which is taken where they begin on average if velocities last.
TEST(MomentumInvariant, KnowsThatAForceMayBeTakenAhead) {
  constexpr double w = 10;  // rad/s
  constexpr int substeps = 4;
  const Stepping stepping{.dt = dt, .h = dt / substeps, .drift = 0.5, .impact_lag = 0, .epsilon = 1e-16};
  Scene scene{.gravity = {}, .bodies = {{.name = "disc", .shapes = {{Circle{.radius = 1}, {.density = 1}}}}}};
  const double mass = mass_of(scene.bodies[0]).mass;
  scene.forces.push_back(Spring{.b = 0, .stiffness = w * w * mass, .length = 0});
  const auto swinging = [&](double ahead) {
    Trace trace(1);
    BodyState disc{.position = {1, 0}};
    for (int i = 0; i <= 200; ++i) {
      trace.record(i * dt, {{disc}}, {});
      const double acceleration = -w * w * (disc.position.x + ahead * dt * disc.velocity.x);
      for (int k = 0; k < substeps; ++k) {
        disc.velocity.x += dt / substeps * acceleration;
        disc.position.x += dt / substeps * disc.velocity.x;
      }
    }
    return trace;
  };
  EXPECT_EQ(status("momentum", scene, swinging(3.0 / 8), stepping), CheckStatus::held);
  EXPECT_EQ(status("momentum", scene, swinging(11.0 / 8), stepping), CheckStatus::broken);
}

TEST(MomentumInvariant, KnowsThatABodyMayPassWhatPullsAtItBetweenTwoMoments) {
  constexpr double frame = 1.0 / 60;
  const Stepping stated{.dt = frame, .h = frame / 4, .drift = 0, .impact_lag = 0, .epsilon = 1e-16};
  const Scene scene = past_an_attraction();
  EXPECT_EQ(status("momentum", scene, flown_past(frame, 1), stated), CheckStatus::held);
  EXPECT_EQ(status("momentum", scene, flown_past(frame, 0), stated), CheckStatus::broken);
}

}  // namespace
}  // namespace plumb::momentum_test
