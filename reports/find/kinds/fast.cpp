#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"

namespace plumb::kinds::fast {
namespace {

// Something that moves many times its size in a step meets a wall or a body.
Scene scene(Draw& draw) {
  Scene scene{.gravity = {}, .duration = draw.between(0.2, 0.6)};
  const double size = draw.over_magnitudes(0.05, 0.3);
  Body shot = draw.body("shot", {}, size);
  shot.velocity = {draw.over_magnitudes(10, 100), draw.between(-3, 3)};
  shot.bullet = draw.chance(0.5);
  if (draw.chance(0.3)) shot.angular_velocity = draw.between(-30, 30);
  scene.bodies.push_back(shot);
  const double distance = draw.between(1, 4);
  if (draw.chance(0.7)) {
    const double thickness = draw.over_magnitudes(0.02, 0.5);
    scene.bodies.push_back(fixed(box("wall", {distance + 1, 0}, {thickness, 8}, draw.surface())));
  }
  if (draw.chance(0.5)) {
    const double other = draw.over_magnitudes(0.1, 0.5);
    scene.bodies.push_back(draw.body("target", {distance, draw.between(-0.8, 0.8) * (size + other)}, other));
    scene.bodies.back().velocity = draw.within(0, 5);
    scene.bodies.back().bullet = shot.bullet;
  }
  return scene;
}

const Catalog<Kind>::Entry entry{{.name = "fast", .about = "A fast body meets a wall or another.", .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::fast
