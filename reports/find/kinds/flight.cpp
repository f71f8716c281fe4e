#include <fmt/format.h>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/vec.h"

namespace plumb::kinds::flight {
namespace {

// Bodies that fly and never touch: they share no layer. Springs or attraction between them.
Scene scene(Draw& draw) {
  Scene scene{.gravity = draw.gravity(), .duration = draw.between(0.5, 2)};
  const int count = draw.count(1, 12);
  for (int i = 0; i < count; ++i) {
    const double size = draw.over_magnitudes(0.1, 0.6);
    Body body = draw.body(fmt::format("body {}", i + 1), {1.5 * i, draw.between(-1, 1)}, size);
    body.layers = std::uint32_t{1} << i;
    body.velocity = draw.within(4, 4);
    if (draw.chance(0.6)) body.angular_velocity = draw.between(-6, 6);
    scene.bodies.push_back(body);
  }
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
    if (!draw.chance(0.4)) continue;
    scene.forces.push_back(Spring{.a = i - 1,
                                  .b = i,
                                  .anchor_a = draw.within(0.1, 0.1),
                                  .anchor_b = draw.within(0.1, 0.1),
                                  .stiffness = draw.over_magnitudes(0.1, 5),
                                  .length = draw.between(0.5, 2),
                                  .damping = draw.chance(0.6) ? 0 : draw.between(0, 0.5)});
  }
  if (count > 1 && draw.chance(0.3)) {
    scene.gravity = {};
    // k/r^2 bends a path within a step where k/r^3 > 3600/s^2: here below .05 m, which few bodies pass.
    const bool spring = draw.chance(0.5);  // k r
    scene.forces.push_back(Attraction{.from = 0,
                                      .strength = spring ? draw.between(1, 20) : draw.between(0.05, 0.5),
                                      .exponent = spring             ? -1.0
                                                  : draw.chance(0.7) ? 2.0
                                                                     : 1.0,
                                      .mutual = draw.chance(0.5)});
  }
  if (draw.chance(0.2)) {
    scene.forces.push_back(Constant{.body = 0, .force = draw.within(5, 5), .torque = draw.between(-1, 1)});
  }
  return scene;
}

const Catalog<Kind>::Entry entry{
    {.name = "flight", .about = "Bodies fly without touching, on springs or alone.", .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::flight
