#include "reports/find/kind.h"
#include "scenarios/catalog.h"

namespace plumb::kinds::pair {
namespace {

// Two bodies meet off-centre; nothing else is there, so momentum has nowhere to go.
Scene scene(Draw& draw) {
  Scene scene{.gravity = {}, .duration = 1};
  const double size = draw.over_magnitudes(0.1, 1);
  const double other_size = draw.chance(0.5) ? size : draw.over_magnitudes(0.1, 1);
  Body a = draw.body("a", {}, size);
  const double gap = draw.between(0.02, 0.5);
  Body b = draw.body("b", {size + other_size + gap, draw.between(-1, 1) * (size + other_size) * 0.8}, other_size);
  if (draw.chance(0.5)) b.shapes[0].surface.density *= draw.over_magnitudes(0.01, 100);
  a.velocity = {draw.between(0, 3), draw.between(-0.5, 0.5)};
  b.velocity = {-draw.between(0.5, 5), draw.between(-0.5, 0.5)};
  if (draw.chance(0.5)) a.angular_velocity = draw.between(-8, 8);
  if (draw.chance(0.5)) b.angular_velocity = draw.between(-8, 8);
  if (draw.chance(0.2)) {
    a.shapes[0].geometry = Circle{.radius = size};
    b.shapes[0].geometry = Circle{.radius = other_size};
    if (draw.chance(0.5)) a.shapes[0].surface.restitution = b.shapes[0].surface.restitution = 0;
  }
  scene.bodies = {a, b};
  return scene;
}

const Catalog<Kind>::Entry entry{{.name = "pair", .about = "Two free bodies of any mass ratio meet.", .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::pair
