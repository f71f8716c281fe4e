#include "reference/exact/topple.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "reference/exact/oscillation.h"
#include "reference/simulation.h"
#include "scenarios/integrate.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/vec.h"

namespace plumb::ladder_test {
namespace {

constexpr double half = 1.5;  // m

Ladder::Setup rod(double degrees, double friction) {
  return {.half = half,
          .gyration = half * half / 3,
          .angle = degrees * std::numbers::pi / 180,
          .gravity = 10,
          .friction = friction};
}

// Newton's and Euler's equations for a free rod with forces at both ends. These follow from the conditions that the
// foot stays on the floor and the head at the wall; the equation of the angle is not used. y = x, y, a and their rates.
std::array<double, 6> pushed(const Ladder::Setup& c, const std::array<double, 6>& y, Vec& push) {
  const double s = std::sin(y[2]);
  const double k = std::cos(y[2]);
  // Foot (x + l cos a, y - l sin a), head (x - l cos a, y + l sin a). With R and N per mass:
  const auto rates = [&](double wall, double floor) {
    const double turn = -(floor * c.half * (k - c.friction * s) - wall * c.half * s) / c.gyration;
    return std::array<double, 6>{y[3], y[4], y[5], wall - c.friction * floor, floor - c.gravity, turn};
  };
  const auto ends = [&](const std::array<double, 6>& rate) {
    const double foot_up = rate[4] - c.half * (k * rate[5] - s * y[5] * y[5]);
    const double head_out = rate[3] + c.half * (s * rate[5] + k * y[5] * y[5]);
    return Vec{head_out, foot_up};
  };
  const Vec none = ends(rates(0, 0));
  const Vec wall = ends(rates(1, 0)) - none;
  const Vec floor = ends(rates(0, 1)) - none;
  const double d = cross(wall, floor);
  push = {-cross(none, floor) / d, -cross(wall, none) / d};
  return rates(push.x, push.y);
}

TEST(Ladder, AgreesWithARodPushedAtBothEnds) {
  for (const double friction : {0.0, 0.1, 0.3}) {
    const Ladder::Setup c = rod(50, friction);
    const Ladder ladder(c);
    const double end = 0.8 * std::min(ladder.valid_until(), 1.0);
    std::array<double, 6> y{half * std::cos(c.angle), half * std::sin(c.angle), c.angle, 0, 0, 0};
    Vec push;
    constexpr int steps = 20000;
    for (int i = 0; i < steps; ++i) {
      y = runge_kutta(y, end / steps, [&](const std::array<double, 6>& now) { return pushed(c, now, push); });
    }
    const Ladder::State state = ladder.at(end);
    EXPECT_LT(state.angle, c.angle - 0.05) << friction;
    EXPECT_NEAR(state.angle, y[2], 1e-9) << friction;
    EXPECT_NEAR(state.speed, y[5], 1e-9) << friction;
    EXPECT_NEAR(half * std::cos(state.angle), y[0], 1e-9);
    pushed(c, y, push);
    EXPECT_NEAR(ladder.push(state).x, push.x, 1e-7);
    EXPECT_NEAR(ladder.push(state).y, push.y, 1e-7);
  }
}

// Without friction it is a pendulum with angle a + pi/2.
TEST(Ladder, WithoutFrictionIsAnInvertedPendulum) {
  const Ladder::Setup c = rod(60, 0);
  const double w = std::sqrt(c.gravity * half / (c.gyration + half * half));
  const Pendulum pendulum(c.angle + std::numbers::pi / 2, w);
  for (const double t : {0.1, 0.3, 0.5}) {
    EXPECT_NEAR(Ladder(c).at(t).angle, pendulum.at(t).angle - std::numbers::pi / 2, 1e-12);
    EXPECT_NEAR(Ladder(c).at(t).speed, pendulum.at(t).speed, 1e-12);
  }
}

TEST(Ladder, WithoutFrictionLeavesTheWallAtTwoThirdsOfItsHeight) {
  for (const double degrees : {30.0, 60.0, 80.0}) {
    const Ladder ladder(rod(degrees, 0));
    const double high = std::sin(degrees * std::numbers::pi / 180);
    EXPECT_NEAR(std::sin(ladder.at(ladder.valid_until()).angle), 2 * high / 3, 1e-11);
  }
}

TEST(Ladder, StandsIffItsTangentIsAtLeastOneOverTwoMu) {
  for (const double friction : {0.2, 0.5, 0.9}) {
    const double limit = std::atan(1 / (2 * friction)) * 180 / std::numbers::pi;
    EXPECT_TRUE(Ladder(rod(limit + 1e-9, friction)).stands());
    EXPECT_FALSE(Ladder(rod(limit - 1e-9, friction)).stands());
  }
  const Ladder standing(rod(50, 0.5));
  EXPECT_NEAR(standing.push({}).y, 10, 1e-15);
  EXPECT_NEAR(standing.push(standing.at(1)).x, 10 / (2 * std::tan(50 * std::numbers::pi / 180)), 1e-14);
}

TEST(Ladder, LosesTheFrictionWorkOfItsFoot) {
  const Ladder::Setup c = rod(45, 0.3);
  const Ladder ladder(c);
  const double end = 0.5;
  double work = 0;
  constexpr int steps = 1000;
  for (int i = 0; i < steps; ++i) {
    const Ladder::State a = ladder.at(end * (i + 0.5) / steps);
    work += c.friction * ladder.push(a).y * -2 * half * std::sin(a.angle) * a.speed * end / steps;
  }
  const Ladder::State now = ladder.at(end);
  const double kinetic = (half * half + c.gyration) * now.speed * now.speed / 2;
  EXPECT_NEAR(kinetic + work, c.gravity * half * (std::sin(c.angle) - std::sin(now.angle)), 1e-6);
}

TEST(Ladder, ScalesWithItsUnits) {
  Ladder::Setup large = rod(50, 0.2);
  large.half *= 4;
  large.gyration *= 16;
  EXPECT_NEAR(Ladder(large).at(0.8).angle, Ladder(rod(50, 0.2)).at(0.4).angle, 1e-13);
  EXPECT_NEAR(Ladder(large).valid_until(), 2 * Ladder(rod(50, 0.2)).valid_until(), 1e-9);
}

TEST(LadderScene, IsTheSameLeaningTheOtherWay) {
  const Scenario& family = *Catalog<Scenario>::find("sliding-ladder");
  Scene scene = family.scene(complete(family, {}));
  const auto state = [](const Scene& of) {
    const auto simulation = Catalog<Engine>::find("ladder")->build(of, {});
    simulation->step(0.3);
    std::vector<BodyState> states(3);
    simulation->read(states);
    return states[2];
  };
  const BodyState left = state(scene);
  scene.bodies[1].shapes[0].geometry = HalfSpace{.normal = {-1, 0}};
  scene.bodies[2].position.x *= -1;
  scene.bodies[2].angle *= -1;
  const BodyState right = state(scene);
  EXPECT_NEAR(right.position.x, -left.position.x, 1e-14);
  EXPECT_NEAR(right.velocity.x, -left.velocity.x, 1e-14);
  EXPECT_NEAR(right.angle, -left.angle, 1e-14);
  EXPECT_NEAR(right.angular_velocity, -left.angular_velocity, 1e-14);
  EXPECT_NEAR(right.velocity.y, left.velocity.y, 1e-14);
}

}  // namespace
}  // namespace plumb::ladder_test
