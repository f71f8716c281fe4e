#include "reference/exact/friction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/integrate.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::friction_test {
namespace {

namespace slide_tests {

constexpr double never = std::numeric_limits<double>::infinity();

struct Block {
  double speed, drive, load, sticking, sliding;
};

Slide slide(const Block& b) { return {b.speed, b.drive, b.load, b.sticking, b.sliding}; }

// Coulomb's law step by step. A step in which the speed would change its sign ends where the speed is zero.
Slide::State integrate(const Block& b, double until) {
  const double h = until / 1000;
  Slide::State now{0, b.speed};
  for (double left = until; left > 0;) {
    const bool sticks = now.speed == 0 && std::abs(b.drive) <= b.sticking * b.load;
    const double against = now.speed == 0 ? b.drive : now.speed;
    const double acceleration = sticks ? 0 : b.drive - std::copysign(b.sliding * b.load, against);
    double step = std::min(h, left);
    double next = now.speed + step * acceleration;
    if (now.speed * next < 0) {
      step *= now.speed / (now.speed - next);
      next = 0;
    }
    now = {now.distance + step * (now.speed + next) / 2, next};
    left -= step;
  }
  return now;
}

const Block up_and_back{.speed = 3, .drive = -5, .load = 8, .sticking = 0.5, .sliding = 0.2};
const Block up_and_stay{.speed = 3, .drive = -3, .load = 8, .sticking = 0.5, .sliding = 0.2};
const Block down{.speed = 0, .drive = -5, .load = 8, .sticking = 0.5, .sliding = 0.2};
const Block held{.speed = 0, .drive = 3.9, .load = 8, .sticking = 0.5, .sliding = 0.2};

TEST(Slide, AgreesWithCoulombsLawStepByStep) {
  for (const Block& block : {up_and_back, up_and_stay, down, held}) {
    for (const double t : {0.2, 0.5, 2.0}) {
      const Slide::State expected = integrate(block, t);
      const Slide::State state = slide(block).at(t);
      EXPECT_NEAR(state.distance, expected.distance, 1e-9) << block.speed << ' ' << block.drive << ' ' << t;
      EXPECT_NEAR(state.speed, expected.speed, 1e-9) << block.speed << ' ' << block.drive << ' ' << t;
    }
  }
}

TEST(Slide, StopsAfterVOverMuG) {
  const Slide stopping(4, 0, 10, 0.2, 0.2);
  EXPECT_DOUBLE_EQ(stopping.stop(), 2);
  EXPECT_DOUBLE_EQ(stopping.at(2).distance, 4);  // v^2/(2 mu g)
  EXPECT_DOUBLE_EQ(stopping.at(9).distance, 4);
  EXPECT_EQ(stopping.at(9).speed, 0);
}

TEST(Slide, SticksUpToTheAngleOfFriction) {
  const auto on_slope = [](double angle) { return Slide(0, 10 * std::sin(angle), 10 * std::cos(angle), 0.5, 0.5); };
  EXPECT_EQ(on_slope(std::atan(0.5) - 1e-9).at(1).speed, 0);
  EXPECT_GT(on_slope(std::atan(0.5) + 1e-9).at(1).speed, 0);
}

TEST(Slide, NeedsStaticFrictionToStartAndDynamicToContinue) {
  const Slide breaks(0, 5, 10, 0.4, 0.1);
  EXPECT_DOUBLE_EQ(breaks.at(2).speed, 8);
  EXPECT_DOUBLE_EQ(breaks.friction(), 1);
  EXPECT_DOUBLE_EQ(Slide(0, 3, 10, 0.4, 0.1).friction(), 3);
}

TEST(Slide, KnowsWhenItReachesADistance) {
  for (const double distance : {0.3, 0.5, -0.4, -7.0}) {
    const Slide there = slide(up_and_back);
    const double t = there.reaches(distance);
    EXPECT_NEAR(there.at(t).distance, distance, 1e-12);
  }
  EXPECT_LT(slide(up_and_back).reaches(0.5), slide(up_and_back).stop());
  EXPECT_EQ(slide(up_and_back).reaches(1), never);
  EXPECT_EQ(slide(up_and_stay).reaches(-1), never);
  EXPECT_EQ(slide(held).reaches(1e-9), never);
  EXPECT_DOUBLE_EQ(Slide(2, 0, 10, 0, 0).reaches(3), 1.5);
}

// Tiles of 1 m along y = 0, a box on them.
Scene tiled(int tiles) {
  Scene scene{.name = "tiles"};
  for (int i = 0; i < tiles; ++i) {
    scene.bodies.push_back(box("tile", {static_cast<double>(i), -0.5}, {1, 1}, surface(0.1, 0)));
    scene.bodies.back().type = BodyType::fixed;
  }
  scene.bodies.push_back(box("box", {1, 0.25}, {1, 0.5}, surface(0.1, 0)));
  scene.bodies.back().velocity = {3, 0};
  return scene;
}

// Steeper than 45 degrees, gravity is more opposed to the end of a slab than to its top.
TEST(SlideScene, KnowsTheFaceUnderABoxOnASteepSlope) {
  const double angle = 67 * std::numbers::pi / 180;
  const Vec up{-std::sin(angle), std::cos(angle)};
  Scene scene{.name = "steep"};
  scene.bodies.push_back(box("slope", {0, 0}, {60, 1}, surface(0.2, 0)));
  scene.bodies.push_back(box("box", 1.0 * up, {1, 1}, surface(0.2, 0)));
  scene.bodies[0].type = BodyType::fixed;
  for (Body& body : scene.bodies) body.angle = angle;
  const Engine& slide = *Catalog<Engine>::find("slide");
  ASSERT_EQ(slide.unsupported(scene, {}), "");
  const auto simulation = slide.build(scene, {});
  simulation->step(1);
  std::vector<BodyState> states(2);
  simulation->read(states);
  EXPECT_NEAR(std::hypot(states[1].velocity.x, states[1].velocity.y),
              -scene.gravity.y * (std::sin(angle) - 0.2 * std::cos(angle)), 1e-12);
}

TEST(SlideScene, TreatsFlushTilesAsOneFloor) {
  const Engine& slide = *Catalog<Engine>::find("slide");
  const auto simulation = slide.build(tiled(6), {});
  simulation->step(1);
  std::vector<BodyState> states(7);
  simulation->read(states);
  EXPECT_NEAR(states[6].position.x, 1 + 3 - 0.5, 1e-14);  // 3 t - 0.1 g t^2/2
  // With its centre at 5 it reaches the end at 5.5, after 4 m: 3 t - t^2/2 = 4.
  EXPECT_NEAR(simulation->valid_until(), 2, 1e-12);
}

TEST(SlideScene, RefusesTilesThatAreNotFlushOrDifferInFriction) {
  const Engine& slide = *Catalog<Engine>::find("slide");
  ASSERT_EQ(slide.unsupported(tiled(6), {}), "");
  Scene step = tiled(6);
  step.bodies[3].position.y -= 1e-6;
  Scene gap = tiled(6);
  gap.bodies[5].position.x += 1e-6;
  Scene patch = tiled(6);
  patch.bodies[3].shapes[0].surface.dynamic_friction = 0.2;
  for (const Scene& scene : {step, gap, patch}) EXPECT_NE(slide.unsupported(scene, {}), "");
}

}  // namespace slide_tests

namespace roll_tests {

// Coulomb's law step by step. A step in which the slip would change its sign ends where the slip is zero.
Roll::State integrate(const Roll::Setup& c, double until) {
  const double h = until / 1000;
  Roll::State now{0, c.speed, 0, c.spin};
  bool slips = c.speed + c.spin * c.radius != 0;
  for (double left = until; left > 0;) {
    const double slip = slips ? now.speed + now.spin * c.radius : 0;
    const double hold = -c.drive / (1 + c.shape);
    const bool rolls = slip == 0 && std::abs(hold) <= c.static_friction * c.load;
    const double against = slip == 0 ? c.drive : slip;
    const double friction = rolls ? hold : -std::copysign(c.dynamic_friction * c.load, against);
    const double a = c.drive + friction;
    const double alpha = friction * c.shape / c.radius;
    double step = std::min(h, left);
    const double change = a + alpha * c.radius;
    slips = !rolls;
    if (slip != 0 && slip * (slip + change * step) <= 0) {
      step = -slip / change;
      slips = false;
    }
    now = {now.distance + step * (now.speed + step * a / 2), now.speed + step * a,
           now.angle + step * (now.spin + step * alpha / 2), now.spin + step * alpha};
    left -= step;
  }
  return now;
}

TEST(Roll, AgreesWithCoulombsLawStepByStep) {
  const Roll::Setup thrown{.speed = 6, .radius = 0.5, .load = 10, .static_friction = 0.3, .dynamic_friction = 0.2};
  Roll::Setup backspin = thrown;
  backspin.spin = 30;
  Roll::Setup uphill = thrown;
  uphill.drive = -3;
  Roll::Setup steep = thrown;
  steep.drive = 15;
  Roll::Setup hoop = uphill;
  hoop.shape = 1;
  for (const Roll::Setup& c : {thrown, backspin, uphill, steep, hoop}) {
    for (const double t : {0.2, 1.0, 3.0}) {
      const Roll::State expected = integrate(c, t);
      const Roll::State state = Roll(c).at(t);
      EXPECT_NEAR(state.distance, expected.distance, 1e-9 * 100) << c.drive << ' ' << c.spin << ' ' << t;
      EXPECT_NEAR(state.speed, expected.speed, 1e-9 * 50);
      EXPECT_NEAR(state.angle, expected.angle, 1e-9 * 100);
      EXPECT_NEAR(state.spin, expected.spin, 1e-9 * 50);
    }
  }
}

TEST(Roll, SlipsUntilVOverThreeMuGThenKeepsTwoThirds) {
  const Roll roll({.speed = 6, .radius = 0.5, .load = 10, .static_friction = 0.2, .dynamic_friction = 0.2});
  EXPECT_DOUBLE_EQ(roll.grip(), 1);
  EXPECT_DOUBLE_EQ(roll.at(1).speed, 4);
  EXPECT_DOUBLE_EQ(roll.at(5).speed, 4);
  EXPECT_DOUBLE_EQ(roll.at(5).spin, -8);
}

TEST(Roll, AcceleratesDownASlopeWithTwoThirdsIffFrictionHolds) {
  const double angle = 0.4;
  const auto on_slope = [angle](double mu) {
    return Roll({.radius = 0.5,
                 .drive = 10 * std::sin(angle),
                 .load = 10 * std::cos(angle),
                 .static_friction = mu,
                 .dynamic_friction = mu});
  };
  const double limit = std::tan(angle) / 3;
  EXPECT_NEAR(on_slope(limit * 1.001).at(1).speed, 20.0 / 3 * std::sin(angle), 1e-14);
  const double weak = limit / 2;
  EXPECT_NEAR(on_slope(weak).at(1).speed, 10 * (std::sin(angle) - weak * std::cos(angle)), 1e-14);
  EXPECT_NEAR(on_slope(weak).at(1).spin, -2 * weak * 10 * std::cos(angle) / 0.5, 1e-14);
}

TEST(Roll, NeverGripsWithoutFriction) {
  const Roll ice({.speed = 6, .radius = 0.5, .load = 10});
  EXPECT_EQ(ice.grip(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(ice.at(9).speed, 6);
}

}  // namespace roll_tests

namespace plank_tests {

const Plank::Setup soft{
    .plank = 5, .body = 3, .radius = 0.4, .pull = 12, .gravity = 10, .static_friction = 0.5, .dynamic_friction = 0.5};

// Friction as a very stiff viscous brake on the slip, c (V - v - w r), limited to mu m g. It has no notion of rolling;
// the motion differs from Coulomb's by a term of order 1/c.
TEST(Plank, AgreesWithAViscousBrakeOnTheSlip) {
  for (const double pull : {12.0, 200.0}) {
    Plank::Setup c = soft;
    c.pull = pull;
    const double inertia = c.body * c.radius * c.radius / c.shape;
    constexpr double brake = 1e6;  // N s/m
    std::array<double, 3> y{};     // V, v, w
    constexpr int steps = 400000;
    for (int i = 0; i < steps; ++i) {
      y = runge_kutta(y, 1.0 / steps, [&](const std::array<double, 3>& now) {
        const double most = c.dynamic_friction * c.body * c.gravity;
        const double f = std::clamp(brake * (now[0] - now[1] - now[2] * c.radius), -most, most);
        return std::array<double, 3>{(c.pull - f) / c.plank, f / c.body, f * c.radius / inertia};
      });
    }
    const Plank motion(c);
    EXPECT_EQ(motion.rolls(), pull < 100);
    // The error of the brake: its slip f/c, and a transient of m/c seconds.
    const double tolerance = 1e-9 * pull + pull / brake;
    EXPECT_NEAR(y[0], motion.plank(), tolerance) << pull;
    EXPECT_NEAR(y[1], motion.body(), tolerance) << pull;
    EXPECT_NEAR(y[2], motion.spin(), 2 * tolerance / c.radius) << pull;
  }
}

TEST(Plank, ObeysNewtonsLawForBothBodiesAndRollsWithoutSlip) {
  const Plank motion(soft);
  EXPECT_NEAR(soft.plank * motion.plank() + soft.body * motion.body(), soft.pull, 1e-14 * soft.pull);
  EXPECT_NEAR(motion.body() + motion.spin() * soft.radius, motion.plank(), 1e-14);
  EXPECT_NEAR(motion.body(), motion.plank() / 3, 1e-15);
  EXPECT_NEAR(motion.plank(), soft.pull / (soft.plank + soft.body / 3), 1e-14);
}

// mu g (3 M + m) is the strongest pull at which a disc does not slip.
TEST(Plank, RollsUpToThePullThatFrictionAllows) {
  Plank::Setup c = soft;
  const double limit = c.static_friction * c.gravity * (3 * c.plank + c.body);
  c.pull = limit * (1 - 1e-12);
  EXPECT_TRUE(Plank(c).rolls());
  c.pull = limit * (1 + 1e-12);
  EXPECT_FALSE(Plank(c).rolls());
  EXPECT_NEAR(Plank(c).body(), c.dynamic_friction * c.gravity, 1e-15);
}

TEST(Plank, IgnoresAWeightlessBodyAndDoesNotMoveAFrictionlessOne) {
  Plank::Setup c = soft;
  c.body = 1e-12;
  EXPECT_NEAR(Plank(c).plank(), c.pull / c.plank, 1e-12);
  c = soft;
  c.static_friction = c.dynamic_friction = 0;
  EXPECT_EQ(Plank(c).body(), 0);
  EXPECT_EQ(Plank(c).spin(), 0);
}

// Twice the forces on twice the masses, three times the lengths.
TEST(Plank, ScalesWithItsUnits) {
  Plank::Setup c = soft;
  c.plank *= 2;
  c.body *= 2;
  c.pull *= 2;
  c.radius *= 3;
  EXPECT_NEAR(Plank(c).plank(), Plank(soft).plank(), 1e-15);
  EXPECT_NEAR(Plank(c).spin(), Plank(soft).spin() / 3, 1e-15);
}

TEST(PlankScene, IsRefusedWithFrictionOnTheFloor) {
  const Scenario& family = *Catalog<Scenario>::find("pushed-plank");
  Scene scene = family.scene(complete(family, {}));
  const Engine& plank = *Catalog<Engine>::find("plank");
  EXPECT_EQ(plank.unsupported(scene, {}), "");
  scene.bodies[0].shapes[0].surface.dynamic_friction = 0.1;
  EXPECT_NE(plank.unsupported(scene, {}), "");
}

}  // namespace plank_tests

}  // namespace
}  // namespace plumb::friction_test
