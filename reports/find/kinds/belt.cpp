#include <fmt/format.h>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"

namespace plumb::kinds::belt {
namespace {

// A kinematic slab moves under bodies, to a wall or up and down like a lift.
Scene scene(Draw& draw) {
  Scene scene{.duration = draw.between(0.5, 1.5)};
  const Surface of = draw.surface();
  Body belt = box("belt", {0, -0.25}, {40, 0.5}, of);
  belt.type = BodyType::kinematic;
  belt.velocity = draw.chance(0.75) ? Vec{draw.between(-4, 4), 0} : Vec{0, draw.between(-1.5, 1.5)};
  scene.bodies.push_back(belt);
  if (belt.velocity.y == 0 && draw.chance(0.4)) {
    const double side = belt.velocity.x < 0 ? -1 : 1;
    scene.bodies.push_back(fixed(box("wall", {side * 3, 1.02}, {0.5, 2}, of)));
  }
  const int count = draw.count(1, 10);
  for (int i = 0, tries = 0; i < count && tries < 20 * count; ++tries) {
    const double size = draw.over_magnitudes(0.1, 0.5);
    const Vec at{draw.between(-2, 2), 0};
    Body body =
        draw.chance(0.5) ? box("", at, {2 * size, 2 * size}, draw.surface()) : disc("", at, size, draw.surface());
    body.name = fmt::format("body {}", i + 1);
    body.position.y = size + (draw.chance(0.6) ? 0 : draw.between(0.01, 0.5));
    Scene others = scene;  // the belt is below, its bounding circle is not
    others.bodies.erase(others.bodies.begin());
    if (!add_apart(others, body)) continue;
    scene.bodies.push_back(body);
    ++i;
  }
  return scene;
}

const Catalog<Kind>::Entry entry{
    {.name = "belt", .about = "A slab moves under bodies, sideways or like a lift.", .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::belt
