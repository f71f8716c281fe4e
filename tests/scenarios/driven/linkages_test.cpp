#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>

#include "scenarios/driven/four_bar.h"
#include "scenarios/integrate.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::linkages_test {
namespace {

using four_bar::pose;
using four_bar::Pose;
using statement_of::Of;

TEST(FourBar, ClosesItsLoopAllRound) {
  for (double angle = 0; angle < 7; angle += 0.1) {
    const Pose at = pose(angle);
    const auto loop = std::polar(four_bar::crank, at.crank_angle) + std::polar(four_bar::coupler, at.coupler_angle) -
                      four_bar::base - std::polar(four_bar::rocker, at.rocker_angle);
    EXPECT_NEAR(std::abs(loop), 0, 1e-14) << angle;
    EXPECT_GT(std::sin(at.rocker_angle - at.coupler_angle), 0.1) << "it never comes to a line";
  }
}

TEST(FourBar, HasTheRatesOfItsLoop) {
  constexpr double h = 1e-6;
  for (double angle = 0; angle < 7; angle += 0.5) {
    const Pose before = pose(angle - h);
    const Pose after = pose(angle + h);
    EXPECT_NEAR(pose(angle).coupler_rate, (after.coupler_angle - before.coupler_angle) / (2 * h), 1e-8);
    EXPECT_NEAR(pose(angle).rocker_rate, (after.rocker_angle - before.rocker_angle) / (2 * h), 1e-8);
  }
}

// kg m^2, from the scene's bars, the velocities of their middles by differences.
double inertia(double angle) {
  constexpr double h = 1e-5;
  const auto middles = [](double at) {
    const Pose now = pose(at);
    const auto pin = std::polar(four_bar::crank, at);
    return std::array{pin / 2.0, pin + std::polar(four_bar::coupler / 2, now.coupler_angle),
                      four_bar::base + std::polar(four_bar::rocker / 2, now.rocker_angle)};
  };
  const Pose now = pose(angle);
  const double lengths[] = {four_bar::crank, four_bar::coupler, four_bar::rocker};
  const double rates[] = {1, now.coupler_rate, now.rocker_rate};
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double mass = 0.1 * lengths[i];
    const double speed = std::abs(middles(angle + h)[i] - middles(angle - h)[i]) / (2 * h);
    sum += mass * (speed * speed + (lengths[i] * lengths[i] + 0.01) / 12 * rates[i] * rates[i]);
  }
  return sum;
}

// Lagrange's equation I t'' + I' t'^2/2 = 0, which does not know of the energy.
TEST(FreeFourBar, AgreesWithItsEquationOfMotion) {
  for (const double turn : {2.0, 4.0}) {
    const auto rate = [](const std::array<double, 2>& y) {
      constexpr double h = 1e-4;
      const double slope = (inertia(y[0] + h) - inertia(y[0] - h)) / (2 * h);
      return std::array<double, 2>{y[1], -slope / (2 * inertia(y[0])) * y[1] * y[1]};
    };
    for (const Expectation& one : (Of{"free-four-bar", {{"turn", turn}}, "crank", Quantity::angle}.expectations())) {
      EXPECT_NEAR(*one.expected, (integrated<2>({0.9, turn}, *one.time, 2000, rate)[0]), 1e-5);
    }
  }
}

// The crank of three bars that keep its speed of 2 rad/s, as if they had no mass, is elsewhere.
TEST(FreeFourBar, StopsACrankThatTurnsEvenly) {
  const auto asked = Of{"free-four-bar", {}, "crank", Quantity::angle}.expectations();
  const double even = 0.9 + 2 * *asked.front().time;
  EXPECT_GT(std::abs(*asked.front().expected - even), 10 * asked.front().allowed(statement_of::accurate()));
}

Scene scene_of(double swing) {
  const Scenario& family = *Catalog<Scenario>::find("peaucellier");
  return family.scene(complete(family, {{"swing", swing}}));
}

// Every bar has its length at the start, and its ends move across it only.
TEST(Peaucellier, StartsWithRigidBars) {
  for (const double swing : {20.0, 60.0, 70.0}) {
    const Scene scene = scene_of(swing);
    const auto velocity_at = [&](std::size_t body, Vec at) {
      const Body& of = scene.bodies[body];
      const double w = of.angular_velocity;
      return Vec{of.velocity.x - w * (at.y - of.position.y), of.velocity.y + w * (at.x - of.position.x)};
    };
    ASSERT_EQ(scene.joints.size(), 6u);
    for (const Joint& joint : scene.joints) {
      const auto& bar = std::get<Distance>(joint);
      const Vec along{bar.anchor_b.x - bar.anchor_a.x, bar.anchor_b.y - bar.anchor_a.y};
      const Vec a = velocity_at(bar.a, bar.anchor_a);
      const Vec b = velocity_at(bar.b, bar.anchor_b);
      EXPECT_NEAR(std::hypot(along.x, along.y), bar.length, 1e-12);
      EXPECT_NEAR((b.x - a.x) * along.x + (b.y - a.y) * along.y, 0, 1e-12);
    }
  }
}

// The inversion: the end is on the ray through the crank's pin, at (long^2 - bar^2) over the pin's distance.
TEST(Peaucellier, InvertsTheCircleOfTheCrank) {
  const auto x = Of{"peaucellier", {}, "end", Quantity::x}.expectations();
  const auto y = Of{"peaucellier", {}, "end", Quantity::y}.expectations();
  const double widest = 60 * std::acos(-1) / 180;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double angle = widest * (2 * x[i].time.value_or(3) / 3 - 1);
    const Vec pin{0.6 + 0.6 * std::cos(angle), 0.6 * std::sin(angle)};
    const double far = (1.5 * 1.5 - 0.6 * 0.6) / (pin.x * pin.x + pin.y * pin.y);
    EXPECT_NEAR(*x[i].expected, far * pin.x, 1e-12);
    EXPECT_NEAR(*y[i].expected, far * pin.y, 1e-12);
    EXPECT_EQ(*x[i].expected, *x[0].expected) << "a straight line";
  }
}

// With the crank's pivot a tenth off, the line is an arc that is 4 cm off it at its ends.
TEST(Peaucellier, StopsALinkageThatDrawsAnArc) {
  EXPECT_LT((Of{"peaucellier", {}, "end", Quantity::x}.allows(statement_of::accurate())), 0.01);
}

}  // namespace
}  // namespace plumb::linkages_test
