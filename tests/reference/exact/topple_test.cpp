#include "reference/exact/topple.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/simulation.h"
#include "scenarios/integrate.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/vec.h"

namespace plumb::topple_test {
namespace {

// A box of 1 m x 2 m on a slope of 35 degrees: arctan(1/2) is 26.6.
Topple::Setup box(double slope = 35 * std::numbers::pi / 180, double friction = 10) {
  return {.arm = std::sqrt(1.25),
          .lean = slope - std::atan(0.5),
          .gyration = 5.0 / 12,
          .gravity = 10,
          .slope = slope,
          .friction = friction,
          .landing = std::numbers::pi / 2};
}

// The motion of the centre under gravity and the force that holds the edge. Both follow from the condition that the
// edge does not accelerate, without the formulas of a pendulum.
struct Edge {
  std::array<double, 6> rate;
  Vec push;
};
Edge held(const Topple::Setup& c, const std::array<double, 6>& y) {
  const Vec arm{c.arm * std::sin(y[2]), c.arm * std::cos(y[2])};  // from the edge to the centre; y[2] clockwise
  const double w = y[5];
  // Acceleration of the edge: a + w' (-arm.y, arm.x) + w^2 arm, with a = g + F and w' = cross(F, arm)/k^2 clockwise.
  const auto edge = [&](Vec force) {
    const double turn = -cross(-arm, force) / c.gyration;
    return Vec{force.x - turn * arm.y + w * w * arm.x, force.y - c.gravity + turn * arm.x + w * w * arm.y};
  };
  const Vec none = edge({});
  const Vec x = edge({1, 0}) - none;
  const Vec up = edge({0, 1}) - none;
  const double d = cross(x, up);
  const Vec force{-cross(none, up) / d, -cross(x, none) / d};
  const double turn = -cross(-arm, force) / c.gyration;
  return {{y[3], y[4], w, force.x, force.y - c.gravity, turn}, force};
}

TEST(Topple, AgreesWithABodyWhoseEdgeIsHeldByForces) {
  const Topple::Setup c = box();
  std::array<double, 6> y{c.arm * std::sin(c.lean), c.arm * std::cos(c.lean), c.lean, 0, 0, 0};
  constexpr int steps = 20000;
  constexpr double end = 0.8;
  ASSERT_GT(Topple(c).valid_until(), end);
  for (int i = 0; i < steps; ++i) {
    y = runge_kutta(y, end / steps, [&c](const std::array<double, 6>& now) { return held(c, now).rate; });
  }
  const Topple::State state = Topple(c).at(end);
  EXPECT_GT(state.turn, 0.3);
  EXPECT_NEAR(state.turn, y[2] - c.lean, 1e-9 * state.turn);
  EXPECT_NEAR(state.spin, y[5], 1e-9 * state.spin);
  EXPECT_NEAR(c.arm * std::sin(c.lean + state.turn), y[0], 1e-9);
  const Vec push = rotated(held(c, y).push, c.slope);
  EXPECT_NEAR(Topple(c).push(end).x, push.x, 1e-8);
  EXPECT_NEAR(Topple(c).push(end).y, push.y, 1e-8);
}

TEST(Topple, StandsUpToTheSlopeWhoseTangentIsBOverH) {
  const double limit = std::atan(0.5);
  EXPECT_EQ(Topple(box(limit - 1e-9)).at(3).turn, 0);
  EXPECT_GT(Topple(box(limit + 1e-9)).at(3).turn, 0);
  // While it stands the floor supports g cos a, and friction g sin a.
  const Vec push = Topple(box(0.3)).push(1);
  EXPECT_NEAR(push.y, 10 * std::cos(0.3), 1e-14);
  EXPECT_NEAR(push.x, -10 * std::sin(0.3), 1e-14);
}

TEST(Topple, IsValidUntilItsEdgeSlips) {
  const double until = Topple(box(35 * std::numbers::pi / 180, 0.8)).valid_until();
  EXPECT_GT(until, 0.1);
  const Topple::Setup c = box(35 * std::numbers::pi / 180, 0.8);
  const Vec push = Topple(c).push(until);
  EXPECT_NEAR(std::abs(push.x) / push.y, 0.8, 1e-9);
  EXPECT_EQ(Topple(box(35 * std::numbers::pi / 180, 0.3)).valid_until(), 0);
  EXPECT_EQ(Topple(box(0.3, 0.2)).valid_until(), 0);  // slides before it tips
  EXPECT_EQ(Topple(box(0.3, 0.5)).valid_until(), std::numeric_limits<double>::infinity());
}

// Four times the lengths, half the angular velocity.
TEST(Topple, ScalesWithItsUnits) {
  Topple::Setup large = box();
  large.arm *= 4;
  large.gyration *= 16;
  EXPECT_NEAR(Topple(large).at(1).turn, Topple(box()).at(0.5).turn, 1e-14);
  EXPECT_NEAR(Topple(large).at(1).spin, Topple(box()).at(0.5).spin / 2, 1e-14);
}

}  // namespace
}  // namespace plumb::topple_test
