#include "reports/judge/conserved.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../fakes.h"
#include "reports/vec.h"

namespace plumb {
namespace {

TEST(Conserved, WeighsABoxByHand) {
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

TEST(Conserved, EnergyStaysInFreeFlight) {
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

TEST(Conserved, SkipsWhatCannotMove) {
  Scene scene = fakes::thrown_box();
  scene.bodies.push_back(scene.bodies[0]);
  scene.bodies[1].type = BodyType::kinematic;
  EXPECT_DOUBLE_EQ(Conserved(scene).energy(initial_states(scene)).total(),
                   Conserved(fakes::thrown_box()).energy(initial_states(fakes::thrown_box())).total());
}

// The anchor sits 1 m right of a box turned by 90 degrees, so 1 m above its centre: (0, 1), 3 m from (0, 4).
TEST(Conserved, ASpringHoldsHalfKTimesItsStretchSquared) {
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

// The force is the slope of the potential: k/r^n per kg.
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

}  // namespace
}  // namespace plumb
