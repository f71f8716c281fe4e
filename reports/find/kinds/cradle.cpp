#include <fmt/format.h>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"

namespace plumb::kinds::cradle {
namespace {

// A row of touching bodies is hit at its end: several impacts at one moment, of which mechanics gives only the sums.
Scene scene(Draw& draw) {
  Scene scene{.gravity = {}, .duration = 0.5};
  const Surface of = draw.surface();
  const double size = draw.over_magnitudes(0.1, 0.5);
  const int row = draw.whole(2, 8);
  const bool boxes = draw.chance(0.4);
  for (int i = 0; i <= row; ++i) {
    const Vec at{2 * size * i + (i == 0 ? -draw.between(0.05, 0.4) : 0), 0};
    Body body = boxes ? box("", at, {2 * size, 2 * size}, of) : disc("", at, size, of);
    body.name = fmt::format("body {}", i + 1);
    if (i == 0) body.velocity = {draw.between(1, 6), 0};
    if (draw.chance(0.2)) body.shapes[0].surface.density *= draw.over_magnitudes(0.1, 10);
    scene.bodies.push_back(body);
  }
  return scene;
}

const Catalog<Kind>::Entry entry{{.name = "cradle",
                                  .about = "A row of touching bodies is hit at its end.",
                                  .posed = Posed::ambiguous,
                                  .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::cradle
