#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "forged_runs.h"

namespace plumb::energy_bound_test {
namespace {

constexpr double dt = 0.01;
const Stepping exact{.dt = dt, .h = dt, .drift = 0, .impact_lag = 0, .epsilon = 1e-16};
const Stepping symplectic{.dt = dt, .h = dt, .drift = 0.5, .impact_lag = 1, .epsilon = 1e-16};

// A box that starts 1 m up and bounces at e = 1, and gains this share of its energy with every step.
Trace bouncing(double gain) {
  Trace trace(2);
  double y = 1;
  double v = 0;
  for (int i = 0; i <= 300; ++i) {
    trace.record(i * dt, box_at({0, 0.5 + y}, {0, v}), {});
    const double before = v * v / 2 + 10 * y;
    y += v * dt - 5 * dt * dt;
    v -= 10 * dt;
    if (y < 0) v = std::abs(v), y = -y;
    const double kinetic = before * (1 + gain) - 10 * y;
    v = (v < 0 ? -1 : 1) * std::sqrt(std::max(0.0, 2 * kinetic));
  }
  return trace;
}

Scene raised() {
  Scene scene = box_on_ground(0.5, {0, -10});
  scene.bodies[1].position = {0, 1.5};
  return scene;
}

TEST(EnergyBoundInvariant, HoldsWhatNothingDrivesToTheEnergyOfItsStart) {
  EXPECT_EQ(status("energy_bound", raised(), bouncing(0), exact), CheckStatus::held);
  EXPECT_EQ(status("energy_bound", raised(), bouncing(-1e-3), exact), CheckStatus::held);
  EXPECT_EQ(status("energy_bound", raised(), bouncing(1e-8), exact), CheckStatus::broken);
}

// Late impacts and the method's oscillation together: 1.5 h g (m g t + 2 p) + h F v, p = m sqrt(2 g 1 m).
TEST(EnergyBoundInvariant, AllowsWhatTheMethodStates) {
  EXPECT_EQ(status("energy_bound", raised(), bouncing(2e-4), symplectic), CheckStatus::held);
  EXPECT_EQ(status("energy_bound", raised(), bouncing(5e-3), symplectic), CheckStatus::broken);
}

// A gap of rounding, 1e-16 of .5 m, gives a body that rests without gravity 5e-15 m/s.
TEST(EnergyBoundInvariant, KnowsHowSmallAVelocityCanBe) {
  const Scene scene = box_on_ground(0.5, {0, 0});
  const auto pushed = [](double speed) { return forged(dt, {{box_at({0, 0.5})}, {box_at({0, 0.5}, {0, speed})}}); };
  EXPECT_EQ(status("energy_bound", scene, pushed(4e-15), exact), CheckStatus::held);
  EXPECT_EQ(status("energy_bound", scene, pushed(1e-14), exact), CheckStatus::broken);
}

// A box of 1 kg at 2 m/s and one of a millionth of that meet a wall and each other up to 1000 pi times, and each impact
// may round the energy twice by 1e-16 of it: 2 * 3142e-16 of 2 J.
TEST(EnergyBoundInvariant, CountsTheRoundingOfImpactsAtTheirOwnTime) {
  Scene scene = box_on_ground(0.5, {0, 0});
  scene.bodies[1].velocity = {2, 0};
  Body light = scene.bodies[1];
  light.name = "light";
  light.position = {3, 0.5};
  light.velocity = {};
  light.shapes[0].surface.density = 1e-6;
  scene.bodies.push_back(light);
  const auto gained = [](double share) {
    const auto states = [](double speed) {
      std::vector<BodyState> all = box_at({0, 0.5}, {speed, 0});
      all.push_back({.position = {3, 0.5}});
      return all;
    };
    return forged(dt, {{states(2)}, {states(2 * (1 + share / 2))}});
  };
  EXPECT_EQ(status("energy_bound", scene, gained(5e-13), exact), CheckStatus::held);
  EXPECT_EQ(status("energy_bound", scene, gained(8e-13), exact), CheckStatus::broken);
  Stepping in_steps = exact;
  in_steps.impact_lag = 1;
  EXPECT_EQ(status("energy_bound", scene, gained(5e-13), in_steps), CheckStatus::broken);
}

TEST(EnergyBoundInvariant, LeavesJointsAndSpringsToTheOtherLaw) {
  Scene scene = raised();
  scene.forces = {Spring{.b = 1, .stiffness = 1}};
  EXPECT_FALSE(checked("energy_bound", scene, bouncing(0), exact).has_value());
}

}  // namespace
}  // namespace plumb::energy_bound_test
