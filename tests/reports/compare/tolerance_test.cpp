#include "reports/compare/tolerance.h"

#include <gtest/gtest.h>

#include "../fakes.h"

namespace plumb::tolerance_test {
namespace {

constexpr double dt = 1.0 / 64;
const std::vector<BodyState> state{{.position = {3, 4}, .velocity = {0, 2}}};

Stepping with(double epsilon) { return {.dt = dt, .h = dt, .epsilon = epsilon}; }

StateTolerance after(double time, double epsilon_a, double epsilon_b) {
  static const Scene scene = fakes::thrown_box();
  return RoundOffTolerance(scene, with(epsilon_a), with(epsilon_b)).at(time, state, state);
}

TEST(RoundOffTolerance, AddsTheRoundingOfBothRuns) {
  const double fine = 0x1p-53;
  const double coarse = 0x1p-24;
  EXPECT_DOUBLE_EQ(after(1, fine, coarse).position, after(1, fine, 0).position + after(1, 0, coarse).position);
  EXPECT_EQ(after(1, 0, 0).velocity, 0);
}

TEST(RoundOffTolerance, CountsEveryStep) {
  // 4 epsilon (n + 1) (|x| + |v| t), with the g dt that a step adds to v.
  const double speed = 2 + 10 * dt;
  EXPECT_DOUBLE_EQ(after(1, 0x1p-24, 0).position, 4 * 0x1p-24 * 65 * (5 + speed));
  EXPECT_DOUBLE_EQ(after(1, 0x1p-24, 0).velocity, 4 * 0x1p-24 * (65 * speed + 5 / dt));
}

TEST(RoundOffTolerance, RemembersTheLargestNumbers) {
  const Scene scene = fakes::thrown_box();
  const std::vector<BodyState> still(1);
  RoundOffTolerance round_off(scene, with(0x1p-24), with(0x1p-24));
  const double before = round_off.at(0, state, still).velocity;
  EXPECT_DOUBLE_EQ(round_off.at(0, still, still).velocity, before);
}

TEST(UniformTolerance, ScalesImpulsesByTheLightestBody) {
  Scene scene = fakes::thrown_box();  // 2 kg
  scene.bodies.push_back({.shapes = {{.geometry = Box{.size = {1, 0.5}}}}});
  scene.bodies.push_back({.type = BodyType::fixed});
  EXPECT_EQ(uniform_tolerance(0.1, scene).impulse, 0.05);
  EXPECT_EQ(uniform_tolerance(0.1, scene).angle, 0.1);
}

}  // namespace
}  // namespace plumb::tolerance_test
