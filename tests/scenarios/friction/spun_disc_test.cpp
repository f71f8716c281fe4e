#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/scenarios/statement_of.h"

namespace plumb::spun_disc_test {
namespace {

using statement_of::Of;

// I w0 = I w + m v r: a hoop keeps half of its spin, a disc a third.
TEST(SpinUp, StopsAHoopAndADiscThatNeverRolls) {
  EXPECT_LT((Of{"spin-up", {}, "disc", Quantity::angular_velocity}.allows_at_most()), 24 * (1. / 2 - 1. / 3) / 5);
  EXPECT_LT((Of{"spin-up", {}, "disc", Quantity::vx}.allows_at_most()), 24 * 0.5 / 3 / 10);
}

struct Spin {
  double angle = 0, velocity = 0;
};

// The same disc on springs for floor and wall, with sliding friction on each, by small steps: nothing knows the balance
// of the pushes. Stiff enough that they give way by 1e-5 m.
Spin on_springs(double spin, double mu, double time) {
  constexpr double g = 10, r = 0.5, stiffness = 1e6, damping = 2e3, dt = 1e-5;
  double x = 0, y = -g / stiffness, vx = 0, vy = 0, w = spin;  // per mass
  Spin out;
  for (int i = 0, steps = static_cast<int>(std::lround(time / dt)); i < steps; ++i) {
    const double floor = std::max(-stiffness * y - damping * vy, 0.0);
    const double wall = std::max(-stiffness * x - damping * vx, 0.0);
    const double at_floor = -mu * floor * std::clamp((vx + w * r) * 1e4, -1.0, 1.0);
    const double at_wall = -mu * wall * std::clamp((vy - w * r) * 1e4, -1.0, 1.0);
    vx += (wall + at_floor) * dt;
    vy += (floor + at_wall - g) * dt;
    w += (at_floor - at_wall) * r / (r * r / 2) * dt;
    x += vx * dt;
    y += vy * dt;
    out.angle += w * dt;
  }
  out.velocity = w;
  return out;
}

TEST(CornerSpin, AgreesWithADiscOnStiffSprings) {
  for (const double mu : {0.3, 0.6}) {
    const Of spin{"corner-spin", {{"friction", mu}}, "disc", Quantity::angular_velocity};
    const Of angle{"corner-spin", {{"friction", mu}}, "disc", Quantity::angle};
    const Expectation halfway = spin.expectations().front();
    const Spin there = on_springs(30, mu, *halfway.time);
    EXPECT_NEAR(*halfway.expected, there.velocity, 0.02) << mu;
    EXPECT_NEAR(*angle.expectations().front().expected, there.angle, 0.02) << mu;
    EXPECT_NEAR(*angle.expectations().back().expected, on_springs(30, mu, *halfway.time * 2 + 0.2).angle, 0.03) << mu;
  }
}

// Braked by the floor alone, with 2 mu g/r, it would have turned further by mu (1 - mu)/(1 + mu) of it.
TEST(CornerSpin, StopsAWallWithoutFriction) {
  const double braked = 2 * 0.3 * 10 / 0.5;
  const double both = braked * 1.3 / 1.09;
  const double halfway = 30 / both / 2;
  EXPECT_LT((Of{"corner-spin", {}, "disc", Quantity::angular_velocity, halfway + 0.1}.allows_at_most()),
            (both - braked) * halfway / 2);
}

// The disc is let down by r (1 - cos w dt), on average as at sqrt(13/27) w0 while w falls from w0 to w0/3.
TEST(SpinUp, LetsADiscSinkInThatSpinsOnHeldPoints) {
  const Of speed{"spin-up", {}, "disc", Quantity::vx};
  Stepping stated = statement_of::soft();
  const double with = speed.allows(stated);
  stated.held_anchors = false;
  const double sinks = 0.5 * (1 - std::cos(std::sqrt(13. / 27) * 24 / 60));
  EXPECT_NEAR(with - speed.allows(stated), 24 * sinks / 9, 1e-12);
  EXPECT_LT(with, 4 * 0.02);
}

}  // namespace
}  // namespace plumb::spun_disc_test
