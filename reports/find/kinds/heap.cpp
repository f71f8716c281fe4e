#include <fmt/format.h>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"

namespace plumb::kinds::heap {
namespace {

// Bodies of any shape fall into a pit.
Scene scene(Draw& draw) {
  Scene scene{.duration = draw.between(0.5, 1.5)};
  const int count = draw.count(2, most_bodies);
  const double width = draw.between(2, 4) + 0.05 * count;
  scene.bodies.push_back(pit(width, draw.surface()));
  double top = 1;
  for (int i = 0, tries = 0; i < count && tries < 20 * count; ++tries) {
    const double size = draw.over_magnitudes(0.1, 0.6);
    Body body = draw.body(fmt::format("body {}", i + 1),
                          {draw.between(-1, 1) * (width / 2 - size - 0.05), size + 0.05 + draw.between(0, top)}, size);
    body.velocity = draw.within(2, 2);
    if (draw.chance(0.3)) body.angular_velocity = draw.between(-5, 5);
    if (add_apart(scene, body))
      ++i;
    else
      top += 0.05;
  }
  return scene;
}

const Catalog<Kind>::Entry entry{{.name = "heap", .about = "Bodies fall into a pit.", .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::heap
