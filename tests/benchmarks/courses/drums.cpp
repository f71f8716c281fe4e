// Box2D 3's benchmarks "tumbler" and "washer". Its tumbler is a heavy body turned by a motor; scenes know no motors, so
// here both drums are kinematic and turn at the same 25 degrees a second.

#include <cmath>
#include <numbers>

#include "../course.h"
#include "scenarios/parts.h"

namespace plumb::benchmarks {
namespace {

constexpr Vec hub{0, 10};  // m

Body turning(std::vector<Geometry> walls) {
  Body drum{.name = "drum", .type = BodyType::kinematic, .position = hub, .angular_velocity = 25 * degree};
  for (Geometry& wall : walls) drum.shapes.push_back({.geometry = std::move(wall), .surface = surface(0.6, 0)});
  return drum;
}

// A square of side x side boxes, the lowest and leftmost at `corner` from the hub.
void fill(Start& start, int side, double size, double pitch, double corner) {
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const Vec at{hub.x + corner + column * pitch, hub.y + corner + row * pitch};
      start.scene.bodies.push_back(box("box", at, {size, size}, surface(0.6, 0)));
    }
  }
}

// Four walls of 1 m x 20 m about a room of 19 m.
Start tumbler() {
  Start start{.size = 0.25, .center = hub, .reach = std::hypot(10.5, 10.5)};
  start.scene.bodies.push_back(
      turning({Box{{1, 20}, {10, 0}}, Box{{1, 20}, {-10, 0}}, Box{{20, 1}, {0, 10}}, Box{{20, 1}, {0, -10}}}));
  fill(start, 45, 0.25, 0.4, -9);
  return start;
}

// What lies between two radii and two angles, its curved sides straightened.
Polygon sector(double inner, double outer, double from, double to) {
  const auto at = [](double radius, double angle) { return Vec{radius * std::cos(angle), radius * std::sin(angle)}; };
  return {{at(inner, from), at(outer, from), at(outer, to), at(inner, to)}};
}

// 36 staves that overlap by a tenth, and four paddles.
Start washer() {
  constexpr double stave = 10 * degree;
  std::vector<Geometry> walls;
  for (int i = 0; i < 36; ++i) {
    walls.emplace_back(sector(16, 18, (i - 0.1) * stave, (i + 1.1) * stave));
    if (i % 9 == 0) walls.emplace_back(sector(14, 16, i * stave, (i + 1) * stave));
  }
  Start start{.size = 0.2, .center = hub, .reach = 18};
  start.scene.bodies.push_back(turning(walls));
  fill(start, 90, 0.2, 0.21, -9.9);
  return start;
}

const Catalog<Course>::Entry tumbled{{.name = "tumbler",
                                      .about = "2025 boxes in a square drum that turns",
                                      .settled = {},
                                      .moving = {200, 500},
                                      .start = tumbler}};

const Catalog<Course>::Entry washed{{.name = "washer",
                                     .about = "8100 boxes in a round drum with paddles",
                                     .settled = {},
                                     .moving = {150, 190},
                                     .start = washer}};

}  // namespace
}  // namespace plumb::benchmarks
