#include <fmt/format.h>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"

namespace plumb::kinds::composite {
namespace {

// Bodies of several shapes, whose centre of mass is nobody's middle.
Scene scene(Draw& draw) {
  Scene scene{.gravity = draw.gravity(), .duration = draw.between(0.5, 1.5)};
  scene.bodies.push_back(level_ground(draw.surface()));
  const int count = draw.count(1, 12);
  for (int i = 0, tries = 0; i < count && tries < 20 * count; ++tries) {
    const double size = draw.over_magnitudes(0.1, 0.5);
    Body body{.name = fmt::format("body {}", i + 1),
              .position = {draw.between(-3, 3), 2.5 * size + draw.between(0.01, 0.5 + 0.2 * count)},
              .angle = draw.between(-3, 3),
              .velocity = draw.within(3, 3),
              .angular_velocity = draw.chance(0.5) ? draw.between(-5, 5) : 0};
    const int parts = draw.whole(2, 4);
    for (int part = 0; part < parts; ++part) {
      const Vec at = draw.within(size, size);
      const Surface of = draw.surface();
      if (draw.chance(0.5)) {
        body.shapes.push_back(
            {.geometry = Circle{.radius = size * draw.between(0.3, 0.8), .center = at}, .surface = of});
      } else {
        body.shapes.push_back({.geometry = Box{.size = {size, size * draw.between(0.3, 1)},
                                               .center = at,
                                               .angle = draw.chance(0.5) ? 0 : draw.between(-1.5, 1.5)},
                               .surface = of});
      }
    }
    if (add_apart(scene, body)) ++i;
  }
  return scene;
}

const Catalog<Kind>::Entry entry{
    {.name = "composite", .about = "Bodies of several shapes fall on a plane.", .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::composite
