#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"

namespace plumb::kinds::plane {
namespace {

// One body drops on, slides down or rolls along a plane.
Scene scene(Draw& draw) {
  Scene scene{.gravity = draw.gravity(), .duration = draw.between(0.5, 2)};
  if (scene.gravity == Vec{}) scene.gravity = {0, -standard_gravity};
  scene.bodies.push_back(level_ground(draw.surface()));
  const double size = draw.over_magnitudes(0.1, 1);
  Body body = draw.body("body", {0, size + draw.between(0.01, 1)}, size);
  if (draw.chance(0.6)) body.velocity = {draw.between(-4, 4), draw.between(-3, 1)};
  if (draw.chance(0.5)) body.angular_velocity = draw.between(-6, 6);
  scene.bodies.push_back(body);
  return scene;
}

const Catalog<Kind>::Entry entry{{.name = "plane", .about = "A body falls on a plane.", .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::plane
