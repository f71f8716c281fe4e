#include "reports/judge/mechanics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../fakes.h"
#include "reference/adapter.h"
#include "scenarios/scene/vec.h"

namespace plumb::mechanics_test {
namespace {

TEST(Conserved, MatchesABoxComputedByHand) {
  const Scene scene = fakes::thrown_box();
  const Conserved conserved(scene);
  const auto start = initial_states(scene);
  const double inertia = 2 * (1 + 4) / 12.0;
  const Energy energy = conserved.energy(start);
  EXPECT_DOUBLE_EQ(energy.linear, 9 + 64);
  EXPECT_DOUBLE_EQ(energy.rotational, inertia * 16 / 2);
  EXPECT_DOUBLE_EQ(energy.potential, 2 * 10 * 2);
  const Momentum momentum = conserved.momentum(start);
  EXPECT_EQ(momentum.linear, (Vec{6, 16}));
  EXPECT_DOUBLE_EQ(momentum.angular, 1 * 16 - 2 * 6 + inertia * 4);
}

TEST(Conserved, EnergyIsConstantInFreeFlight) {
  const Scene scene = fakes::thrown_box();
  const Conserved conserved(scene);
  const Trace trace = fakes::flight_of(scene, 0.1);
  for (std::size_t i = 0; i < trace.size(); ++i) {
    EXPECT_NEAR(conserved.energy(trace.states(i)).total(), conserved.energy(trace.states(0)).total(), 1e-11);
  }
}

TEST(Conserved, GravityScaleScalesThePotential) {
  Scene scene = fakes::thrown_box();
  scene.bodies[0].gravity_scale = -0.5;
  EXPECT_DOUBLE_EQ(Conserved(scene).energy(initial_states(scene)).potential, -20);
}

TEST(Conserved, SkipsBodiesThatAreNotDynamic) {
  Scene scene = fakes::thrown_box();
  scene.bodies.push_back(scene.bodies[0]);
  scene.bodies[1].type = BodyType::kinematic;
  EXPECT_DOUBLE_EQ(Conserved(scene).energy(initial_states(scene)).total(),
                   Conserved(fakes::thrown_box()).energy(initial_states(fakes::thrown_box())).total());
}

// The anchor sits 1 m right of a box rotated by 90 degrees, so 1 m above its centre: (0, 1), 3 m from (0, 4).
TEST(Conserved, ASpringStoresHalfKTimesItsExtensionSquared) {
  Scene scene = fakes::thrown_box();
  scene.gravity = {0, 0};
  scene.bodies[0].position = {0, 0};
  scene.bodies[0].angle = std::acos(-1.0) / 2;
  scene.forces = {Spring{.b = 0, .anchor_a = {0, 4}, .anchor_b = {1, 0}, .stiffness = 8, .length = 1}};
  EXPECT_NEAR(Conserved(scene).energy(initial_states(scene)).potential, 8 * 2 * 2 / 2.0, 1e-12);
}

TEST(Conserved, ASoftDistanceJointIsASpring) {
  Scene scene = fakes::thrown_box();
  scene.gravity = {0, 0};
  scene.bodies.push_back({.name = "post", .type = BodyType::fixed});
  scene.joints = {Distance{.a = 1, .b = 0, .anchor_a = {1, 0}, .anchor_b = {1, 3}, .length = 1, .stiffness = 8}};
  EXPECT_NEAR(Conserved(scene).energy(initial_states(scene)).potential, 16, 1e-12);
}

// k/r^n per kg.
TEST(Conserved, TheSlopeOfAnAttractionsPotentialIsItsForce) {
  for (const double exponent : {0.0, 1.0, 2.0, 3.0}) {
    Scene scene = fakes::thrown_box();
    scene.gravity = {0, 0};
    scene.bodies.push_back({.name = "sun", .type = BodyType::fixed});
    scene.forces = {Attraction{.from = 1, .strength = 7, .exponent = exponent}};
    const Conserved conserved(scene);
    const auto potential_at = [&](double r) {
      auto states = initial_states(scene);
      states[0].position = {r, 0};
      return conserved.energy(states).potential;
    };
    const double step = 1e-5;
    const double slope = (potential_at(2 + step) - potential_at(2 - step)) / (2 * step);
    EXPECT_NEAR(slope, 2 * 7 / std::pow(2, exponent), 1e-8) << exponent;
  }
}

TEST(InitialStates, StartAtTheCentreOfMass) {
  Scene scene = fakes::thrown_box();
  scene.bodies[0].angle = std::acos(-1.0) / 2;
  scene.bodies[0].shapes[0].geometry = Box{.size = {1, 2}, .center = {1, 0}};
  const auto states = initial_states(scene);
  EXPECT_NEAR(states[0].position.x, 1, 1e-15);
  EXPECT_NEAR(states[0].position.y, 3, 1e-15);
}

constexpr double step = 1e-6;

Scene pulled_every_way() {
  const Surface surface{.density = 1};
  return {
      .gravity = {0, -10},
      .bodies = {{.name = "a", .position = {1, 2}, .velocity = {1, 0}, .shapes = {{Box{}, surface}}},
                 {.name = "b", .position = {4, 1}, .angle = 0.3, .gravity_scale = 0.5, .shapes = {{Box{}, surface}}},
                 {.name = "c", .type = BodyType::kinematic, .position = {0, -3}, .velocity = {0, 2}}},
      .forces = {Attraction{.from = 0, .strength = 3, .exponent = 2, .mutual = true},
                 Attraction{.from = 2, .strength = 5, .exponent = 1},
                 Spring{.a = 0, .b = 1, .anchor_a = {0.5, 0}, .anchor_b = {0, 0.5}, .stiffness = 7, .length = 1},
                 Spring{.b = 1, .anchor_a = {9, 9}, .anchor_b = {-0.5, 0}, .stiffness = 2, .length = 3},
                 Constant{.body = 0, .force = {1, 2}, .torque = 3}}};
}

double potential(const AppliedForces& applied, std::span<const BodyState> states) {
  return applied.conserved().energy(states).potential + applied.potential(states);
}

TEST(AppliedForces, AreTheNegativeSlopeOfThePotentialThatASoftJointHasToo) {
  Scene scene = pulled_every_way();
  scene.joints = {Distance{.a = 0, .b = 1, .anchor_a = {1, 2.3}, .anchor_b = {4, 0.7}, .length = 1, .stiffness = 5}};
  const AppliedForces applied(scene);
  const std::vector<BodyState> states = initial_states(scene);
  const std::vector<Wrench> wrenches = applied.at(states);
  for (const std::size_t body : {std::size_t{0}, std::size_t{1}}) {
    const auto minus_slope = [&](auto&& move) {
      std::vector<BodyState> ahead = states;
      std::vector<BodyState> behind = states;
      move(ahead[body], step);
      move(behind[body], -step);
      return (potential(applied, behind) - potential(applied, ahead)) / (2 * step);
    };
    EXPECT_NEAR(wrenches[body].force.x, minus_slope([](BodyState& at, double by) { at.position.x += by; }), 1e-7);
    EXPECT_NEAR(wrenches[body].force.y, minus_slope([](BodyState& at, double by) { at.position.y += by; }), 1e-7);
    EXPECT_NEAR(wrenches[body].torque, minus_slope([](BodyState& at, double by) { at.angle += by; }), 1e-7);
  }
  EXPECT_EQ(wrenches[2].force, Vec{});
}

TEST(AppliedForces, CountTheWorkOfMovingTheCentreOfAnAttraction) {
  const Scene scene = pulled_every_way();
  const AppliedForces applied(scene);
  const std::vector<BodyState> states = initial_states(scene);
  std::vector<BodyState> later = states;
  for (BodyState& state : later) state.position = state.position + step * state.velocity;
  double done = 0;  // on the bodies, by all forces
  const std::vector<Wrench> wrenches = applied.at(states);
  for (std::size_t i = 0; i < 2; ++i) done += dot(wrenches[i].force, states[i].velocity);
  const double lost = (potential(applied, states) - potential(applied, later)) / step;
  EXPECT_NEAR(done - lost, applied.power(states), 1e-4);
  EXPECT_GT(std::abs(applied.power(states)), 1);
}

// Two independent implementations of the same forces.
TEST(AppliedForces, AgreeWithTheLoadsThatAdaptersFeedTheirEngines) {
  const Scene scene = pulled_every_way();
  const std::vector<BodyState> states = initial_states(scene);
  Loads loads(scene);
  const auto fed = loads.at(states);
  const std::vector<Wrench> wrenches = AppliedForces(scene).at(states);
  for (const std::size_t body : {std::size_t{0}, std::size_t{1}}) {
    const Vec gravity = mass_of(scene.bodies[body]).mass * scene.bodies[body].gravity_scale * scene.gravity;
    EXPECT_NEAR(length(wrenches[body].force - gravity - fed[body].force), 0, 1e-12);
    EXPECT_NEAR(wrenches[body].torque, fed[body].torque, 1e-12);
  }
}

// Two boxes of 1 kg, one on the other: 2 m from top to bottom, 20 N of weight.
TEST(EnergyRange, OfAStackIsTheEnergyThatItsCollapseReleases) {
  const Body box{.position = {0, 0.5}, .shapes = {{.geometry = Box{.size = {1, 1}}}}};
  Scene scene{.bodies = {box, box}};
  scene.bodies[1].position = {0, 1.5};
  EXPECT_DOUBLE_EQ(energy_range(scene, nullptr), 40);
}

TEST(EnergyRange, CoversTheLargestKineticEnergyOfTheClosedForm) {
  Scene scene = fakes::thrown_box();
  scene.bodies[0].velocity = {0, 0};
  scene.bodies[0].angular_velocity = 0;
  const Trace truth = fakes::flight_of(scene, 0.1);
  EXPECT_NEAR(energy_range(scene, &truth), 2 * 20 * 20 / 2.0, 1e-9);
}

// A body at rest at both ends of a step in which a spring of 8 N/m pulled it out and back: F is the same at both, and
// its slope, 8 N/m times 3 m/s, changes sign. A method that looks ahead takes it from .05 s at 3 m/s farther out.
TEST(AppliedForces, KnowThatAForceMayTurnBackWithinAStep) {
  Scene scene = fakes::thrown_box();
  scene.forces = {Spring{.b = 0, .stiffness = 8}};
  const AppliedForces forces(scene);
  const std::vector<BodyState> then{{.position = {2, 0}, .velocity = {3, 0}}};
  const std::vector<BodyState> now{{.position = {2, 0}, .velocity = {-3, 0}}};
  EXPECT_NEAR(forces.change_in(then, now, 0.1)[0].force, 8 * 3 * 0.05 + 2 * 8 * 3 * 0.1 / 8, 1e-12);
  scene.forces = {};
  EXPECT_EQ(AppliedForces(scene).change_in(then, now, 0.1)[0].force, 0);
}

// A body that makes one turn in a step, on a spring of 8 N/m whose anchor is .25 m from its centre: F is the same at
// both ends, and half a turn on, off by twice 8 N/m times .25 m.
TEST(AppliedForces, KnowThatASpringTurnsWithItsAnchorWithinAStep) {
  Scene scene = fakes::thrown_box();
  scene.forces = {Spring{.b = 0, .anchor_b = {.25, 0}, .stiffness = 8}};
  const std::vector<BodyState> states{{.position = {2, 0}, .angular_velocity = 20 * std::acos(-1)}};
  const double most = AppliedForces(scene).change_in(states, states, 0.1)[0].force;
  EXPECT_GT(most, 0.9 * 4);
  EXPECT_LE(most, 4);
}

TEST(IsDriven, WhatKeepsUpAVelocity) {
  Body body = fakes::thrown_box().bodies[0];
  body.angular_velocity = 1;
  EXPECT_FALSE(is_driven(body));
  body.fixed_rotation = true;
  EXPECT_TRUE(is_driven(body));
  body.angular_velocity = 0;
  EXPECT_FALSE(is_driven(body));
  body.type = BodyType::kinematic;
  EXPECT_TRUE(is_driven(body));
  body.type = BodyType::fixed;
  EXPECT_FALSE(is_driven(body));
}

}  // namespace
}  // namespace plumb::mechanics_test
