#include <gtest/gtest.h>

#include <cmath>

#include "../../fakes.h"
#include "forged_runs.h"
#include "scenarios/scene/mass.h"

namespace plumb::energy_test {
namespace {

constexpr double h = 0.01;
const Stepping symplectic{.dt = h, .h = h, .drift = 0.5, .impact_lag = 1};
const Stepping second_order{.dt = h, .h = h, .drift = 0, .impact_lag = 0};

Trace speeds(double before, double after) {
  return forged(h, {{box_at({0, 5}, {before, 0})}, {box_at({0, 5}, {after, 0})}});
}

TEST(EnergyInvariant, NeverRisesIfNothingActs) {
  const Scene scene = box_on_ground();
  EXPECT_EQ(status("energy", scene, speeds(1, 1), symplectic), CheckStatus::held);
  EXPECT_EQ(status("energy", scene, speeds(1, 0.5), symplectic), CheckStatus::held);
  const auto check = checked("energy", scene, speeds(1, 1.1), symplectic).value();
  EXPECT_EQ(check.status, CheckStatus::broken);
  EXPECT_NEAR(check.value, (1.21 - 1) / 2, 1e-12);
  EXPECT_DOUBLE_EQ(check.time, h);
}

// A box that swings through its hinge with the frequency of the hinge's spring, and one with twice the energy it gave.
TEST(EnergyInvariant, CountsWhatJointsHoldThatAreStatedToBeSprings) {
  Scene scene = box_on_ground();
  scene.bodies[0].shapes.clear();
  scene.joints.push_back(Revolute{.a = 0, .b = 1, .anchor = {0, 0.5}});
  constexpr double w = 20;  // rad/s
  const auto swings = [&](double factor) {
    Trace trace(2);
    for (int i = 0; i <= 100; ++i) {
      const double t = i * h;
      const double grown = t > 0.5 ? factor : 1;
      trace.record(t, box_at({0.1 * std::sin(w * t), 0.5}, {grown * 0.1 * w * std::cos(w * t), 0}), {});
    }
    return trace;
  };
  Stepping springs = second_order;
  springs.epsilon = 1e-12;
  EXPECT_EQ(status("energy", scene, swings(1), springs), CheckStatus::broken);
  springs.joint_frequency = w / (2 * std::acos(-1.0));
  EXPECT_EQ(status("energy", scene, swings(1), springs), CheckStatus::held);
  EXPECT_EQ(status("energy", scene, swings(1.5), springs), CheckStatus::broken);
}

// A disc of 10 N that turns at 6 rad/s is let down by .5 m (1 - cos .06) = .9 mm, and lifted by that again. A box is
// not: it turns on a corner, which stays the same point of it.
TEST(EnergyInvariant, CountsWhatHeldPointsLetDownAndLiftAgain) {
  const Scene box = box_on_ground(0.5, {0, -10});
  Scene disc = box;
  disc.bodies[1].shapes[0] = {Circle{.radius = 0.5}, {.density = 4 / std::acos(-1.0)}};
  const auto lifted = [](double height) {
    std::vector<Moment> moments;
    for (int i = 0; i < 100; ++i) {
      std::vector<BodyState> states = box_at({0, i < 50 ? 0.5 : 0.5 + height});
      states[1].angular_velocity = 6;
      states[1].angle = 6 * h * i;
      moments.push_back({states, {pushing(10 * h)}});
    }
    return forged(h, moments);
  };
  Stepping held = second_order;
  EXPECT_EQ(status("energy", disc, lifted(0.0008), held), CheckStatus::broken);
  held.held_anchors = true;
  EXPECT_EQ(status("energy", disc, lifted(0.0008), held), CheckStatus::held);
  EXPECT_EQ(status("energy", disc, lifted(0.0011), held), CheckStatus::broken);
  EXPECT_EQ(status("energy", box, lifted(0.0008), held), CheckStatus::broken);
}

TEST(EnergyInvariant, AllowsRoundingAndNoMore) {
  Stepping rounded = second_order;
  rounded.epsilon = 1e-7;  // three roundings of m v^2 = 1 J
  EXPECT_EQ(status("energy", box_on_ground(), speeds(1, 1 + 2e-7), rounded), CheckStatus::held);
  EXPECT_EQ(status("energy", box_on_ground(), speeds(1, 1 + 4e-7), rounded), CheckStatus::broken);
}

// Thrown up at 1 m/s: symplectic Euler loses g v h/2, explicit Euler gains as much, and a second-order method does
// neither.
Trace thrown(double order) {
  Trace trace(2);
  for (int i = 0; i <= 100; ++i) {
    const double t = i * h;
    trace.record(t, box_at({0, 9 + t - 5 * t * t - order * 10 * t * h}, {0, 1 - 10 * t}), {});
  }
  return trace;
}

TEST(EnergyInvariant, AccountsForTheOrderOfTheMethod) {
  const Scene scene = box_on_ground(0.5, {0, -10});
  Stepping before = symplectic;
  Stepping after = symplectic;
  after.drift = -0.5;
  before.epsilon = after.epsilon = 1e-16;
  EXPECT_EQ(status("energy", scene, thrown(0.5), before), CheckStatus::held);
  EXPECT_EQ(status("energy", scene, thrown(-0.5), after), CheckStatus::held);
  EXPECT_EQ(status("energy", scene, thrown(-0.5), before), CheckStatus::broken);
  EXPECT_EQ(status("energy", scene, thrown(-0.5), second_order), CheckStatus::broken);
  EXPECT_EQ(status("energy", scene, thrown(-0.51), after), CheckStatus::broken);
}

// A spring of w = 2 stretched by 1 m, stepped by explicit Euler, where E grows by 1 + (w h)^2 a step, or by symplectic
// Euler.
Trace on_a_spring(bool explicitly) {
  Trace trace(1);
  double x = 1;
  double v = 0;
  for (int i = 0; i <= 2000; ++i) {
    const BodyState state{.position = {2 + x, 0}, .velocity = {v, 0}};
    trace.record(i * h, std::span(&state, 1), {});
    const double was = v;
    v -= 4 * h * x;
    x += h * (explicitly ? was : v);
  }
  return trace;
}

TEST(EnergyInvariant, IsBrokenByExplicitEulerOnASpring) {
  const Scene scene{.gravity = {},
                    .bodies = {{.name = "box", .position = {3, 0}, .shapes = {{Box{}, {.density = 1}}}}},
                    .forces = {Spring{.b = 0, .stiffness = 4, .length = 2}}};
  EXPECT_EQ(status("energy", scene, on_a_spring(false), symplectic), CheckStatus::held);
  EXPECT_EQ(status("energy", scene, on_a_spring(true), symplectic), CheckStatus::broken);
}

// Two boxes that turn about a hinge between them, whose energy oscillates by h^2/12 times the squares of the forces
// that hold them.
TEST(EnergyInvariant, CountsTheForcesOfJointsAndNotWhatTheyGain) {
  const auto box = [](const char* name, double x) {
    return Body{.name = name, .position = {x, 0}, .layers = 0, .shapes = {{Box{}, {.density = 1}}}};
  };
  Scene scene{.name = "pair", .duration = 1, .bodies = {box("left", -1), box("right", 1)}};
  const auto spinning = [](double gain) {
    Trace trace(2);
    for (int i = 0; i <= 50; ++i) {
      const double w = 5 * (1 + gain * i);
      const Vec place = rotated({1, 0}, 5 * i * h);
      const Vec velocity{-w * place.y, w * place.x};
      const std::vector<BodyState> states{{-1 * place, 5 * i * h, -1 * velocity, w}, {place, 5 * i * h, velocity, w}};
      trace.record(i * h, states, {});
    }
    return trace;
  };
  for (Body& body : scene.bodies) body.angular_velocity = 5;
  scene.bodies[0].velocity = {0, -5};
  scene.bodies[1].velocity = {0, 5};
  Scene hinged = scene;
  hinged.joints.push_back(Revolute{.a = 0, .b = 1});
  EXPECT_EQ(status("energy", hinged, spinning(1e-6), second_order), CheckStatus::held);
  EXPECT_EQ(status("energy", scene, spinning(1e-6), second_order), CheckStatus::broken);
  EXPECT_EQ(status("energy", hinged, spinning(1e-2), second_order), CheckStatus::broken);
  EXPECT_EQ(status("energy", hinged, spinning(10), second_order), CheckStatus::broken) << "no matter how fast it gets";
}

// An impact at 1 m/s that is noticed 1 cm late; lifting the box out takes m g v h.
TEST(EnergyInvariant, LetsALateImpactBePushedOut) {
  const Scene scene = box_on_ground(0.5, {0, -10});
  const auto lifted = [](double by) {
    return forged(h, {{box_at({0, 0.5}, {0, -1})}, {box_at({0, 0.5 + by}, {0, 1})}});
  };
  // m g by <= (|d| + lag) h m g (1 + 1), and the modified energy has lost d h m g (1 + 1)
  const double tolerance = (1.5 + 0.5) * h * 2;
  EXPECT_EQ(status("energy", scene, lifted(0.99 * tolerance), symplectic), CheckStatus::held);
  EXPECT_EQ(status("energy", scene, lifted(1.01 * tolerance), symplectic), CheckStatus::broken);
  EXPECT_EQ(status("energy", scene, lifted(0.1 * tolerance), second_order), CheckStatus::broken);
}

// Pushed out in one step, stopped in the next: of 1 m/s, against 10 N, 10 N m/s h (|d| + lag) = 0.15 J.
TEST(EnergyInvariant, LetsPositionsBePushedOutOneStepBeforeVelocitiesStop) {
  const Scene scene = box_on_ground(0.5, {0, -10});
  const auto lifted = [](double by, double speed) {
    return forged(h,
                  {{box_at({0, 0.5}, {0, -1})}, {box_at({0, 0.5 + by}, {0, -1})}, {box_at({0, 0.5 + by}, {0, speed})}});
  };
  Stepping separate = symplectic;
  separate.position_iterations = 3;
  EXPECT_EQ(status("energy", scene, lifted(0.0149, 0), separate), CheckStatus::held);
  EXPECT_EQ(status("energy", scene, lifted(0.0151, 0), separate), CheckStatus::broken);
  EXPECT_EQ(status("energy", scene, lifted(0.0149, -1), separate), CheckStatus::broken) << "it is never stopped";
  EXPECT_EQ(status("energy", scene, lifted(0.0149, 0), symplectic), CheckStatus::broken) << "states no such positions";
}

TEST(EnergyInvariant, CountsTheWorkOfConstantForcesAndOfKinematicBodies) {
  Scene pulled = box_on_ground();
  pulled.forces = {Constant{.body = 1, .force = {2, 0}}};
  // From rest over 1 m with 2 N: 2 J.
  const auto after = [](double speed) { return forged(1, {{box_at({0, 5})}, {box_at({1, 5}, {speed, 0})}}); };
  const Stepping exact{.dt = 1};
  EXPECT_EQ(status("energy", pulled, after(1.999), exact), CheckStatus::held);
  EXPECT_EQ(status("energy", pulled, after(2.001), exact), CheckStatus::broken);

  Scene driven = box_on_ground();
  driven.bodies[0].type = BodyType::kinematic;
  driven.bodies[0].velocity = {0, 3};
  const auto hit = [](double speed, std::vector<ContactState> contacts) {
    const BodyState ground{.velocity = {0, 3}};
    return forged(h, {{{ground, box_at({0, 5})[1]}}, {{ground, box_at({0, 5}, {0, speed})[1]}, std::move(contacts)}});
  };
  EXPECT_EQ(status("energy", driven, hit(3, {pushing(3)}), exact), CheckStatus::held);
  EXPECT_EQ(status("energy", driven, hit(4.3, {pushing(3)}), exact), CheckStatus::broken);
  EXPECT_EQ(status("energy", driven, hit(3, {}), exact), CheckStatus::broken) << "what touches nothing drives nothing";
  const BodyState ground{.velocity = {0, 3}};
  const Trace touching = forged(h, {{{ground, box_at({0, 0.5})[1]}}, {{ground, box_at({0, 0.5}, {0, 3})[1]}}});
  EXPECT_EQ(status("energy", driven, touching, exact), CheckStatus::not_reported);
}

// A disc of 1 m that may not turn but spins at -5 rad/s: friction drives it along, and what keeps up its spin works
// twice what it gains, until it rolls.
TEST(EnergyInvariant, CountsTheWorkOfASpinThatNothingSlows) {
  Scene scene = box_on_ground();
  Body& motor = scene.bodies[1];
  motor.shapes[0].geometry = Circle{.radius = 1};
  motor.angular_velocity = -5;
  motor.fixed_rotation = true;
  const double mass = mass_of(motor).mass;
  const auto driven = [&](double spin, double gained) {
    const auto disc = [&](double x, double v) {
      return std::vector<BodyState>{{}, {.position = {x, 1}, .velocity = {v, 0}, .angular_velocity = spin}};
    };
    ContactState contact = pushing(1, -0.1 * mass);  // along the tangent of the ground's normal, (-1, 0)
    return forged(h, {{disc(0, 0)}, {disc(0, gained), {contact}}});
  };
  EXPECT_EQ(status("energy", scene, driven(-5, 0.1), second_order), CheckStatus::held);
  EXPECT_EQ(status("energy", scene, driven(-5, 2), second_order), CheckStatus::broken);
  EXPECT_FALSE(checked("energy_bound", scene, driven(-5, 2), second_order).has_value());
}

TEST(EnergyInvariant, KnowsThatABodyMayPassWhatPullsAtItBetweenTwoMoments) {
  constexpr double dt = 1.0 / 60;
  const Stepping stated{.dt = dt, .h = dt / 4, .drift = 0, .impact_lag = 0, .epsilon = 1e-16};
  const Scene scene = past_an_attraction();
  EXPECT_EQ(status("energy", scene, flown_past(dt, 1), stated), CheckStatus::held);
  EXPECT_EQ(status("energy", scene, flown_past(dt, -1), stated), CheckStatus::broken);
}

// At 15 m u/dt, v u 15 m/dt, of which v/2 + v/12 is spent.
TEST(EnergyInvariant, LetsAJointPutPlacesRight) {
  const Stepping stated{.dt = 0.01, .h = 0.01, .drift = 0, .impact_lag = 0, .epsilon = 1e-16};
  EXPECT_EQ(status("energy", far_hinge(), sets_off(0.01, 2.5e-13), stated), CheckStatus::held);
  EXPECT_EQ(status("energy", far_hinge(), sets_off(0.01, 2.7e-13), stated), CheckStatus::broken);
}

}  // namespace
}  // namespace plumb::energy_test
