// The three methods of sequential impulses: common properties, and differences that theory predicts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "../support.h"

namespace sequential_impulses_test {
namespace {

using namespace impulse;

constexpr bool is_double = sizeof(Real) == sizeof(double);

Settings with(const char* solver, bool gravity = true) {
  Settings settings;
  settings.solver = solver;
  if (!gravity) settings.gravity = {};
  return settings;
}

Shape unit_box() { return Shape::box({real(.5), real(.5)}); }

double load_on_floor(World& world) {
  double sum = 0;
  for (const ContactInfo& contact : world.contacts()) {
    if (contact.a.index == 0) sum += static_cast<double>(contact.normal_impulse);
  }
  return sum;
}

// One iteration a step is far too few for three boxes without warm starting.
TEST(SequentialImpulse, FindsTheLoadOfAStackInOneIterationAStepByWarmStarting) {
  for (const char* solver : {"sequential-impulse", "split-impulse", "block"}) {
    Settings settings = with(solver);
    settings.iterations = 1;
    World world(settings);
    add_floor(world);
    for (int i = 0; i < 3; ++i) world.create_body(at(0, .5 + i), unit_box());
    world.step();
    world.step();
    EXPECT_GT(std::abs(load_on_floor(world) * 60 / 30 - 1), .05) << solver;
    run(world, 600);
    EXPECT_NEAR(load_on_floor(world) * 60 / 30, 1, is_double ? 1e-3 : 2e-3) << solver;
  }
}

// beta (overlap - slop)/dt = .2 (.1 - .005) 60 m/s at most.
TEST(SequentialImpulse, PushesOverlappingBodiesApartWithSpeed) {
  World world(with("sequential-impulse", false));
  add_floor(world);
  const BodyId disc = world.create_body(at(0, .4), Shape::circle(real(.5)));
  world.step();
  EXPECT_NEAR(world.body(disc).velocity().y, .2 * .095 * 60, 1e-5);
}

// A fifth of what is left beyond the slop in each of three iterations.
TEST(SplitImpulse, SeparatesOverlappingBodiesWithoutSpeed) {
  for (const char* solver : {"split-impulse", "block"}) {
    World world(with(solver, false));
    add_floor(world);
    const BodyId disc = world.create_body(at(0, .4), Shape::circle(real(.5)));
    world.step();
    EXPECT_NEAR(world.body(disc).position().y, .495 - .095 * .8 * .8 * .8, 1e-6) << solver;
    EXPECT_EQ(world.body(disc).velocity(), Vec2{}) << solver;
  }
}

/// rad/s, the remaining spin of a box that lands flat.
double turning(const char* solver) {
  World world(with(solver, false));
  add_floor(world, frictionless(.5));
  const BodyId box = world.create_body(at(0, .499, 0, -3), unit_box(), frictionless(.5));
  world.step();
  return std::abs(static_cast<double>(world.body(box).angular_velocity()));
}

// Point by point, each iteration leaves .6 of the last one's error; solved together, none is left.
TEST(Block, LandsABoxWithoutRotatingIt) {
  EXPECT_LT(turning("block"), 32 * round_off);
  EXPECT_LT(turning("block"), turning("sequential-impulse"));
  EXPECT_EQ(turning("split-impulse"), turning("sequential-impulse"));
}

TEST(Block, SolvesEveryCaseOfTwoPoints) {
  // A box that turns as it lands: one corner is pushed, the other lifts off.
  for (const double w : {-4.0, 0.0, 4.0}) {
    World world(with("block", false));
    add_floor(world, frictionless());
    BodyDef def = at(0, .499, 0, -1);
    def.angular_velocity = real(w);
    const BodyId box = world.create_body(def, unit_box(), frictionless());
    world.step();
    const double vy = world.body(box).velocity().y;
    const double turn = world.body(box).angular_velocity();
    for (const double side : {-.5, .5}) EXPECT_GT(vy + turn * side, -1e-5) << w;
    if (w == 0) {
      EXPECT_NEAR(vy, 0, 1e-6);
    } else {
      // J = -vn/(1/m + 6 rx^2/m) with rx = .5 on the corner that comes down, vn = -1 - 2.
      EXPECT_NEAR(vy, -1 + 3 / 2.5, 1e-5);
      EXPECT_NEAR(std::abs(turn), 4 - 6 * .5 * 3 / 2.5, 1e-5);
    }
  }
}

/// The farthest (m) that a box of a stack of five has gone aside after five seconds.
double drift(const char* solver) {
  World world(with(solver));
  add_floor(world);
  std::vector<BodyId> boxes;
  for (int i = 0; i < 5; ++i) boxes.push_back(world.create_body(at(i % 2 == 0 ? .001 : -.001, .5 + i), unit_box()));
  run(world, 300);
  double farthest = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const double x = static_cast<double>(world.body(boxes[i]).position().x) - (i % 2 == 0 ? .001 : -.001);
    farthest = std::max(farthest, std::abs(x));
  }
  return farthest;
}

// Without accumulation, friction is limited by each impulse and not by their sum.
TEST(SequentialImpulse, HoldsAStackBetterThanWithoutAccumulation) {
  EXPECT_LT(drift("sequential-impulse"), drift("article"));
  EXPECT_LT(drift("split-impulse"), drift("article"));
  EXPECT_LT(drift("block"), drift("article"));
}

/// How far (m) a disc falls short of g t^2/2 in a second.
double fall_short(const char* solver) {
  World world(with(solver));
  const BodyId disc = world.create_body(at(0, 0), Shape::circle(1));
  run(world, 60);
  return std::abs(static_cast<double>(world.body(disc).position().y) + 5);
}

// Errors of first order in the step, of which sub-steps have a quarter; the default has none.
TEST(SequentialImpulse, FallsWithTheErrorOfItsStep) {
  EXPECT_NEAR(fall_short("sequential-impulse"), 10.0 / 120, 1e-4);
  EXPECT_NEAR(fall_short("soft-step"), fall_short("sequential-impulse") / 4, 1e-4);
  EXPECT_NEAR(fall_short("xpbd"), fall_short("sequential-impulse") / 4, 1e-4);
  EXPECT_LT(fall_short("accurate"), 1e-4);
}

}  // namespace
}  // namespace sequential_impulses_test
