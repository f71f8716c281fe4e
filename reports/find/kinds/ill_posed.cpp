#include <fmt/format.h>

#include <algorithm>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"
#include "scenarios/scene/vec.h"

// Scenes of which mechanics tells less than the motion.
namespace plumb::kinds::ill_posed {
namespace {

// Several impacts at one moment, of which mechanics gives only the sums.
Scene cradle(Draw& draw) {
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

// Exactly, face to face, corner to corner or all around, moving or not.
Scene touching(Draw& draw) {
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
  double lowest = 0;
  for (int i = 0; i < others; ++i) {
    const Vec side = unit_at(0.25 * i);
    const Vec beside{-side.y, side.x};
    place(2 * size * side + (discs || draw.chance(0.5) ? Vec{} : 2 * size * beside));
    lowest = std::min(lowest, scene.bodies.back().position.y);
  }
  if (draw.chance(0.6)) scene.bodies.push_back(half_space("ground", {.offset = lowest - size}, of));
  return scene;
}

// The ground is so rough that rigidity and Coulomb's friction contradict each other (see
// scenarios/friction/painleve_rod.cpp).
Scene painleve(Draw& draw) {
  Scene scene{.duration = 1};
  const Surface rough = surface(draw.between(1.4, 5), 0);
  scene.bodies.push_back(level_ground(rough));
  const Vec size{draw.between(1, 2), 0.02};
  Body rod = box("rod", {0, size.x / 2 + size.y}, size, rough);
  rod.angle = -draw.between(0.7, 1.2);
  rod.velocity = {draw.between(2, 10), -draw.between(0, 2)};
  scene.bodies.push_back(rod);
  return scene;
}

const Catalog<Kind>::Entry of_cradle{{.name = "cradle",
                                      .about = "A row of touching bodies is hit at its end.",
                                      .posed = Posed::ambiguous,
                                      .scene = cradle}};
const Catalog<Kind>::Entry of_touching{
    {.name = "touching", .about = "Bodies that touch at the start.", .posed = Posed::ambiguous, .scene = touching}};
const Catalog<Kind>::Entry of_painleve{{.name = "painleve",
                                        .about = "A rod slides over rough ground with its foot in front.",
                                        .posed = Posed::impossible,
                                        .scene = painleve}};

}  // namespace
}  // namespace plumb::kinds::ill_posed
