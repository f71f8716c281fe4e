#include "solver/constraint_system.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "../support.h"

namespace impulse::inline IMPULSE_PRECISION::constraint_system_test {
namespace {

constexpr double tolerance = sizeof(Real) == 8 ? 1e-12 : 1e-6;  // of what velocities are rounded by

/// A point that body b rests on, `arm` beside its centre; body 0 does not move.
Constraint point(std::uint32_t b, Real arm) {
  Constraint row;
  row.b = b;
  row.mass_b = {1, 1};
  row.axis = {0, 1};
  row.arm_b = arm;
  row.law = Law::pushes;
  return row;
}

Constraint friction(std::uint32_t first, std::uint32_t count, Real coefficient) {
  Constraint row = point(1, 0);
  row.axis = {1, 0};
  row.law = Law::rubs;
  row.first = first;
  row.count = count;
  row.friction = coefficient;
  return row;
}

TEST(ConstraintSystem, SharesALoadByTheLawOfTheLever) {
  ConstraintSystem system;
  system.add(point(1, -1));
  system.add(point(1, 3));
  std::vector<Velocity> velocity{{}, {{0, -4}, 0}};
  EXPECT_TRUE(system.solve(velocity));
  EXPECT_NEAR(system[0].impulse, 3, tolerance);
  EXPECT_NEAR(system[1].impulse, 1, tolerance);
  EXPECT_NEAR(velocity[1].v.y, 0, tolerance);
}

TEST(ConstraintSystem, LetsGoWhatWouldPull) {
  ConstraintSystem system;
  system.add(point(1, 1));
  system.add(point(1, 3));
  std::vector<Velocity> velocity{{}, {{0, -4}, 0}};
  EXPECT_TRUE(system.solve(velocity));
  EXPECT_EQ(system[1].impulse, 0);
  EXPECT_NEAR(system[0].impulse, 2, tolerance);
  EXPECT_GT(ConstraintSystem::speed(system[1], velocity), 0);
}

TEST(ConstraintSystem, SticksWithinTheConeAndSlidesAtItsEdge) {
  for (const double speed : {1., 3.}) {
    ConstraintSystem system;
    system.add(point(1, 0));
    system.add(friction(0, 1, real(.5)));
    std::vector<Velocity> velocity{{}, {{real(speed), -4}, 0}};
    EXPECT_TRUE(system.solve(velocity));
    EXPECT_NEAR(velocity[1].v.x, std::max(speed - 2, 0.), tolerance);
  }
}

// Friction below the centre of mass turns the body, and so changes what the point bears: by the new coefficient.
TEST(ConstraintSystem, SlidesByACoefficientThatChanges) {
  const auto begin = [](ConstraintSystem& system, Real coefficient) {
    system.add(point(1, real(.5)));
    system.add(friction(0, 1, coefficient));
    system[1].point_b[0] = system[1].arm_b = 1;
  };
  ConstraintSystem system;
  begin(system, real(.8));
  std::vector<Velocity> velocity{{}, {{9, -4}, 0}};
  EXPECT_TRUE(system.solve(velocity));
  system.set_friction(1, real(.2));
  EXPECT_TRUE(system.solve(velocity));
  ConstraintSystem expected;
  begin(expected, real(.2));
  velocity = {{}, {{9, -4}, 0}};
  EXPECT_TRUE(expected.solve(velocity));
  EXPECT_NEAR(system[0].impulse, expected[0].impulse, tolerance);
  EXPECT_NEAR(system[1].impulse, expected[1].impulse, tolerance);
}

// A guess that is right but for rounding is not solved anew.
TEST(ConstraintSystem, SlidesAtTheEdgeOfTheConeExactly) {
  ConstraintSystem system;
  system.add(point(1, 0));
  system.add(friction(0, 1, real(.5)));
  system[0].impulse = 4;
  system[1].impulse = real(-2) * (1 - 4 * std::numeric_limits<Real>::epsilon());
  std::vector<Velocity> velocity{{}, {{3, -4}, 0}};
  EXPECT_TRUE(system.solve(velocity));
  EXPECT_EQ(system[1].impulse, -2);
}

// The second point bears less than rounding, which is taken from it: so it carries no friction.
TEST(ConstraintSystem, RubsNoMoreThanWhatBearsAllows) {
  for (const double little : {1e-14, 3e-14, 1e-9, 5e-9}) {
    ConstraintSystem system;
    system.add(point(1, 0));
    system.add(point(1, 1));
    system.add(friction(0, 2, real(.5)));
    std::vector<Velocity> velocity{{}, {{3, -4}, real(-little)}};
    EXPECT_TRUE(system.solve(velocity));
    EXPECT_LE(std::abs(system[2].impulse), .5 * (system[0].impulse + system[1].impulse)) << little;
  }
}

// Three points in a row do not say how they share a load. Changes are weighed by inverse masses of 2, 1 and 2.
TEST(ConstraintSystem, ChangesImpulsesLeastFromTheGuess) {
  ConstraintSystem system;
  for (const double arm : {-1., 0., 1.}) system.add(point(1, real(arm)));
  for (Constraint& row : system.all()) row.impulse = 1;
  std::vector<Velocity> velocity{{}, {{0, -6}, 0}};
  EXPECT_TRUE(system.solve(velocity));
  EXPECT_NEAR(system[0].impulse, 1.75, 1e-3);
  EXPECT_NEAR(system[1].impulse, 2.5, 1e-3);
  EXPECT_NEAR(system[2].impulse, 1.75, 1e-3);
}

// A column of ten: each bears what stands on it, whatever the order of the list.
TEST(ConstraintSystem, SolvesAColumnAtOnceInAnyOrder) {
  for (const bool backwards : {false, true}) {
    ConstraintSystem system;
    for (std::uint32_t i = 0; i < 10; ++i) {
      const std::uint32_t upper = backwards ? 10 - i : i + 1;
      Constraint row = point(upper, 0);
      row.a = upper - 1;
      if (row.a > 0) row.mass_a = {1, 1};
      row.place = static_cast<Real>(upper);
      system.add(row);
    }
    std::vector<Velocity> velocity(11, Velocity{{0, -1}, 0});
    velocity[0] = {};
    EXPECT_TRUE(system.solve(velocity));
    for (const Constraint& row : system.all()) {
      EXPECT_NEAR(row.impulse, static_cast<Real>(11 - row.b), 20 * tolerance);
    }
  }
}

/// Whether all laws hold of equations, of points and of the friction of each, which follows it.
void expect_laws(const ConstraintSystem& system, const std::vector<Velocity>& velocity) {
  const double nothing = 100 * tolerance;
  for (std::size_t i = 0; i < system.all().size(); ++i) {
    const Constraint& normal = system[i];
    if (normal.law == Law::holds) {
      EXPECT_NEAR(ConstraintSystem::speed(normal, velocity), 0, nothing);
    }
    if (normal.law != Law::pushes) continue;
    const Constraint& rubs = system[i + 1];
    const double closes = -ConstraintSystem::speed(normal, velocity);
    const double slides = ConstraintSystem::speed(rubs, velocity);
    const double most = rubs.friction * normal.impulse;
    EXPECT_GE(normal.impulse, 0);
    EXPECT_LE(closes, nothing);
    EXPECT_LE(std::min(normal.impulse, -closes), nothing);
    EXPECT_LE(std::abs(rubs.impulse), most + nothing);
    if (std::abs(slides) > nothing) {
      EXPECT_NEAR(rubs.impulse, -std::copysign(most, slides), nothing);
    }
  }
}

// Rods that fall onto each other in any way, with friction, every other time hung from hinges. Newton's method alone
// goes in circles in one of five.
TEST(ConstraintSystem, SolvesJamsInWhichNewtonsMethodGoesInCircles) {
  std::mt19937 random(1);
  const auto upto_one = [&] { return real(std::ldexp(static_cast<double>(random()), -31) - 1); };  // from -1
  for (int trial = 0; trial < 300; ++trial) {
    constexpr std::uint32_t bodies = 5;
    ConstraintSystem system;
    for (std::uint32_t hung = 1; trial % 2 == 1 && hung <= 2; ++hung) {
      for (const Vec2 axis : {Vec2{1, 0}, Vec2{0, 1}}) {
        Constraint row;
        row.a = hung - 1;
        row.b = hung;
        row.mass_b = {1, 3};
        if (row.a > 0) row.mass_a = {1, 3};
        row.axis = axis;
        row.arm_a = axis.y;
        row.arm_b = -axis.y;
        system.add(row);
      }
    }
    for (int i = 0; i < 10; ++i) {
      Constraint row;
      row.b = 1 + static_cast<std::uint32_t>(random() % bodies);
      row.a = static_cast<std::uint32_t>(random() % row.b);
      row.mass_b = {1, 3};
      if (row.a > 0) row.mass_a = {1, 3};
      const Real angle = upto_one();
      row.axis = {std::sin(angle), std::cos(angle)};
      row.arm_a = upto_one();
      row.arm_b = upto_one();
      row.law = Law::pushes;
      const std::uint32_t first = system.add(row);
      row.axis = perpendicular(row.axis);
      row.law = Law::rubs;
      row.first = first;
      row.count = 1;
      row.friction = real(.5);
      row.point_a[0] = upto_one();
      row.point_b[0] = upto_one();
      system.add(row);
    }
    std::vector<Velocity> velocity(bodies + 1);
    for (std::uint32_t b = 1; b <= bodies; ++b) velocity[b] = {{upto_one(), -1}, upto_one()};
    EXPECT_TRUE(system.solve(velocity));
    expect_laws(system, velocity);
  }
}

// A body in a corner that turns with it: both contacts stick, at one of two points each, so that four laws are about
// three velocities. They contradict each other by as much as the walls' turn is taken for linear. Newton's method alone
// goes in circles in one of a hundred.
TEST(ConstraintSystem, LetsOneOfTwoContactsSlideWhereTheyCannotBothStick) {
  std::mt19937 random(2);
  const auto near = [&](double x) {
    return real(x + std::ldexp(static_cast<double>(random()), -33));
  };  // by .5 at most
  for (int trial = 0; trial < 300; ++trial) {
    ConstraintSystem system;
    const auto add_wall = [&](Vec2 normal, Real arm, Real depth) {
      Constraint row = point(1, arm);
      row.axis = normal;
      const std::uint32_t first = system.add(row);
      row.arm_b += 2;
      row.bias = 20;  // far apart
      system.add(row);
      row = friction(first, 2, real(.6));
      row.axis = perpendicular(normal);
      row.point_b = {depth, depth + real(.5)};
      return system.add(row);
    };
    const std::uint32_t slides = add_wall({1, 0}, near(-.93), near(-1.46));
    add_wall({0, 1}, near(0), near(-1.73));
    std::vector<Velocity> velocity{{}, {{near(0), -1}, near(0)}};
    for (const double contradiction : {1e-6, -1e-7, 1e-6, -1e-4}) {
      system[slides].point_bias[0] = contradiction;
      EXPECT_TRUE(system.solve(velocity)) << contradiction;
      for (const Constraint& row : system.all()) EXPECT_LE(std::abs(row.impulse), 2) << contradiction;
    }
  }
}

// Two equations that contradict each other: bounded, and said.
TEST(ConstraintSystem, SaysWhatItCannotSolve) {
  ConstraintSystem system;
  for (const double bias : {-1., 1.}) {
    Constraint row = point(1, 0);
    row.law = Law::holds;
    row.bias = real(bias);
    system.add(row);
  }
  std::vector<Velocity> velocity{{}, {}};
  EXPECT_FALSE(system.solve(velocity));
  EXPECT_LT(std::abs(velocity[1].v.y), 1.5);
}

// Of a body between two that push it apart by different speeds both are wrong by as much; what is beside it is as right
// as laws that yield by a thousandth can be.
TEST(ConstraintSystem, YieldsAlikeWhereLawsContradictEachOther) {
  ConstraintSystem system;
  for (const Real way : {real(1), real(-1)}) {
    Constraint row = point(1, 0);
    row.axis = {0, way};
    row.bias = way > 0 ? real(-.3) : real(-.1);
    system.add(row);
  }
  system.add(point(2, 0));
  std::vector<Velocity> velocity{{}, {}, {{0, -4}, 0}};
  EXPECT_FALSE(system.solve(velocity));
  EXPECT_NEAR(velocity[1].v.y, .1, 1e-3);
  EXPECT_NEAR(velocity[2].v.y, 0, 4 * 1e-3);
}

TEST(ConstraintSystem, UndoesWhatItSolved) {
  ConstraintSystem system;
  system.add(point(1, real(.3)));
  const std::vector<Velocity> before{{}, {{1, -4}, 2}};
  std::vector<Velocity> velocity = before;
  EXPECT_TRUE(system.solve(velocity));
  system.undo(velocity);
  EXPECT_EQ(velocity[1].v, before[1].v);
  EXPECT_EQ(velocity[1].w, before[1].w);
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::constraint_system_test
