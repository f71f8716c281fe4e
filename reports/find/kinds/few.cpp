#include <fmt/format.h>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"

namespace plumb::kinds::few {
namespace {

// A few bodies, often at the values at which laws change, fall on the ground and on each other. Something may be
// damped, or only something far away that touches nothing.
Scene scene(Draw& draw) {
  Scene scene{.duration = draw.between(0.5, 1.5)};
  Surface of = draw.surface();
  if (draw.chance(0.4)) of = {.density = 1};  // smooth and inelastic
  scene.bodies.push_back(draw.chance(0.5) ? level_ground(of) : fixed(box("ground", {0, -1}, {28, 2}, of)));
  const int count = draw.whole(1, 5);
  for (int i = 0, tries = 0; i < count && tries < 20 * count; ++tries) {
    const double size = draw.over_magnitudes(0.15, 0.8);
    Body body = draw.body(fmt::format("body {}", i + 1), {draw.between(-1, 1), size + draw.between(0, 4)}, size);
    if (draw.chance(0.7)) body.shapes[0].surface = of;
    if (draw.chance(0.3)) body.shapes[0].surface.density *= draw.over_magnitudes(0.1, 10);
    if (draw.chance(0.4)) body.velocity = draw.within(2, 2);
    if (draw.chance(0.5)) body.angular_velocity = draw.between(-5, 5);
    if (draw.chance(0.1)) body.linear_damping = draw.between(0, 1);
    if (add_apart(scene, body)) ++i;
  }
  if (draw.chance(0.2)) {
    scene.bodies.push_back(disc("far", {500, 100}, 0.5, {}));
    scene.bodies.back().linear_damping = draw.between(0.01, 1);
  }
  return scene;
}

const Catalog<Kind>::Entry entry{
    {.name = "few", .about = "A few bodies fall on the ground and on each other.", .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::few
