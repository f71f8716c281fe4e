#include <fmt/format.h>

#include "reports/find/kind.h"
#include "reports/vec.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"

namespace plumb::kinds::drum {
namespace {

// Four walls, one kinematic body, turn about their middle and carry what is inside.
Scene scene(Draw& draw) {
  Scene scene{.gravity = draw.gravity(), .duration = draw.between(0.5, 1.5)};
  const Surface of = draw.surface();
  const double half = draw.between(0.8, 2);
  const double thick = 0.4;
  Body drum{.name = "drum", .type = BodyType::kinematic, .angular_velocity = draw.between(-3, 3)};
  for (const Vec side : {Vec{1, 0}, Vec{-1, 0}, Vec{0, 1}, Vec{0, -1}}) {
    const Vec size = side.x != 0 ? Vec{thick, 2 * half} : Vec{2 * half + 2 * thick, thick};
    drum.shapes.push_back({.geometry = Box{.size = size, .center = (half + thick / 2) * side}, .surface = of});
  }
  const int count = draw.count(1, 25);
  Scene inside;
  for (int i = 0, tries = 0; i < count && tries < 20 * count; ++tries) {
    const double size = draw.over_magnitudes(0.08, 0.3);
    Body body = draw.body(fmt::format("body {}", i + 1), draw.within(half - size - 0.02, half - size - 0.02), size);
    body.velocity = draw.within(1, 1);
    if (add_apart(inside, body)) ++i;
  }
  scene.bodies = inside.bodies;
  scene.bodies.insert(scene.bodies.begin(), drum);
  return scene;
}

const Catalog<Kind>::Entry entry{{.name = "drum", .about = "A turning drum carries bodies.", .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::drum
