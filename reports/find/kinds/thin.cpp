#include <fmt/format.h>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"

namespace plumb::kinds::thin {
namespace {

// Rods and needles, and bodies a few centimetres or millimetres small, on a plane.
Scene scene(Draw& draw) {
  Scene scene{.duration = draw.between(0.3, 1)};
  scene.bodies.push_back(level_ground(draw.surface()));
  const int count = draw.count(1, 8);
  for (int i = 0, tries = 0; i < count && tries < 20 * count; ++tries) {
    const bool tiny = draw.chance(0.4);
    const double size = tiny ? draw.over_magnitudes(0.004, 0.06) : draw.between(0.3, 1);
    Body body = draw.body(fmt::format("body {}", i + 1),
                          {draw.between(-2, 2), size + 0.02 + draw.between(0, tiny ? 0.2 : 1.5)}, size);
    const double thickness = 2 * size * draw.over_magnitudes(0.01, 0.1);
    if (!tiny) {
      if (draw.chance(0.5)) {
        body.shapes[0].geometry = Box{.size = {2 * size, thickness}};
      } else {
        body.shapes[0].geometry =
            Capsule{.from = {-size + thickness, 0}, .to = {size - thickness, 0}, .radius = thickness / 2};
      }
    }
    body.velocity = tiny ? draw.within(0.5, 0.5) : draw.within(2, 2);
    if (draw.chance(0.4)) body.angular_velocity = draw.between(-4, 4);
    if (add_apart(scene, body)) ++i;
  }
  return scene;
}

const Catalog<Kind>::Entry entry{{.name = "thin", .about = "Rods and tiny bodies fall on a plane.", .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::thin
