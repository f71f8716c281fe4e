#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "scenarios/integrate.h"
#include "scenarios/scene/mass.h"
#include "tests/scenarios/statement_of.h"

namespace plumb::pendulums_test {
namespace {

using statement_of::Of;

// w^2 = 3 g/(2 L) = 7.5: a rod of 2 m let go level turns by .9 rad in half a second.
TEST(Pendulum, StopsARodThatDoesNotSwing) {
  EXPECT_LT((Of{"pendulum", {}, "rod", Quantity::angle, 1.0}.allows_at_most()), 0.9 / 5);
}

// By half of gravity it has turned by half as much.
TEST(Pendulum, StopsHalfGravity) {
  EXPECT_LT((Of{"pendulum", {}, "rod", Quantity::angle, 1.0}.allows_at_most()), 0.45 / 3);
}

TEST(RodToppling, StopsARodThatStandsStill) {
  const double early = 0.2618 * (std::cosh(1.936 / 6) - 1);
  EXPECT_LT((Of{"rod-toppling", {}, "rod", Quantity::angle, 0.5}.allows_at_most()), early / 2);
  EXPECT_LT((Of{"rod-toppling", {}, "rod", Quantity::angle}.allows_at_most()), 0.643 / 5);
}

// m/2 g L is what the swing exchanges.
TEST(Pendulum, StopsASecondOrderHingeThatLosesAThousandthOfItsEnergy) {
  EXPECT_LT((Of{"pendulum", {}, "", Quantity::energy}.allows(statement_of::accurate())), 2 * 0.002);
}

// Symplectic Euler, both ways round: x is half a step off, v is exact but for the phase of second order.
TEST(Spring, AllowsWhatSymplecticEulerDoes) {
  constexpr double w = 4;
  constexpr double h = 1.0 / 60;
  double v = 0;
  double x = 1;
  for (int i = 0; i < 300; ++i) {
    v -= w * w * x * h;
    x += v * h;
  }
  const Stepping stated = statement_of::skinned();
  const double error = std::abs(x - std::cos(5 * w));
  const double of_speed = std::abs(v + w * std::sin(5 * w));
  const double of_energy = std::abs(v * v + w * w * (x * x - 1)) / (w * w);
  const Of place{"spring", {}, "disc", Quantity::x};
  const Of speed{"spring", {}, "disc", Quantity::vx};
  const Of energy{"spring", {}, "", Quantity::energy};
  EXPECT_LT(error, place.allows(stated));
  EXPECT_LT(of_speed, speed.allows(stated));
  EXPECT_LT(of_energy * 1.5707963, energy.allows(stated));
}

TEST(Spring, StopsATenthOfTheEnergyAndAFrozenDisc) {
  EXPECT_LT((Of{"spring", {}, "", Quantity::energy}.allows_at_most()), 0.1 * 1.57);
  EXPECT_LT((Of{"spring", {}, "disc", Quantity::vx}.allows_at_most()), 3.65 / 20);
}

TEST(Bifilar, SwingsLikeAPointOnOneOfItsRods) {
  for (const double degrees : {5.0, 30.0, 60.0}) {
    const Parameters changes{{"angle", degrees}};
    const Scenario& family = *Catalog<Scenario>::find("bifilar");
    const Scene scene = family.scene(complete(family, changes));
    const double rod = std::get<Distance>(scene.joints[0]).length;
    EXPECT_EQ(rod, std::get<Distance>(scene.joints[1]).length);
    const double start = degrees * std::acos(-1) / 180;
    const auto rate = [&](const std::array<double, 2>& s) {
      return std::array<double, 2>{s[1], -10 / rod * std::sin(s[0])};
    };
    for (const Expectation& one : Of{"bifilar", changes, "bar", Quantity::y}.expectations()) {
      const double angle = integrated(std::array<double, 2>{start, 0}, *one.time, 10000, rate)[0];
      EXPECT_NEAR(*one.expected, -rod * std::cos(angle), 1e-9) << degrees;
    }
  }
}

// The bar itself, hinged at its own distance from one hook, would turn by as much as it swings.
TEST(Bifilar, StopsABarThatHangsFromOneHook) {
  EXPECT_LT((Of{"bifilar", {}, "bar", Quantity::angle}.allows_at_most()), 0.5 / 10);
}

// I angle'' = -m g d sin(angle), with the scene's own distances and masses.
TEST(Kater, HasRodsThatSwingWithAPeriodOfTwoSecondsFromBothHinges) {
  const Scenario& family = *Catalog<Scenario>::find("kater");
  for (const double degrees : {5.0, 30.0, 60.0}) {
    const Scene scene = family.scene(complete(family, {{"angle", degrees}}));
    const double start = degrees * std::acos(-1) / 180;
    for (const std::size_t i : {1u, 2u}) {
      const Body& rod = scene.bodies[i];
      const Vec hinge{i == 1 ? 0.0 : 4.0, 0};
      const double d = std::hypot(rod.position.x - hinge.x, rod.position.y - hinge.y);
      const Mass mass = mass_of(rod);
      const double w2 = mass.mass * 10 * d / (mass.inertia + mass.mass * d * d);
      const auto rate = [&](const std::array<double, 2>& y) {
        return std::array<double, 2>{y[1], -w2 * std::sin(y[0])};
      };
      EXPECT_NEAR(integrated(std::array<double, 2>{start, 0}, 0.5, 5000, rate)[0], 0, 1e-9) << rod.name;
      EXPECT_NEAR(integrated(std::array<double, 2>{start, 0}, 1, 5000, rate)[0], -start, 1e-9) << rod.name;
      EXPECT_NEAR(*(Of{"kater", {{"angle", degrees}}, rod.name, Quantity::angle}.expectations()[1].expected), -start,
                  1e-12);
    }
    EXPECT_GT(std::abs(scene.bodies[1].position.y - scene.bodies[2].position.y), 0.1) << "not conjugate but equal";
  }
}

// Taken for points, the rods have the periods of d: the near one a third of a second less.
TEST(Kater, StopsRodsWithoutInertia) {
  const Of angle{"kater", {}, "near", Quantity::angle, 0.6};
  EXPECT_LT(angle.allows_at_most(), 0.5 * std::acos(-1) / 6);
}

}  // namespace
}  // namespace plumb::pendulums_test
