#include "reference/exact/slide.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scenarios/parts.h"

namespace plumb {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

struct Block {
  double speed, drive, load, sticking, sliding;
};

Slide slide(const Block& b) { return {b.speed, b.drive, b.load, b.sticking, b.sliding}; }

// Coulomb's law step by step; a step in which the speed would change its sign ends where it is zero.
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

TEST(Slide, SticksUpToTheAngleOfFrictionAndNoFurther) {
  const auto on_slope = [](double angle) { return Slide(0, 10 * std::sin(angle), 10 * std::cos(angle), 0.5, 0.5); };
  EXPECT_EQ(on_slope(std::atan(0.5) - 1e-9).at(1).speed, 0);
  EXPECT_GT(on_slope(std::atan(0.5) + 1e-9).at(1).speed, 0);
}

TEST(Slide, NeedsStaticFrictionToStartAndDynamicToGoOn) {
  const Slide breaks(0, 5, 10, 0.4, 0.1);
  EXPECT_DOUBLE_EQ(breaks.at(2).speed, 8);
  EXPECT_DOUBLE_EQ(breaks.friction(), 1);
  EXPECT_DOUBLE_EQ(Slide(0, 3, 10, 0.4, 0.1).friction(), 3);
}

TEST(Slide, KnowsWhenItPassesAPlace) {
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

TEST(SlideScene, TakesTilesLaidFlushForOneFloor) {
  const Engine& slide = *Catalog<Engine>::find("slide");
  const auto simulation = slide.build(tiled(6), {});
  simulation->step(1);
  std::vector<BodyState> states(7);
  simulation->read(states);
  EXPECT_NEAR(states[6].position.x, 1 + 3 - 0.5, 1e-14);  // 3 t - 0.1 g t^2/2
  // Its centre at 5 it would reach over the end at 5.5, after 4 m: 3 t - t^2/2 = 4.
  EXPECT_NEAR(simulation->valid_until(), 2, 1e-12);
}

TEST(SlideScene, RefusesTilesThatAreNotFlushOrRubDifferently) {
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

}  // namespace
}  // namespace plumb
