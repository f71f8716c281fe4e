#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"

namespace plumb::kinds::drop {
namespace {

// One body falls on another that rests on the ground, on a dome or on a shelf.
Scene scene(Draw& draw) {
  Scene scene{.duration = draw.between(0.5, 1.2)};
  const Surface of = draw.surface();
  const double size = draw.over_magnitudes(0.15, 0.8);
  scene.bodies.push_back(level_ground(of));
  Body below = draw.chance(0.5) ? disc("below", {0, size}, size, draw.surface())
                                : box("below", {0, size}, {2 * size, 2 * size}, draw.surface());
  if (draw.chance(0.25)) below.type = BodyType::fixed;
  scene.bodies.push_back(below);
  const double above = draw.over_magnitudes(0.1, 0.8);
  Body body = draw.body("above", {draw.between(-0.8, 0.8) * size, 2 * size + above + draw.between(0.01, 0.8)}, above);
  if (draw.chance(0.5)) body.shapes[0].surface.density *= draw.over_magnitudes(0.02, 50);
  if (draw.chance(0.3)) body.velocity = {draw.between(-2, 2), 0};
  scene.bodies.push_back(body);
  return scene;
}

const Catalog<Kind>::Entry entry{
    {.name = "drop", .about = "A body falls on one that rests or is fixed.", .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::drop
