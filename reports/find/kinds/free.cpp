#include <fmt/format.h>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"

// Bodies that nothing carries.
namespace plumb::kinds::free {
namespace {

// Off-centre, with nothing else there, so momentum has nowhere to go.
Scene pair(Draw& draw) {
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

// They share no layer. Springs or attraction between them.
Scene flight(Draw& draw) {
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

// Something that moves many times its size in a step.
Scene fast(Draw& draw) {
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

const Catalog<Kind>::Entry of_pair{{.name = "pair", .about = "Two free bodies of any mass ratio meet.", .scene = pair}};
const Catalog<Kind>::Entry of_flight{
    {.name = "flight", .about = "Bodies fly without touching, on springs or alone.", .scene = flight}};
const Catalog<Kind>::Entry of_fast{{.name = "fast", .about = "A fast body meets a wall or another.", .scene = fast}};

}  // namespace
}  // namespace plumb::kinds::free
