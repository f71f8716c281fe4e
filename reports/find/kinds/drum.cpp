#include <fmt/format.h>

#include <algorithm>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"
#include "scenarios/scene/vec.h"

namespace plumb::kinds::drum {
namespace {

// Alike boxes in rows and columns, as near the middle as there is room for.
void stack(Draw& draw, double half, Scene& scene) {
  const Surface of = draw.surface();
  const double side = draw.between(0.15, 0.35);
  const double apart = side + draw.between(0.005, 0.08);
  const int rows = std::min(draw.whole(2, 6), static_cast<int>(2 * half / apart) - 1);
  for (int i = 0; i < rows * rows; ++i) {
    const int row = i / rows;
    const Vec at{(i % rows - (rows - 1) / 2.0) * apart, (row - (rows - 1) / 2.0) * apart};
    scene.bodies.push_back(box(fmt::format("body {}", i + 1), at, {side, side}, of));
  }
}

// Four walls, one kinematic body, turn about their middle and carry what is inside.
Scene scene(Draw& draw) {
  Scene scene{.gravity = draw.gravity(), .duration = draw.between(0.5, 1.5)};
  const Surface of = draw.surface();
  const double half = draw.between(0.8, 2);
  const double thick = 0.4;
  Body drum{.name = "drum", .type = BodyType::kinematic, .angular_velocity = draw.between(-3, 3)};
  for (const Vec side : {Vec{1, 0}, Vec{-1, 0}, Vec{0, 1}, Vec{0, -1}}) {
    const Vec size = side.x != 0 ? Vec{thick, 2 * half} : Vec{2 * half + 2 * thick, thick};
    drum.shapes.push_back({.geometry = Box{.size = size, .center = (half + thick / 2) * side}, .surface = of});
  }
  Scene inside;
  if (draw.chance(0.25)) stack(draw, half, inside);
  const int count = inside.bodies.empty() ? draw.count(1, 25) : 0;
  for (int i = 0, tries = 0; i < count && tries < 20 * count; ++tries) {
    const double size = draw.over_magnitudes(0.08, 0.3);
    Body body = draw.body(fmt::format("body {}", i + 1), draw.within(half - size - 0.02, half - size - 0.02), size);
    body.velocity = draw.within(1, 1);
    if (add_apart(inside, body)) ++i;
  }
  scene.bodies = inside.bodies;
  scene.bodies.insert(scene.bodies.begin(), drum);
  return scene;
}

const Catalog<Kind>::Entry entry{{.name = "drum", .about = "A turning drum carries bodies.", .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::drum
