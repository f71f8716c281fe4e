// Joints under the default method, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "../real_literal.h"
#include "../support.h"
#include "impulse/impulse.h"

namespace impulse::inline IMPULSE_PRECISION::joints_test {
namespace {

constexpr bool is_double = sizeof(Real) == sizeof(double);
constexpr double bound(double in_double, double in_float) { return is_double ? in_double : in_float; }

Settings accurate(Vec2 gravity = {0, -10}) {
  Settings settings;
  settings.solver = "accurate";
  settings.gravity = gravity;
  return settings;
}

Vec2 vec(double x, double y) { return {real(x), real(y)}; }
Vec2 rotated(Vec2 v, double angle) { return Rotation(real(angle)) * v; }

BodyId anchor(World& world, Vec2 at = {}) {
  BodyDef def;
  def.type = BodyType::fixed;
  def.position = at;
  return world.create_body(def, Shape::circle(0.1_r));
}

BodyId box(World& world, Vec2 at, Vec2 half = {0.25_r, 0.25_r}, Real angle = 0, Real density = 1) {
  BodyDef def;
  def.position = at;
  def.angle = angle;
  Material material;
  material.density = density;
  return world.create_body(def, Shape::box(half), material);
}

void run_for(World& world, double seconds) {
  const int steps = static_cast<int>(std::lround(seconds * 60));
  for (int i = 0; i < steps; ++i) world.step();
}

double energy(World& world) {
  double sum = 0;
  for (const BodyId id : world.bodies()) {
    const Body body = world.body(id);
    const MassData mass = body.mass();
    const double w = static_cast<double>(body.angular_velocity());
    sum += static_cast<double>(mass.mass) *
               static_cast<double>(length_squared(body.velocity()) / 2 - dot(world.gravity(), body.center())) +
           static_cast<double>(mass.inertia) * w * w / 2;
  }
  return sum;
}

/// A box that hangs from the origin at a distance of 1 m, released at an angle (rad) from straight down.
struct Pendulum {
  World world{accurate()};
  BodyId bob;
  JointId hinge;

  explicit Pendulum(double from) {
    const BodyId post = anchor(world);
    const Vec2 at{static_cast<Real>(std::sin(from)), static_cast<Real>(-std::cos(from))};
    bob = box(world, at, {0.25_r, 0.25_r}, static_cast<Real>(from));
    hinge = world.create_joint(RevoluteJoint{post, bob, {}});
  }
};

TEST(Joints, PendulumConservesItsEnergyForAMinute) {
  for (const double from : {0.5, 1.0, 2.0}) {
    Pendulum p(from);
    const double swing = 10 * .25 * (1 - std::cos(from));  // m g L (1 - cos)
    const double before = energy(p.world);
    double worst = 0;
    for (int i = 0; i < 3600; ++i) {
      p.world.step();
      worst = std::max(worst, std::abs(energy(p.world) - before) / swing);
    }
    EXPECT_LT(worst, 5e-4) << from << " rad";
    EXPECT_NEAR(length(p.world.body(p.bob).position()), 1, bound(1e-6, 1e-4));
  }
}

TEST(Joints, PendulumHasThePeriodOfTheEllipticIntegral) {
  const double from = 1;
  Pendulum p(from);
  // T = 4 sqrt(I_p / (m g d)) K(sin(a/2)), K = pi / (2 agm(1, cos(a/2))).
  double a = 1;
  double b = std::cos(from / 2);
  for (int i = 0; i < 20; ++i) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  const double inertia = 1 + (.5 * .5 + .5 * .5) / 12;  // per mass, about the hinge
  const double period = 4 * std::sqrt(inertia / 10) * 3.14159265358979 / (2 * a);
  double crossing = 0;
  int crossings = 0;
  double last = static_cast<double>(p.world.body(p.bob).position().x);
  for (int i = 1; i <= 3600; ++i) {
    p.world.step();
    const double x = static_cast<double>(p.world.body(p.bob).position().x);
    if ((x > 0) != (last > 0)) {
      crossing = (i - x / (x - last)) / 60;
      ++crossings;
    }
    last = x;
  }
  EXPECT_NEAR(crossing / ((crossings - .5) * period / 2), 1, 2e-4);
}

TEST(Joints, HingeCarriesTheWeightOfItsBody) {
  Pendulum p(0);
  p.world.step();
  // 0.25 kg for one sub-step of 1/240 s; world frame, on the bob.
  EXPECT_NEAR(p.world.joint_impulse(p.hinge).y * 60, .25 * 10, bound(1e-6, 1e-3));
}

TEST(Joints, CradleOnStringsConservesItsEnergy) {
  World world(accurate());
  std::vector<BodyId> balls;
  Material steel;
  steel.restitution = 1;
  steel.static_friction = steel.dynamic_friction = 0;
  for (int i = 0; i < 5; ++i) {
    const Vec2 top{static_cast<Real>(i), 2};
    const BodyId post = anchor(world, top);
    BodyDef def;
    def.position = i == 0 ? top + Vec2{-2 * 0.6_r, -2 * 0.8_r} : top - Vec2{0, 2};
    balls.push_back(world.create_body(def, Shape::circle(0.5_r), steel));
    world.create_joint(DistanceJoint{post, balls.back(), top, def.position, 2});
  }
  const double before = energy(world);
  world.body(balls[0]);
  const double swing = static_cast<double>(world.body(balls[0]).mass().mass) * 10 * 2 * (1 - .8);
  run_for(world, 10);
  EXPECT_NEAR((energy(world) - before) / swing, 0, 2e-3);
}

TEST(Joints, WeldKeepsTwoBodiesTogether) {
  World world(accurate());
  const BodyId a = box(world, {0, 10});
  const BodyId b = box(world, {0.5_r, 10});
  world.body(a).set_velocity({}, 3);
  world.create_joint(WeldJoint{a, b, {0.25_r, 10}});
  run_for(world, 1);
  const Vec2 apart = world.body(b).position() - world.body(a).position();
  EXPECT_NEAR(length(apart), .5, bound(1e-6, 1e-4));
  EXPECT_NEAR(world.body(b).angle() - world.body(a).angle(), 0, bound(1e-6, 1e-4));
  EXPECT_NEAR((world.body(a).position().y + world.body(b).position().y) / 2, 10 - 5, bound(1e-6, 1e-3));
}

TEST(Joints, HingeStopsAtItsLimits) {
  World world(accurate());
  const BodyId post = anchor(world);
  const BodyId arm = box(world, {1, 0}, {1, 0.05_r});
  world.create_joint(RevoluteJoint{post, arm, {}, Limits{-0.5_r, 0.5_r}});
  run_for(world, 3);
  EXPECT_NEAR(world.body(arm).angle(), -.5, 1e-4);
  EXPECT_NEAR(world.body(arm).angular_velocity(), 0, bound(1e-6, 1e-3));
}

// A stop does not rebound, and what stops the arm acts at hinge and stop together.
TEST(Joints, HingeLosesAllSpeedInTheStepThatReachesItsLimit) {
  for (const double limit : {.2, .5236, 1.0, 1.2}) {
    World world(accurate());
    const BodyId post = anchor(world);
    const BodyId arm = box(world, {1, 0}, {1, 0.05_r});
    world.create_joint(RevoluteJoint{post, arm, {}, Limits{-static_cast<Real>(limit), 0.5_r}});
    for (int step = 0; step < 60; ++step) {
      world.step();
      if (world.body(arm).angle() > -limit + 1e-4) continue;
      EXPECT_NEAR(world.body(arm).angle(), -limit, bound(1e-6, 1e-5)) << limit << " at step " << step;
      EXPECT_NEAR(world.body(arm).angular_velocity(), 0, bound(1e-6, 1e-4)) << limit << " at step " << step;
    }
  }
}

// A stop acts when it is reached: until then an arm without forces keeps its speed, in every step that ends before.
TEST(Joints, HingeKeepsItsSpeedUntilItReachesItsLimit) {
  for (const double limit : {.2, .5236, 1.0, 1.2}) {
    World world(accurate({}));
    const BodyId post = anchor(world);
    BodyDef def;
    def.position = vec(1, 0);
    def.velocity = vec(0, -2);
    def.angular_velocity = -2;
    const BodyId arm = world.create_body(def, Shape::box(vec(1, .05)));
    world.create_joint(RevoluteJoint{post, arm, {}, Limits{-static_cast<Real>(limit), 0.5_r}});
    for (int step = 0; step < 60; ++step) {
      world.step();
      if (world.body(arm).angle() <= -limit + 1e-4) break;
      EXPECT_NEAR(world.body(arm).angular_velocity(), -2, bound(1e-6, 1e-4)) << limit << " at step " << step;
    }
  }
}

// A cart on a rail with a damped spring from beside it: what the spring damps is the velocity that the rail leaves.
// Half the step, a quarter of the error.
TEST(Joints, SpringOfACartOnARailIsDampedToSecondOrder) {
  const auto place = [](double dt) {
    Settings settings = accurate();
    settings.dt = real(dt);
    World world(settings);
    const BodyId post = anchor(world);
    BodyDef def;
    def.position = vec(1.2, 0);
    def.velocity = vec(1, 0);
    const BodyId cart = world.create_body(def, Shape::box(vec(.25, .25)));
    world.create_joint(PrismaticJoint{post, cart, vec(1.2, 0), vec(1, 0)});
    world.add_force(Spring{.a = {},
                           .b = cart,
                           .anchor_a = vec(.4, -.5),
                           .anchor_b = {},
                           .stiffness = 9,
                           .length = real(.5),
                           .damping = real(.5)});
    for (int step = 0; step < std::lround(.6 / dt); ++step) world.step();
    return static_cast<double>(world.body(cart).position().x);
  };
  const double coarse = place(.6 / 18);
  const double middle = place(.6 / 36);
  const double fine = place(.6 / 72);
  EXPECT_NEAR((coarse - middle) / (middle - fine), 4, .4);
}

// Compliance is the same along every direction: a door that a torque spins up to 1700 rad/s, where the joint cannot
// quite be kept, moves as the same door turned.
TEST(Joints, FastDoorMovesAlikeHoweverTheSceneIsTurned) {
  double spin = 0;  // rad/s, of the last
  const auto door = [&spin](double turned) {
    World world(accurate(rotated(vec(0, -10), turned)));
    const BodyId post = anchor(world);
    BodyDef def;
    def.position = rotated(vec(.33, 0), turned);
    def.velocity = rotated(vec(0, 1.5), turned);
    def.angle = real(turned);
    def.angular_velocity = real(4.5);
    const BodyId arm = world.create_body(def, Shape::box(vec(.33, .09)));
    world.create_joint(RevoluteJoint{post, arm, {}});
    for (int step = 0; step < 60; ++step) {
      world.body(arm).apply_torque(30);
      world.step();
    }
    spin = static_cast<double>(world.body(arm).angular_velocity());
    return rotated(world.body(arm).position(), -turned);
  };
  const Vec2 straight = door(0);
  // By the torque of 30 N m for a second, give or take what its weight does.
  const double mass = 4 * .33 * .09;
  const double inertia = mass * (.33 * .33 + .09 * .09) / 3 + mass * .33 * .33;
  EXPECT_NEAR(spin, 4.5 + 30 / inertia, mass * 10 * .33 / inertia);
  // In a second of steps, w = 1700 t is rounded by the kick, press and relaxation of each of 4 sub-steps, in 8
  // intervals, and so is the angle, w t/2, by each drift. The door's middle is .33 m from its hinge.
  const double turns = 3 * 1700. / 6 + 1700. / 2 / 3;
  const double rounding = 60 * 4 * 8 * turns * .33 * static_cast<double>(round_off);
  for (const double turned : {.3, .8, 2.0}) {
    EXPECT_NEAR(length(door(turned) - straight), 0, 1e-9 + rounding) << turned;
  }
}

TEST(Joints, MotorAcceleratesWithItsStrengthAndHoldsItsSpeed) {
  World world(accurate({}));
  const BodyId post = anchor(world);
  const BodyId wheel = box(world, {}, {0.5_r, 0.5_r});
  world.create_joint(RevoluteJoint{post, wheel, {}, {}, Motor{4, 0.5_r}});
  run_for(world, .5);
  // Torque / inertia = 0.5 / (1/6) = 3 rad/s^2.
  EXPECT_NEAR(world.body(wheel).angular_velocity(), 1.5, bound(.02, .02));
  run_for(world, 2);
  EXPECT_NEAR(world.body(wheel).angular_velocity(), 4, bound(1e-6, 1e-4));
}

TEST(Joints, SliderMovesOnlyAlongItsAxisAndStops) {
  World world(accurate());
  const BodyId post = anchor(world);
  const BodyId slider = box(world, {0, 0});
  world.create_joint(PrismaticJoint{post, slider, {}, {0.6_r, 0.8_r}, Limits{-2, 2}});
  run_for(world, .5);
  // Falls along the axis: g sin = 8 m/s^2.
  const Vec2 p = world.body(slider).position();
  EXPECT_NEAR(p.x * .8 - p.y * .6, 0, bound(1e-6, 1e-4));
  EXPECT_NEAR(length(p), .5 * 8 * .25, bound(1e-3, 1e-3));
  run_for(world, 2);
  EXPECT_NEAR(length(world.body(slider).position()), 2, 1e-3);
}

// What is still on its way to a stop falls on freely: 8 m/s^2.
TEST(Joints, SliderKeepsItsSpeedUntilTheStepThatReachesItsStop) {
  for (const double limit : {.9, 1.01, 1.7}) {
    World world(accurate());
    const BodyId post = anchor(world);
    const BodyId slider = box(world, {0, 0});
    world.create_joint(PrismaticJoint{post, slider, {}, {0.6_r, 0.8_r}, Limits{-static_cast<Real>(limit), 2}});
    for (int step = 1; step <= 60; ++step) {
      world.step();
      const double t = step / 60.0;
      const double speed = length(world.body(slider).velocity());
      EXPECT_NEAR(speed, 4 * t * t < limit ? 8 * t : 0, bound(1e-6, 1e-3)) << limit << " at step " << step;
    }
  }
}

// A slider that goes up against its stop at 3 m/s falls back from there from that moment on, not from a step's end.
TEST(Joints, SliderFallsBackFromTheMomentAtWhichItMetItsStop) {
  for (const double limit : {.2, .25, .3}) {
    World world(accurate());
    const BodyId post = anchor(world);
    const BodyId slider = box(world, {0, 0});
    world.body(slider).set_velocity({1.8_r, 2.4_r}, 0);
    world.create_joint(PrismaticJoint{post, slider, {}, {0.6_r, 0.8_r}, Limits{-9, static_cast<Real>(limit)}});
    const double met = (3 - std::sqrt(9 - 16 * limit)) / 8;  // 3 t - 4 t^2 = limit
    run_for(world, .5);
    const double off = bound(1e-9, 1e-5);
    EXPECT_NEAR(length(world.body(slider).velocity()), 8 * (.5 - met), off) << limit;
    EXPECT_NEAR(length(world.body(slider).position()), std::abs(limit - 4 * (.5 - met) * (.5 - met)), off) << limit;
  }
}

TEST(Joints, SoftDistanceIsASpring) {
  World world(accurate());
  const BodyId post = anchor(world, {0, 5});
  const BodyId bob = box(world, {0, 3});
  world.create_joint(DistanceJoint{post, bob, {0, 5}, {0, 3}, 2, 50, 0});
  const double w = std::sqrt(50 / .25);
  run_for(world, 2);
  EXPECT_NEAR(world.body(bob).position().y, 3 - 10 / (w * w) * (1 - std::cos(2 * w)), 2e-4 * 2 * w);
}

TEST(Joints, EndWithTheirBodiesAndDetectStaleHandles) {
  Pendulum p(0);
  p.world.destroy_body(p.bob);
  EXPECT_FALSE(p.world.contains(p.hinge));
  EXPECT_THROW(p.world.destroy_joint(p.hinge), std::out_of_range);
  EXPECT_THROW(p.world.create_joint(WeldJoint{p.bob, p.bob, {}}), std::out_of_range);
}

// Two joints of the same two bodies: each alone keeps them from colliding, and a body that comes in a destroyed one's
// place is joined to none.
TEST(Joints, KeepTheirBodiesFromCollidingUntilTheLastIsGone) {
  World world(accurate());
  const BodyId low = anchor(world);
  BodyId high = box(world, {0, .2_r});
  const DistanceJoint tie{low, high, {0, 0}, {0, .2_r}, .2_r, 10, 0};
  const auto touch = [&world] {
    world.step();
    return !world.contacts().empty();
  };
  const JointId first = world.create_joint(tie);
  const JointId second = world.create_joint(tie);
  EXPECT_FALSE(touch());
  world.destroy_joint(first);
  EXPECT_FALSE(touch());
  world.destroy_joint(second);
  EXPECT_TRUE(touch());

  world.create_joint(tie);
  EXPECT_FALSE(touch());
  world.destroy_body(high);
  high = box(world, {0, .2_r});
  EXPECT_TRUE(touch());
}

/// The greatest energy error of a chain of twenty links with a heavy end in 5 s, released from horizontal, relative to
/// the energy that it can lose by falling.
double energy_error_of_chain(int substeps) {
  Settings settings = accurate();
  settings.substeps = substeps;
  World world(settings);
  BodyId last = anchor(world);
  double scale = 0;
  for (int i = 0; i < 20; ++i) {
    const Real x = static_cast<Real>(i);
    const BodyId link = box(world, {x + 0.5_r, 0}, {0.5_r, 0.1_r}, 0, i == 19 ? 20_r : 1_r);
    world.create_joint(RevoluteJoint{last, link, {x, 0}});
    last = link;
    scale += 10 * static_cast<double>(world.body(link).mass().mass) * (i + .5);
  }
  const double before = energy(world);
  double most = 0;
  for (int step = 0; step < 300; ++step) {
    world.step();
    most = std::max(most, std::abs(energy(world) - before) / scale);
  }
  EXPECT_LT(length(world.body(last).position()), 20.);
  return most;
}

// The method is of second order: half the step gives a quarter of the error, as long as rounding is smaller, and no
// link swings so fast that sub-steps are divided, as it does with four of them.
TEST(Joints, ChainOfTwentyWithAHeavyEndHoldsAndConservesItsEnergy) {
  EXPECT_LT(energy_error_of_chain(4), 5e-5);
  const double coarse = energy_error_of_chain(8);
  const double fine = energy_error_of_chain(16);
  EXPECT_LT(coarse, 5e-5);
  EXPECT_LT(fine, 5e-5);
  if (sizeof(Real) == sizeof(double)) {
    EXPECT_NEAR(fine / coarse, .25, .02);
  }
}

// It hangs by two straight rows of planks, which their own weight hardly bends. Joints of more than 24 that were solved
// by iteration let the load fall by metres.
TEST(Joints, AChainOfFiftyPlanksBearsFiveThousandTimesItsWeight) {
  constexpr int planks = 25;  // on each side
  const Vec2 down = rotated(vec(1, 0), -.5);
  World world(accurate());
  const BodyId load = box(world, {}, {0.5_r, 0.1_r}, 0, 50 * 5000);
  for (const Real side : {-1_r, 1_r}) {
    const Vec2 along{-side * down.x, down.y};
    const Vec2 end{side / 2, 0};
    const Vec2 start = end - static_cast<Real>(planks) * along;
    BodyId last = anchor(world, start);
    for (int i = 0; i < planks; ++i) {
      const Vec2 from = start + static_cast<Real>(i) * along;
      const BodyId plank = box(world, from + 0.5_r * along, {0.5_r, 0.1_r}, std::atan2(along.y, along.x));
      world.create_joint(RevoluteJoint{last, plank, from});
      last = plank;
    }
    world.create_joint(RevoluteJoint{last, load, end});
  }
  run_for(world, 2);
  EXPECT_LT(length(world.body(load).position()), bound(1e-3, .05));
}

// A perfectly straight bridge of rigid planks would need infinite forces to stay at rest. Joints do no work, so the
// energy must never rise, however the bridge moves; and a ball dropped on it must not fall through.
TEST(Joints, StraightBridgeHoldsABallAndGainsNoEnergy) {
  for (const int planks : {10, 40}) {
    World world(accurate());
    const BodyId left = anchor(world);
    const BodyId right = anchor(world, {static_cast<Real>(planks), 0});
    BodyId last = left;
    for (int i = 0; i < planks; ++i) {
      const Real x = static_cast<Real>(i);
      const BodyId plank = box(world, {x + 0.5_r, 0}, {0.5_r, 0.1_r});
      world.create_joint(RevoluteJoint{last, plank, {x, 0}});
      last = plank;
    }
    world.create_joint(RevoluteJoint{last, right, {static_cast<Real>(planks), 0}});
    BodyDef def;
    def.position = {static_cast<Real>(planks) / 2, 3};
    const BodyId ball = world.create_body(def, Shape::circle(0.7_r), Material{1, 0.4_r, 0.4_r, 0.3_r});
    const double before = energy(world);
    for (int step = 0; step < 600; ++step) {
      world.step();
      ASSERT_LE(energy(world), before * (1 + bound(1e-12, 1e-5))) << planks << " planks, step " << step;
    }
    EXPECT_GT(world.body(ball).position().y, Real{0}) << planks << " planks";
  }
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::joints_test
