// Benchmarks of Box2D 3: "tumbler", "washer", "joint_grid" and "smash".

#include <cmath>
#include <cstdlib>
#include <utility>

#include "../benchmark_scene.h"
#include "scenarios/parts.h"

namespace plumb::benchmarks::box2d_benchmarks {
namespace {

// Both drums are kinematic and turn at 25 degrees a second. (Box2D's tumbler is a heavy body with a motor; scenes have
// no motors.)
constexpr Vec hub{0, 10};  // m

Body turning_drum(std::vector<Geometry> walls) {
  Body drum{.name = "drum", .type = BodyType::kinematic, .position = hub, .angular_velocity = 25 * degree};
  for (Geometry& wall : walls) drum.shapes.push_back({.geometry = std::move(wall), .surface = surface(0.6, 0)});
  return drum;
}

// Adds side x side boxes in a square whose lower left box is at (corner, corner) from the hub, m.
void fill(SceneSetup& setup, int side, double size, double pitch, double corner) {
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const Vec at{hub.x + corner + column * pitch, hub.y + corner + row * pitch};
      setup.scene.bodies.push_back(box("box", at, {size, size}, surface(0.6, 0)));
    }
  }
}

// Four walls of 1 m x 20 m around a square of 19 m.
SceneSetup tumbler() {
  SceneSetup setup{.size = 0.25, .center = hub, .reach = std::hypot(10.5, 10.5)};
  setup.scene.bodies.push_back(
      turning_drum({Box{{1, 20}, {10, 0}}, Box{{1, 20}, {-10, 0}}, Box{{20, 1}, {0, 10}}, Box{{20, 1}, {0, -10}}}));
  fill(setup, 45, 0.25, 0.4, -9);
  return setup;
}

// The area between two radii and two angles, with straight sides.
Polygon sector(double inner, double outer, double from, double to) {
  const auto at = [](double radius, double angle) { return Vec{radius * std::cos(angle), radius * std::sin(angle)}; };
  return {{at(inner, from), at(outer, from), at(outer, to), at(inner, to)}};
}

// 36 staves that overlap by a tenth, and four paddles.
SceneSetup washer() {
  constexpr double stave = 10 * degree;
  std::vector<Geometry> walls;
  for (int i = 0; i < 36; ++i) {
    walls.emplace_back(sector(16, 18, (i - 0.1) * stave, (i + 1.1) * stave));
    if (i % 9 == 0) walls.emplace_back(sector(14, 16, i * stave, (i + 1) * stave));
  }
  SceneSetup setup{.size = 0.2, .center = hub, .reach = 18};
  setup.scene.bodies.push_back(turning_drum(walls));
  fill(setup, 90, 0.2, 0.21, -9.9);
  return setup;
}

// A net of discs, each hinged to its neighbours half-way between them, that hangs from seven discs in the middle of its
// upper edge. Discs do not collide. (In Box2D the seven are also hinged to each other, which holds nothing, and which
// not every engine can solve.)
SceneSetup joint_grid() {
  constexpr int side = 100;
  SceneSetup setup{.size = 0.8};
  std::vector<Body>& bodies = setup.scene.bodies;
  for (int column = 0; column < side; ++column) {
    for (int row = 0; row < side; ++row) {
      const std::size_t here = bodies.size();
      const double x = column;
      const double y = -row;
      Body knot = disc("knot", {x, y}, 0.4, surface(0.6, 0));
      knot.layers = 0;
      const bool held = row == 0 && std::abs(column - side / 2) <= 3;
      bodies.push_back(held ? fixed(knot) : knot);
      if (row > 0) setup.scene.joints.push_back(Revolute{.a = here - 1, .b = here, .anchor = {x, y + 0.5}});
      const bool between_held = held && bodies[here - side].type == BodyType::fixed;
      if (column > 0 && !between_held)
        setup.scene.joints.push_back(Revolute{.a = here - side, .b = here, .anchor = {x - 0.5, y}});
    }
  }
  return setup;
}

// Without gravity, a heavy box flies into a wall of small ones. In Box2D the wall sleeps until it is hit; here nothing
// sleeps.
SceneSetup smash() {
  constexpr double across = 0.4;  // m, of a small box, and from one to the next
  SceneSetup setup{.size = across};
  setup.scene.gravity = {0, 0};
  Body big = box("big", {-20, 0}, {8, 8}, surface(0.6, 0, 8));
  big.velocity = {40, 0};
  setup.scene.bodies.push_back(big);
  for (int column = 0; column < 120; ++column) {
    for (int row = 0; row < 80; ++row) {
      const Vec at{30 + column * across, (row - 40) * across};
      setup.scene.bodies.push_back(box("small", at, {across, across}, surface(0.6, 0)));
    }
  }
  return setup;
}

const Catalog<BenchmarkScene>::Entry tumbled{{.name = "tumbler",
                                              .about = "2025 boxes in a square drum that turns",
                                              .settled = {},
                                              .moving = {200, 500},
                                              .setup = tumbler}};

const Catalog<BenchmarkScene>::Entry washed{{.name = "washer",
                                             .about = "8100 boxes in a round drum with paddles",
                                             .settled = {},
                                             .moving = {150, 190},
                                             .setup = washer}};

const Catalog<BenchmarkScene>::Entry hung{{.name = "joint-grid",
                                           .about = "10 000 discs hinged to their neighbours",
                                           .settled = {},
                                           .moving = {60, 120},
                                           .setup = joint_grid}};

// The wall is hit in the 69th step.
const Catalog<BenchmarkScene>::Entry smashed{{.name = "smash",
                                              .about = "9600 boxes at rest are hit by a heavy one",
                                              .settled = {},
                                              .moving = {60, 300},
                                              .setup = smash}};

}  // namespace
}  // namespace plumb::benchmarks::box2d_benchmarks
