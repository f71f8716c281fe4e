#include <fmt/format.h>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"
#include "scenarios/scene/vec.h"

namespace plumb::kinds::touching {
namespace {

// Bodies that touch exactly at the start, face to face, corner to corner or all around, moving or not.
Scene scene(Draw& draw) {
  Scene scene{.gravity = draw.gravity(), .duration = draw.between(0.3, 1)};
  const Surface of = draw.surface();
  const double size = draw.over_magnitudes(0.1, 0.5);
  const bool discs = draw.chance(0.5);
  const auto place = [&](Vec at) {
    const std::string name = fmt::format("body {}", scene.bodies.size() + 1);
    Body body = discs ? disc(name, at, size, of) : box(name, at, {2 * size, 2 * size}, of);
    if (draw.chance(0.4)) body.velocity = draw.within(2, 2);
    if (draw.chance(0.2)) body.angular_velocity = draw.between(-4, 4);
    scene.bodies.push_back(body);
  };
  place({});
  const int others = draw.whole(1, 3);
  for (int i = 0; i < others; ++i) {
    const Vec side = unit_at(0.25 * i);
    place(2 * size * side + (discs || draw.chance(0.5) ? Vec{} : Vec{2 * size * side.y, 2 * size * side.x}));
  }
  if (draw.chance(0.6)) scene.bodies.push_back(half_space("ground", {.offset = -size}, of));
  return scene;
}

const Catalog<Kind>::Entry entry{
    {.name = "touching", .about = "Bodies that touch at the start.", .posed = Posed::ambiguous, .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::touching
