// What the default method promises at 60 Hz with 4 sub-steps of bodies that lie on each other: they stand, come to rest
// and gain no energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "worlds.h"

namespace impulse::inline IMPULSE_PRECISION::accurate_piles_test {
namespace {

struct Stacked {
  double low;      // m, by which the top is too low at the end
  double aside;    // m, farthest drift of any box sideways
  double fastest;  // m/s, at the end
};

Stacked stack(int n, double top_density, unsigned seed, double seconds) {
  World world(accurate());
  std::mt19937 random(seed);
  ground(world, material(0, .6));
  std::vector<BodyId> boxes;
  std::vector<double> xs;
  for (int i = 0; i < n; ++i) {
    Material m = material(0, .6);
    if (i == n - 1) m.density = real(top_density);
    xs.push_back(seeded(random, -.002, .002));
    boxes.push_back(world.create_body(at(xs.back(), .5 + i), Shape::box(vec(.5, .5)), m));
  }
  run_for(world, seconds);
  Stacked result{};
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Body body = world.body(boxes[i]);
    result.aside = std::max(result.aside, std::abs(static_cast<double>(body.position().x) - xs[i]));
    result.fastest = std::max(result.fastest, static_cast<double>(length(body.velocity())));
  }
  result.low = n - .5 - static_cast<double>(world.body(boxes.back()).position().y);
  return result;
}

/// The mean speed (m/s) of discs without friction that were poured into a box, after some seconds.
double speed_of_smooth_discs(int count, double seconds) {
  World world(accurate());
  std::mt19937 random(1);
  const Material smooth = material(0, 0);
  const int columns = static_cast<int>(std::sqrt(count));
  const double half = .3 * columns + .3;
  ground(world, smooth);
  for (const double side : {-1., 1.}) {
    BodyDef wall = at(side * (half + .5), 2 * half);
    wall.type = BodyType::fixed;
    world.create_body(wall, Shape::box(vec(.5, 3 * half)), smooth);
  }
  std::vector<BodyId> discs;
  for (int i = 0; i < count; ++i) {
    const double x = (i % columns - (columns - 1) / 2.) * .6 + seeded(random, -.04, .04);
    const int row = i / columns;
    discs.push_back(world.create_body(at(x, .3 + .6 * row), Shape::circle(real(seeded(random, .2, .25))), smooth));
  }
  run_for(world, seconds);
  double sum = 0;
  for (const BodyId id : discs) sum += static_cast<double>(length(world.body(id).velocity()));
  return sum / count;
}

// Nothing locks them and no spring damps how they slide around each other.
TEST(Accurate, PilesOfFrictionlessDiscsComeToRest) {
  for (const int count : {300, 600}) {
    EXPECT_LT(speed_of_smooth_discs(count, 20), static_cast<double>(Settings().sleep_linear_speed) / 10) << count;
  }
}

TEST(Accurate, AHeavyBodyInAWallOfSmallOnesGainsNoEnergy) {
  Settings settings = accurate();
  settings.gravity = {};
  World world(settings);
  BodyDef heavy = at(-3, 0, 10);
  world.create_body(heavy, Shape::box({1, 1}), {8, real(.4), real(.4), 0});
  for (int i = 0; i < 48; ++i) {
    const int column = i / 8;
    world.create_body(at(column * .41, (i % 8 - 3.5) * .41), Shape::box(vec(.2, .2)), material(0, .4));
  }
  const double start = energy(world);
  double last = start;
  for (int i = 0; i < 60; ++i) {
    world.step();
    const double now = energy(world);
    EXPECT_LE(now, last + bound(1e-12, 1e-5) * start) << "step " << i;
    last = now;
  }
  EXPECT_LT(last, .9 * start);
}

TEST(Accurate, StacksOfTenAndTwentyStandSettleAndDoNotPenetrate) {
  for (const int n : {10, 20}) {
    for (const unsigned seed : {1U, 2U, 3U, 4U}) {
      const Stacked result = stack(n, 1, seed, 20);
      EXPECT_LT(std::abs(result.low), 1e-4) << n << " boxes, seed " << seed;
      EXPECT_LT(result.aside, .01) << n << " boxes, seed " << seed;
      EXPECT_LT(result.fastest, 1e-4) << n << " boxes, seed " << seed;
    }
  }
}

/// As far apart as they would be in a game, which makes them a web: one sways longer than a column if it sways.
World pyramid(int base, unsigned seed) {
  World world(accurate());
  std::mt19937 random(seed);
  ground(world, material(0, .6));
  for (int row = 0; row < base; ++row) {
    for (int i = 0; i < base - row; ++i) {
      const double x = 1.05 * (i + .5 * row) + seeded(random, -.002, .002);
      world.create_body(at(x, .5 + row), Shape::box(vec(.5, .5)), material(0, .6));
    }
  }
  return world;
}

double fastest_of(World& world) {
  double fastest = 0;
  for (const BodyId id : world.bodies()) {
    fastest = std::max(fastest, static_cast<double>(length(world.body(id).velocity())));
  }
  return fastest;
}

/// A pyramid of boxes of 1 m, on ground that leans by some degrees (gravity does), each row `apart` from the one below.
World leaning_pyramid(int base, double degrees, const Material& m, double apart) {
  Settings settings = accurate();
  const double a = degrees * static_cast<double>(pi) / 180;
  settings.gravity = vec(g * std::sin(a), -g * std::cos(a));
  World world(settings);
  ground(world, m);
  for (int row = 0; row < base; ++row) {
    for (int i = 0; i < base - row; ++i) {
      world.create_body(at(1.1 * (i + row / 2.), .5 + row + apart * (row + 1)), Shape::box(vec(.5, .5)), m);
    }
  }
  return world;
}

std::vector<Vec2> places(World& world) {
  std::vector<Vec2> places;
  for (const BodyId id : world.bodies()) places.push_back(world.body(id).position());
  return places;
}

double farthest_between(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, static_cast<double>(length(a[i] - b[i])));
  return most;
}

// Masses do not say how a box shares its load between the two below, so some contacts bear all of their static friction
// and stay where they are. Only one that moves has too little.
TEST(Accurate, HoldsPilesByStaticFrictionThatSlidingFrictionWouldNotBear) {
  for (const int base : {4, 6, 8}) {
    World world = leaning_pyramid(base, 13, {1, real(.35), real(.1), 0}, 0);
    const std::vector<Vec2> start = places(world);
    run_for(world, 4);
    EXPECT_LT(farthest_between(start, places(world)), .002) << base << " rows";
  }
}

// A point that bore nothing and is apart by rounding alone bears like the others.
TEST(Accurate, GapsOfRoundingDecideNothingInAPile) {
  for (const int base : {6, 8}) {
    std::vector<std::vector<Vec2>> ends;
    for (const double apart : {-1., 1.}) {
      World world = leaning_pyramid(base, 13, {1, real(.5), real(.5), 0}, apart * bound(1e-13, 5e-7));
      run_for(world, 1);
      ends.push_back(places(world));
    }
    EXPECT_LT(farthest_between(ends[0], ends[1]), bound(1e-11, 1e-5)) << base << " rows";
  }
}

TEST(Accurate, PyramidsOfTenAndTwentySettleAndDoNotPenetrate) {
  for (const int base : {10, 20}) {
    for (const unsigned seed : {1U, 2U}) {
      World world = pyramid(base, seed);
      run_for(world, 20);
      EXPECT_LT(fastest_of(world), 1e-4) << "base " << base << ", seed " << seed;
      const double top = world.body(world.bodies().back()).position().y;
      EXPECT_NEAR(top, base - .5, 1e-4) << "base " << base << ", seed " << seed;
    }
  }
}

// m, that is listed at the end of some steps.
double deepest_within(int steps, World& world) {
  double deepest = 0;
  for (int step = 0; step < steps; ++step) {
    world.step();
    for (const ContactInfo& contact : world.contacts())
      deepest = std::max(deepest, -static_cast<double>(contact.separation));
  }
  return deepest;
}

// The deepest overlap, m, of a wall of bricks in bond that falls by some millimetres.
double deepest_in_a_wall(int courses, int bricks, double width, double height, double gap, const Material& brick) {
  World world(accurate());
  ground(world, brick);
  const Shape shape = Shape::box(vec(width / 2, height / 2));
  for (int row = 0; row < courses; ++row) {
    for (int i = 0; i < bricks; ++i) {
      const double x = (width + .01) * (i + (row % 2 == 0 ? 0 : .5));
      world.create_body(at(x, (row + .5) * (height + gap) + gap / 2), shape, brick);
    }
  }
  return deepest_within(50, world);
}

// By 4 mm in four sub-steps, and by 3 with 30 sweeps for their first loads.
TEST(Accurate, PyramidsOfFortyRowsSinkNoDeeperThanStated) {
  World world = pyramid(40, 1);
  EXPECT_LT(deepest_within(120, world), .0005);
}

// The last brick of a course hangs over, so that one corner bears it and half of what stands on it.
TEST(Accurate, WallsSinkInNoDeeperThanStatedWhereTheirCornersBearMost) {
  EXPECT_LT(deepest_in_a_wall(10, 14, .979, .378, .0081, material(0, .15)), .0005);
  EXPECT_LT(deepest_in_a_wall(12, 14, .92, .17, .0098, material(.47, 1)), .0005);
}

// Bricks that have been listed before they meet, at .3 m/s: .85 mm where only new contacts counted as struck.
TEST(Accurate, WallsThatFallSinkInNoDeeperThanStated) {
  EXPECT_LT(deepest_in_a_wall(7, 14, .9966, .3443, .005, material(0, .6756)), .0005);
}

// Their boxes turn and roll over the ball: up to 5.2 mm where lanes kept normals and arms for whole steps.
TEST(Accurate, WallsThatABallKnocksDownSinkInNoDeeperThanStated) {
  for (const int rows : {31, 34}) {
    World world(accurate());
    const Material brick = material(0, .5);
    ground(world, brick);
    for (int row = 0; row < rows; ++row) {
      for (int i = 0; i < 3; ++i)
        world.create_body(at(.5 * i + .125 * (row % 2), .5 * row + .25), Shape::box(vec(.25, .25)), brick);
    }
    Material heavy = brick;
    heavy.density = 4;
    world.create_body(at(-2.5, rows / 4., 6), Shape::circle(1), heavy);
    EXPECT_LT(deepest_within(120, world), .0005) << rows;
  }
}

// The slowest wave of 80 layers (see OffsetRule::lifting) has W = 2.5 and c = .97/s, and starts with g / W as the
// pyramid sinks into its springs; offsets that follow faster than c keep it going.
TEST(Accurate, APyramidOfEightyRowsStopsOscillating) {
  constexpr double swing = 2.5;
  constexpr double damping = .97;
  World world = pyramid(80, 1);
  run_for(world, 8);
  double fastest = 0;
  for (int i = 0; i < 60; ++i) {
    world.step();
    fastest = std::max(fastest, fastest_of(world));
  }
  EXPECT_LT(fastest, g / swing * std::exp(-.75 * damping / 2 * 8));
}

// What bears is found for all masses at once: the lightest box may bear 20 000 times its weight, or 200 million times.
TEST(Accurate, HoldsTowersInWhichEachBoxIsHeavierThanTheOneBelow) {
  struct Tower {
    int boxes;
    double ratio;
  };
  for (const Tower& tower : {Tower{8, 4.1}, {4, 72}, {6, 46}}) {
    World world(falling());
    BodyDef ground;
    ground.type = BodyType::fixed;
    world.create_body(ground, Shape::half_space({0, 1}, 0));
    std::vector<BodyId> boxes;
    for (int k = 0; k < tower.boxes; ++k) {
      BodyDef def;
      def.position = {0, real(k + .5)};
      boxes.push_back(
          world.create_body(def, Shape::box({real(.5), real(.5)}), {.density = real(std::pow(tower.ratio, k))}));
    }
    for (int step = 0; step < 120; ++step) world.step();
    for (int k = 0; k < tower.boxes; ++k) {
      const Body box = world.body(boxes[static_cast<std::size_t>(k)]);
      EXPECT_NEAR(static_cast<double>(box.position().y), k + .5, 5e-6) << tower.ratio << ' ' << k;
      EXPECT_NEAR(static_cast<double>(box.angle()), 0, 5e-6) << tower.ratio << ' ' << k;
    }
  }
}

// What bears yields while joints hold others of the island; not so much that the light box gives way.
TEST(Accurate, HoldsAHeavyBoxFromWhichABobHangsOnALightOne) {
  World world(falling());
  ground(world, material(0, .5));
  const BodyId light = world.create_body(at(0, .5), Shape::box(vec(.5, .5)), material(0, .5));
  Material heavy = material(0, .5);
  heavy.density = 20000;
  const BodyId load = world.create_body(at(0, 1.5), Shape::box(vec(.5, .5)), heavy);
  const BodyId bob = world.create_body(at(1.5, 1.5), Shape::circle(real(.2)), material(0, .5));
  world.create_joint(RevoluteJoint{load, bob, vec(1, 1.5)});
  run_for(world, 2);
  EXPECT_NEAR(static_cast<double>(world.body(light).position().y), .5, 5e-6);
  EXPECT_NEAR(static_cast<double>(world.body(load).position().y), 1.5, 1e-5);
}

TEST(Accurate, StacksOfFiftyAndHeavyLoadsStand) {
  for (const unsigned seed : {1U, 2U}) {
    const Stacked tall = stack(50, 1, seed, 20);
    EXPECT_LT(std::abs(tall.low), 1e-3) << "seed " << seed;
    EXPECT_LT(tall.aside, .02) << "seed " << seed;
    const Stacked heavy = stack(2, 400, seed, 20);
    EXPECT_LT(std::abs(heavy.low), 1e-3) << "seed " << seed;
    EXPECT_LT(heavy.aside, .02) << "seed " << seed;
    const Stacked top = stack(11, 100, seed, 20);
    EXPECT_LT(std::abs(top.low), 1e-3) << "seed " << seed;
  }
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::accurate_piles_test
