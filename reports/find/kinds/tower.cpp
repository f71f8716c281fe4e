#include <fmt/format.h>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"

namespace plumb::kinds::tower {
namespace {

// Boxes on top of each other, each centre above the one below, so that it stands unless something pushes it.
Scene scene(Draw& draw) {
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

const Catalog<Kind>::Entry entry{{.name = "tower", .about = "Boxes stand on each other.", .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::tower
