// Several sub-steps of a small island in one go: as exact as one by one, as nothing changes within them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support.h"

namespace impulse::inline IMPULSE_PRECISION::island_glide_test {
namespace {

constexpr double gravity = 10;  // m/s^2

// Friction that stops a box within a step stops it in the sub-step in which it does: in a whole step, the box would
// lose up to mu g dt^2 / 2, sixteen times as much.
TEST(Glide, EndsWhereFrictionStopsABox) {
  for (const double speed : {1., 1.013, 1.027, 1.04}) {
    World world(falling());
    add_floor(world, {1, real(.3), real(.3), 0});
    const BodyId box =
        world.create_body(at(0, .5, speed), Shape::box({real(.5), real(.5)}), {1, real(.3), real(.3), 0});
    run(world, 60);
    const double h = 1.0 / 240;
    const double stops_after = speed * speed / (2 * .3 * gravity);
    EXPECT_NEAR(static_cast<double>(world.body(box).position().x), stops_after, .3 * gravity * h * h / 2 + 1e-6)
        << speed;
  }
}

// A small box slides without friction over the edge of a table, and falls from the sub-step on in which it has left it.
TEST(Glide, EndsWhereTheGroundDoes) {
  constexpr double half = .01;  // m
  for (const double start : {-.5, -.506, -.512, -.518, -.524}) {
    World world(falling());
    BodyDef table = at(-5, -1);
    table.type = BodyType::fixed;
    world.create_body(table, Shape::box({5, 1}), frictionless());
    const BodyId box = world.create_body(at(start, half, 2), Shape::box({real(half), real(half)}), frictionless());
    run(world, 30);
    // Its centre passes the edge, and its end half its length later.
    const auto fallen = [&](double since) { return gravity * (.5 - since) * (.5 - since) / 2; };
    const double y = half - static_cast<double>(world.body(box).position().y);
    EXPECT_LE(y, fallen(-start / 2)) << start;
    EXPECT_GE(y, fallen((half - start) / 2 + 1. / 240)) << start;
  }
}

// Discs that roll and boxes that slide go on evenly: rounding is all that a step may add.
TEST(Glide, IsExactWhereNothingChanges) {
  World world(falling());
  add_floor(world, {1, 1, 1, 0});
  const BodyId disc = world.create_body(at(0, .5, 3, 0, -6), Shape::circle(real(.5)), {1, 1, 1, 0});
  const BodyId box = world.create_body(at(-9, .5, 3), Shape::box({real(.5), real(.5)}), frictionless());
  run(world, 60);
  const double rounding = 60 * 64 * static_cast<double>(round_off);
  EXPECT_NEAR(static_cast<double>(world.body(disc).position().x), 3, 3 * rounding);
  EXPECT_NEAR(static_cast<double>(world.body(disc).angular_velocity()), -6, 6 * rounding);
  EXPECT_NEAR(static_cast<double>(world.body(box).position().x), -6, 9 * rounding);
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::island_glide_test
