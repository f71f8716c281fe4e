// Many bodies that fall: into a box with friction and without, into a pen where they keep bouncing, and onto hills.

#include <cmath>

#include "../benchmark_scene.h"
#include "scenarios/parts.h"
#include "scenarios/random.h"

namespace plumb::benchmarks::falling_bodies {
namespace {

// A floor and two walls of 100 m; `inside` is the distance between the walls, m.
void add_box(SceneSetup& setup, double inside, double floor, Surface of) {
  std::vector<Body>& bodies = setup.scene.bodies;
  bodies.push_back(fixed(box("floor", {0, -1}, {floor, 2}, of)));
  for (const double side : {-1, 1}) {
    bodies.push_back(fixed(box("wall", {side * (inside / 2 + 1), 50}, {2, 100}, of)));
  }
}

// Places in rows of that many columns, 1 m apart, from 1 m above the floor: room for any of the bodies at any angle.
Vec place_in_rows(int i, int columns) { return {i % columns - (columns - 1) / 2.0, 1.0 + i / columns}; }

// As in Plumb's own first measurements. (Box2D's benchmark of that name drops ragdolls.)
SceneSetup rain() {
  const Surface wood = surface(0.6, 0);
  SceneSetup setup{.size = 0.5, .center = {0, 25}, .reach = 60};
  add_box(setup, 56, 60, wood);
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const double across = random.between(0.5, 0.7);
    const Vec at = place_in_rows(i, 54);
    Body drop = i % 2 == 0 ? disc("disc", at, across / 2, wood) : box("box", at, {across, across}, wood);
    drop.angle = random.between(-1, 1);
    drop.velocity = {random.between(-1, 1), random.between(-1, 0)};
    setup.scene.bodies.push_back(drop);
  }
  return setup;
}

// Nothing turns, and every contact has only a normal constraint.
SceneSetup smooth_discs() {
  const Surface ice = surface(0, 0);
  SceneSetup setup{.size = 0.5, .center = {0, 25}, .reach = 60};
  add_box(setup, 56, 60, ice);
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    Body drop = disc("disc", place_in_rows(i, 54), random.between(0.25, 0.45), ice);
    drop.velocity = {random.between(-1, 1), random.between(-1, 0)};
    setup.scene.bodies.push_back(drop);
  }
  return setup;
}

// Without friction: measures impacts.
SceneSetup bouncing() {
  const Surface rubber = surface(0, 0.8);
  SceneSetup setup{.size = 0.7, .center = {0, 50}, .reach = 60};
  add_box(setup, 24, 40, rubber);
  Random random(2);
  for (int i = 0; i < 600; ++i) {
    const Vec at = place_in_rows(i, 24);
    Body one = i % 2 == 0 ? disc("disc", at, 0.4, rubber) : box("box", at, {0.7, 0.7}, rubber);
    one.angle = random.between(-1, 1);
    one.velocity = {random.between(-5, 5), random.between(-5, 5)};
    setup.scene.bodies.push_back(one);
  }
  return setup;
}

double hill_height(double x) { return 1.5 * std::sin(0.13 * x) + 0.8 * std::sin(0.41 * x + 1); }

// Bodies of two sizes, where the larger ones are many and at rest.
SceneSetup terrain() {
  constexpr int segments = 2000;
  constexpr int columns = 3600;
  constexpr double half = segments / 2.0;  // m; each segment is 1 m across
  const Surface rock = surface(0.5, 0);
  SceneSetup setup{.size = 0.2, .reach = half + 20};
  Body hills{.name = "hills", .type = BodyType::fixed};
  for (int i = 0; i < segments; ++i) {
    const double x = i - half;
    hills.shapes.push_back({.geometry = Segment{{x, hill_height(x)}, {x + 1, hill_height(x + 1)}}, .surface = rock});
  }
  setup.scene.bodies.push_back(hills);
  Random random(1);
  for (int i = 0; i < 4000; ++i) {
    const double across = random.between(0.2, 0.3);
    const Vec at{(i % columns + 0.5 - columns / 2.0) * 0.5, 3 + 0.5 * (i / columns)};
    Body stone = i % 2 == 0 ? disc("disc", at, across / 2, rock) : box("box", at, {across, across}, rock);
    stone.angle = random.between(-1, 1);
    stone.velocity = {random.between(-2, 2), random.between(-1, 0)};
    setup.scene.bodies.push_back(stone);
  }
  return setup;
}

const Catalog<BenchmarkScene>::Entry rain_entry{{.name = "rain",
                                                 .about = "1000 discs and 1000 boxes fall into a box and settle",
                                                 .settled = {900, 1100},
                                                 .moving = {60, 360},
                                                 .setup = rain}};

const Catalog<BenchmarkScene>::Entry smooth_entry{{.name = "smooth-discs",
                                                   .about = "2000 discs without friction fall into a box and settle",
                                                   .settled = {900, 1100},
                                                   .moving = {60, 360},
                                                   .setup = smooth_discs}};

const Catalog<BenchmarkScene>::Entry bouncing_entry{{.name = "bouncing",
                                                     .about = "600 discs and boxes of e = 0.8 in a pen",
                                                     .settled = {},
                                                     .moving = {0, 600},
                                                     .setup = bouncing}};

const Catalog<BenchmarkScene>::Entry terrain_entry{
    {.name = "terrain",
     .about = "4000 small discs and boxes come down on hills of 2000 segments",
     .settled = {},
     .moving = {60, 260},
     .setup = terrain}};

}  // namespace
}  // namespace plumb::benchmarks::falling_bodies
