#include "solver/impacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support.h"
#include "worlds.h"

namespace impulse::inline IMPULSE_PRECISION::impacts_test {
namespace {

// The corner it stands on carries it throughout, although the other one is about to bounce.
TEST(Impacts, HoldABoxThatTipsOntoItsFaceAtTheCornerItStandsOn) {
  constexpr double half = 0.15;
  constexpr double turn = 2;  // rad/s
  constexpr double lean = 0.6;
  World world{Settings{}};
  const Material bouncing{1, real(.5), real(.5), real(.1)};
  add_floor(world, bouncing);
  // Turns about its lower right corner, which touches the floor.
  const double across = half * (std::cos(lean) - std::sin(lean));
  const double up = half * (std::cos(lean) + std::sin(lean));
  BodyDef def = at(0, up, turn * -up, turn * -across);
  def.angle = real(-lean);
  def.angular_velocity = real(turn);
  const BodyId box = world.create_body(def, Shape::box({real(half), real(half)}), bouncing);
  const auto lowest = [&] {
    const Body body = world.body(box);
    Real low = 1;
    for (const double x : {-half, half})
      low = std::min(low, (body.position() + body.rotation() * Vec2{real(x), real(-half)}).y);
    return static_cast<double>(low);
  };
  double deepest = 0;
  for (int step = 0; step < 12; ++step) {
    world.step();
    deepest = std::min(deepest, lowest());
  }
  EXPECT_GT(deepest, -1e-4);
}

// While it slips, the dynamic coefficient acts: Jt = mu_d (1 + e) v, although the static one could stop it.
TEST(Impacts, SlipWithTheDynamicCoefficient) {
  constexpr double e = 0.6;
  Settings weightless;
  weightless.gravity = {};
  World world(weightless);
  const Material m{1, real(.8), real(.2), real(e)};
  add_floor(world, m);
  const BodyId ball = world.create_body(at(0, 1, 5, -2), Shape::circle(real(.5)), m);
  run(world, 60);
  EXPECT_NEAR(static_cast<double>(world.body(ball).velocity().x), 5 - .2 * (1 + e) * 2, 1e-5);
  EXPECT_NEAR(static_cast<double>(world.body(ball).angular_velocity() * real(.25)), -.2 * (1 + e) * 2, 1e-5);
}

// At e = 0 as at any other: the discs touch where they meet, whatever the sub-step, so the angular momentum about the
// origin stays and the impulse along the normal is the whole one.
TEST(Impacts, StopInelasticDiscsWhereTheyMeet) {
  Settings weightless;
  weightless.gravity = {};
  for (const double offset : {0.0, 0.35, 0.8}) {
    World world(weightless);
    const Material rough{1, real(.3), real(.3), 0};
    const BodyId left = world.create_body(at(-2, 0, 3, 0, 4), Shape::circle(real(.5)), rough);
    const BodyId right = world.create_body(at(2.03, offset, -4, 0, -1), Shape::circle(real(.5)), rough);
    const auto spin = [&] {
      const auto of = [&](BodyId id) {
        const Body body = world.body(id);
        const double mass = static_cast<double>(pi) / 4;
        const double across = static_cast<double>(body.position().x) * static_cast<double>(body.velocity().y) -
                              static_cast<double>(body.position().y) * static_cast<double>(body.velocity().x);
        return mass * across + mass / 8 * static_cast<double>(body.angular_velocity());
      };
      return of(left) + of(right);
    };
    const double before = spin();
    run(world, 60);
    EXPECT_NEAR(spin(), before, bound(1e-13, 1e-5)) << offset;
    const Vec2 apart = world.body(right).position() - world.body(left).position();
    const Vec2 closing = world.body(right).velocity() - world.body(left).velocity();
    EXPECT_GT(std::hypot(static_cast<double>(apart.x), static_cast<double>(apart.y)), 1 - bound(1e-9, 1e-5)) << offset;
    EXPECT_LT(static_cast<double>(std::abs(closing.x)), 7) << offset;
  }
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::impacts_test
