#include <fmt/format.h>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"

namespace plumb::kinds::overlapping {
namespace {

// A mistake in a game's level: a body far too large lies across rows of others, within walls that turn or stand.
Scene scene(Draw& draw) {
  Scene scene{.duration = draw.between(0.3, 1)};
  const Surface of = draw.surface();
  const double half = draw.between(0.8, 2);
  const double thick = 0.4;
  Body walls{.name = "walls", .type = BodyType::kinematic};
  if (draw.chance(0.7)) walls.angular_velocity = draw.between(-3, 3);
  for (const Vec side : {Vec{1, 0}, Vec{-1, 0}, Vec{0, 1}, Vec{0, -1}}) {
    const Vec size = side.x != 0 ? Vec{thick, 2 * half} : Vec{2 * half + 2 * thick, thick};
    walls.shapes.push_back(
        {.geometry = Box{.size = size, .center = {side.x * (half + thick / 2), side.y * (half + thick / 2)}},
         .surface = of});
  }
  scene.bodies.push_back(walls);
  const int rows = draw.whole(1, 5);
  const double apart = 2 * half / (rows + 1);
  const double side = apart * draw.between(0.5, 0.95);
  for (int i = 0; i < rows * rows; ++i) {
    const int row = i / rows;
    const Vec at{(i % rows - (rows - 1) / 2.0) * apart, (row - (rows - 1) / 2.0) * apart};
    scene.bodies.push_back(box(fmt::format("body {}", i + 1), at, {side, side}, of));
  }
  Body& large = scene.bodies[static_cast<std::size_t>(draw.whole(1, rows * rows))];
  const double factor = draw.over_magnitudes(2, 1000);
  large.shapes[0].geometry = Box{.size = {draw.chance(0.3) ? factor * side : side, factor * side}};
  return scene;
}

const Catalog<Kind>::Entry entry{{.name = "overlapping",
                                  .about = "A body far too large lies across others.",
                                  .posed = Posed::overlapping,
                                  .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::overlapping
