#include <fmt/format.h>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"

namespace plumb::kinds::wall {
namespace {

// Bricks in bond, each over two below; something may be thrown at them.
Scene scene(Draw& draw) {
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

const Catalog<Kind>::Entry entry{
    {.name = "wall", .about = "Bricks in bond, at which a ball may be thrown.", .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::wall
