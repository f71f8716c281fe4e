#include <algorithm>
#include <array>
#include <cmath>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"
#include "scenarios/scene/vec.h"

namespace plumb::kinds::rocking {
namespace {

// A block is let go leaning on one lower corner, by less than it takes to fall over, and rocks from corner to corner
// (Housner 1963).
Scene scene(Draw& draw) {
  Scene scene{.duration = draw.between(0.5, 2)};
  Surface of = draw.surface();
  if (draw.chance(0.7)) of.restitution = 0;
  if (draw.chance(0.7)) of.static_friction = of.dynamic_friction = 1;  // else it slides as well
  scene.bodies.push_back(level_ground(of));
  const double height = draw.over_magnitudes(0.2, 2);
  const double width = height * draw.over_magnitudes(0.1, 1);
  Body block = box("block", {}, {width, height}, of);
  const double falls = width / height;  // rad, at least: the arc tangent is less, by a fifth at most
  block.angle = draw.between(0.1, 0.7) * falls * (draw.chance(0.5) ? 1 : -1);
  double lowest = 0;
  for (const Vec corner : std::array{Vec{width / 2, -height / 2}, Vec{-width / 2, -height / 2}}) {
    lowest = std::min(lowest, rotated(corner, block.angle).y);
  }
  block.position.y = std::ceil(-lowest * 1e4) / 1e4;
  scene.bodies.push_back(block);
  return scene;
}

const Catalog<Kind>::Entry entry{{.name = "rocking", .about = "A block rocks from corner to corner.", .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::rocking
