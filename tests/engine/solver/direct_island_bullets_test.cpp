// Bullets that pass what they may hit within a sub-step.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "../support.h"
#include "impulse/impulse.h"

namespace impulse::inline IMPULSE_PRECISION::direct_island_bullets_test {
namespace {

BodyDef bullet(double x, double speed, double angle = 0) {
  BodyDef def = at(x, 0, speed, 0, 0, angle);
  def.bullet = true;
  return def;
}

// A disc of 100 m/s passes another, .5 mm too near or against its middle: apart at the start of the sub-step and at its
// end. Of equal masses, the other takes the speed along the normal.
TEST(DirectIsland, SeesDiscsThatPassEachOtherWithinASubStep) {
  for (const double start : {-1., -.3, -.2, -.15, -.1}) {
    for (const double beside : {.05, .09, .099, .0995}) {
      World world(falling(0));
      world.create_body(bullet(start, 100), Shape::circle(real(.05)), frictionless(1));
      const BodyId other = world.create_body(at(0, beside), Shape::circle(real(.05)), frictionless(1));
      world.step();
      const double along = 100 * std::sqrt(1 - 100 * beside * beside);
      EXPECT_NEAR(length(world.body(other).velocity()), along, .01) << start << ", " << beside;
    }
  }
}

struct Passing {
  double capsule = 0, box = 0;  // m, half lengths
  double from = 0, beside = 0;  // m
  double speed = 0;             // m/s
  double turned = 0, box_turned = 0;
};

double speed_of_box(const Passing& scene, double dt) {
  Settings settings = falling(0);
  settings.dt = real(dt);
  World world(settings);
  const Shape capsule = Shape::capsule({real(-scene.capsule), 0}, {real(scene.capsule), 0}, real(scene.capsule / 2));
  world.create_body(bullet(scene.from, scene.speed, scene.turned), capsule, frictionless(1));
  const Shape box = Shape::box({real(scene.box), real(.6 * scene.box)});
  const BodyId other = world.create_body(at(0, scene.beside, 0, 0, 0, scene.box_turned), box, frictionless(1));
  run(world, static_cast<int>(std::lround(.05 / dt)));
  return static_cast<double>(length(world.body(other).velocity()));
}

// Corners meet that are not the nearest at the start of the sub-step. A hundredth of a step sees each of them come.
TEST(DirectIsland, HitsWithWhateverCornerOfABulletMeetsFirst) {
  for (const Passing& scene : {Passing{.0905389, .245332, -.921692, .218697, 142.639, .392981, .0385816},
                               Passing{.0463902, .122215, -.601756, .111739, 133.122, 1.96085, .0408271},
                               Passing{.196101, .0380718, -1.50826, .107164, 67.2311, -.531125, -1.97772},
                               Passing{.117582, .0509925, -.946857, -.122453, 60.8023, -.800941, .545618},
                               Passing{.101467, .0877383, -.647411, -.177819, 120.814, -1.03499, -2.74781}}) {
    const double fine = speed_of_box(scene, 1. / 6000);
    EXPECT_GT(fine, 1);
    EXPECT_NEAR(speed_of_box(scene, 1. / 60), fine, 1e-3 * fine) << scene.from;
  }
}

// m/s, of a capsule whose end hits a thick one at 84 m/s, and rolls on it at 600 rad/s until it parts.
double speed_of_shot(double dt) {
  Settings settings = falling(0);
  settings.dt = real(dt);
  World world(settings);
  const Material rough{.static_friction = real(.8), .dynamic_friction = real(.8)};
  BodyDef def = at(-.6, .0338, 84, 1.24, 0, -2.48);
  def.bullet = true;
  const BodyId shot = world.create_body(def, Shape::capsule({real(-.0454), 0}, {real(.0454), 0}, real(.0114)), rough);
  const Shape thick = Shape::capsule({real(-.0508), 0}, {real(.0508), 0}, real(.118));
  world.create_body(at(0, 0, 0, -.92, 0, -.15), thick, rough);
  run(world, static_cast<int>(std::lround(.05 / dt)));
  return static_cast<double>(length(world.body(shot).velocity()));
}

// In an eighth of a sub-step it turns by a third of a radian.
TEST(DirectIsland, RollsAsItsTurningAsksHoweverFastThatIs) {
  const double fine = speed_of_shot(1. / 6000);
  EXPECT_GT(fine, 5);
  EXPECT_NEAR(speed_of_shot(1. / 60), fine, .005 * fine);
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::direct_island_bullets_test
