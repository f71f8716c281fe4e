#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"
#include "scenarios/scene/vec.h"

namespace plumb::kinds::dome {
namespace {

// A disc on a fixed one, near its top: it slides or rolls down until it leaves it.
Scene scene(Draw& draw) {
  Scene scene{.duration = draw.between(0.5, 1.5)};
  Surface of = draw.surface();
  if (draw.chance(0.5)) of.static_friction = of.dynamic_friction = 0;
  const double radius = draw.over_magnitudes(0.5, 4);
  const double size = draw.over_magnitudes(0.1, 0.8);
  scene.bodies.push_back(fixed(disc("dome", {}, radius, of)));
  const Vec up = unit_at(0.25 + draw.between(-0.1, 0.1));
  const double gap = draw.chance(0.5) ? 0 : draw.between(0, 0.05);
  Body body = disc("disc", (radius + size + gap) * up, size, of);
  const Vec along{-up.y, up.x};
  if (draw.chance(0.5)) body.velocity = draw.between(-2, 2) * along;
  if (draw.chance(0.2)) body.angular_velocity = draw.between(-5, 5);
  scene.bodies.push_back(body);
  return scene;
}

const Catalog<Kind>::Entry entry{{.name = "dome", .about = "A disc slides or rolls off a fixed one.", .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::dome
