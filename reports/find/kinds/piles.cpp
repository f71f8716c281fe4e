#include <fmt/format.h>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"

// Many bodies on each other.
namespace plumb::kinds::piles {
namespace {

// Boxes, each centre above the one below, so that it stands unless something pushes it.
Scene tower(Draw& draw) {
  Scene scene{.duration = 1};
  const Surface common = draw.surface();
  scene.bodies.push_back(level_ground(common));
  const int floors = draw.count(1, 20);
  const double gap = draw.chance(0.5) ? 0 : draw.between(0.001, 0.05);
  const bool alike = draw.chance(0.4);
  double top = 0;
  double width = draw.over_magnitudes(0.2, 1.5);
  for (int i = 0; i < floors; ++i) {
    if (!alike) width = draw.over_magnitudes(0.2, 1.5);
    const double height = alike ? width : draw.over_magnitudes(0.1, 1);
    Surface of = common;
    if (draw.chance(0.3)) of.density *= draw.over_magnitudes(0.1, 10);
    const double x = alike ? 0 : draw.between(-0.05, 0.05);
    scene.bodies.push_back(box(fmt::format("box {}", i + 1), {x, top + gap + height / 2}, {width, height}, of));
    top += gap + height;
  }
  if (draw.chance(0.3)) scene.bodies.back().velocity = {draw.between(-2, 2), 0};
  return scene;
}

// Bricks, each over two below; something may be thrown at them.
Scene wall(Draw& draw) {
  Scene scene{.duration = draw.between(0.3, 1)};
  const Surface of = draw.surface();
  scene.bodies.push_back(level_ground(of));
  const int across = draw.count(1, 14);
  const int rows = draw.count(1, 14);
  const double width = draw.between(0.3, 1);
  const double height = draw.between(0.15, 0.5);
  const double gap = draw.chance(0.5) ? 0 : draw.between(0.001, 0.01);
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < across; ++i) {
      const double x = (width + 0.01) * (i + 0.5 * (row % 2));
      scene.bodies.push_back(box(fmt::format("brick {}-{}", row + 1, i + 1),
                                 {x, gap + height / 2 + row * (height + gap)}, {width, height}, of));
    }
  }
  if (draw.chance(0.5)) {
    Body ball = disc("ball", {-1.5, draw.between(0.3, 1.5)}, 0.25, of);
    ball.velocity = {draw.between(2, 10), draw.between(-1, 2)};
    scene.bodies.push_back(ball);
  }
  return scene;
}

// Bodies of any shape; where there is no room for one, the next starts higher.
Scene heap(Draw& draw) {
  Scene scene{.duration = draw.between(0.5, 1.5)};
  const int count = draw.count(2, most_bodies);
  const double width = draw.between(2, 4) + 0.05 * count;
  scene.bodies.push_back(pit(width, draw.surface()));
  double top = 1;
  std::size_t there = 0;
  scatter(scene, count, [&](std::string name) {
    if (scene.bodies.size() == there) top += 0.05;
    there = scene.bodies.size();
    const double size = draw.over_magnitudes(0.1, 0.6);
    const Vec at{draw.between(-1, 1) * (width / 2 - size - 0.05), size + 0.05 + draw.between(0, top)};
    Body body = draw.body(std::move(name), at, size);
    body.velocity = draw.within(2, 2);
    if (draw.chance(0.3)) body.angular_velocity = draw.between(-5, 5);
    return body;
  });
  return scene;
}

const Catalog<Kind>::Entry of_tower{{.name = "tower", .about = "Boxes stand on each other.", .scene = tower}};
const Catalog<Kind>::Entry of_wall{
    {.name = "wall", .about = "Bricks in bond, at which a ball may be thrown.", .scene = wall}};
const Catalog<Kind>::Entry of_heap{{.name = "heap", .about = "Bodies fall into a pit.", .scene = heap}};

}  // namespace
}  // namespace plumb::kinds::piles
