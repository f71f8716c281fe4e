#include <algorithm>
#include <array>
#include <cmath>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"
#include "scenarios/scene/vec.h"

// A few bodies on the ground, or on something fixed.
namespace plumb::kinds::ground {
namespace {

// One body drops on, slides down or rolls along a plane.
Scene plane(Draw& draw) {
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

// Often at the values at which laws change. Something may be damped, or only something far away that touches nothing.
Scene few(Draw& draw) {
  Scene scene{.duration = draw.between(0.5, 1.5)};
  Surface of = draw.surface();
  if (draw.chance(0.4)) of = {.density = 1};  // smooth and inelastic
  scene.bodies.push_back(draw.chance(0.5) ? level_ground(of) : fixed(box("ground", {0, -1}, {28, 2}, of)));
  scatter(scene, draw.whole(1, 5), [&](std::string name) {
    const double size = draw.over_magnitudes(0.15, 0.8);
    Body body = draw.body(std::move(name), {draw.between(-1, 1), size + draw.between(0, 4)}, size);
    if (draw.chance(0.7)) body.shapes[0].surface = of;
    if (draw.chance(0.3)) body.shapes[0].surface.density *= draw.over_magnitudes(0.1, 10);
    if (draw.chance(0.4)) body.velocity = draw.within(2, 2);
    if (draw.chance(0.5)) body.angular_velocity = draw.between(-5, 5);
    if (draw.chance(0.1)) body.linear_damping = draw.between(0, 1);
    return body;
  });
  if (draw.chance(0.2)) {
    scene.bodies.push_back(disc("far", {500, 100}, 0.5, {}));
    scene.bodies.back().linear_damping = draw.between(0.01, 1);
  }
  return scene;
}

Scene drop(Draw& draw) {
  Scene scene{.duration = draw.between(0.5, 1.2)};
  const Surface of = draw.surface();
  const double size = draw.over_magnitudes(0.15, 0.8);
  scene.bodies.push_back(level_ground(of));
  Body below = draw.chance(0.5) ? disc("below", {0, size}, size, draw.surface())
                                : box("below", {0, size}, {2 * size, 2 * size}, draw.surface());
  if (draw.chance(0.25)) below.type = BodyType::fixed;
  scene.bodies.push_back(below);
  const double above = draw.over_magnitudes(0.1, 0.8);
  Body body = draw.body("above", {draw.between(-0.8, 0.8) * size, 2 * size + above + draw.between(0.01, 0.8)}, above);
  if (draw.chance(0.5)) body.shapes[0].surface.density *= draw.over_magnitudes(0.02, 50);
  if (draw.chance(0.3)) body.velocity = {draw.between(-2, 2), 0};
  scene.bodies.push_back(body);
  return scene;
}

// Rods and needles, and bodies a few centimetres or millimetres small.
Scene thin(Draw& draw) {
  Scene scene{.duration = draw.between(0.3, 1)};
  scene.bodies.push_back(level_ground(draw.surface()));
  scatter(scene, draw.count(1, 8), [&](std::string name) {
    const bool tiny = draw.chance(0.4);
    const double size = tiny ? draw.over_magnitudes(0.004, 0.06) : draw.between(0.3, 1);
    const Vec at{draw.between(-2, 2), size + 0.02 + draw.between(0, tiny ? 0.2 : 1.5)};
    Body body = draw.body(std::move(name), at, size);
    const double thickness = 2 * size * draw.over_magnitudes(0.01, 0.1);
    if (!tiny) {
      if (draw.chance(0.5)) {
        body.shapes[0].geometry = Box{.size = {2 * size, thickness}};
      } else {
        body.shapes[0].geometry =
            Capsule{.from = {-size + thickness, 0}, .to = {size - thickness, 0}, .radius = thickness / 2};
      }
    }
    body.velocity = tiny ? draw.within(0.5, 0.5) : draw.within(2, 2);
    if (draw.chance(0.4)) body.angular_velocity = draw.between(-4, 4);
    return body;
  });
  return scene;
}

// The centre of mass is nobody's middle.
Scene composite(Draw& draw) {
  Scene scene{.gravity = draw.gravity(), .duration = draw.between(0.5, 1.5)};
  scene.bodies.push_back(level_ground(draw.surface()));
  const int count = draw.count(1, 12);
  scatter(scene, count, [&](std::string name) {
    const double size = draw.over_magnitudes(0.1, 0.5);
    Body body{.name = std::move(name),
              .position = {draw.between(-3, 3), 2.5 * size + draw.between(0.01, 0.5 + 0.2 * count)},
              .angle = draw.between(-3, 3),
              .velocity = draw.within(3, 3),
              .angular_velocity = draw.chance(0.5) ? draw.between(-5, 5) : 0};
    const int parts = draw.whole(2, 4);
    for (int part = 0; part < parts; ++part) {
      const Vec at = draw.within(size, size);
      const Surface of = draw.surface();
      if (draw.chance(0.5)) {
        body.shapes.push_back(
            {.geometry = Circle{.radius = size * draw.between(0.3, 0.8), .center = at}, .surface = of});
      } else {
        body.shapes.push_back({.geometry = Box{.size = {size, size * draw.between(0.3, 1)},
                                               .center = at,
                                               .angle = draw.chance(0.5) ? 0 : draw.between(-1.5, 1.5)},
                               .surface = of});
      }
    }
    return body;
  });
  return scene;
}

// Near the top of a fixed disc, until it leaves it.
Scene dome(Draw& draw) {
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

// Let go leaning on one lower corner, by less than it takes to fall over (Housner 1963).
Scene rocking(Draw& draw) {
  Scene scene{.duration = draw.between(0.5, 2)};
  Surface of = draw.surface();
  if (draw.chance(0.7)) of.restitution = 0;
  if (draw.chance(0.7)) of.static_friction = of.dynamic_friction = 1;  // else it slides as well
  scene.bodies.push_back(level_ground(of));
  const double height = draw.over_magnitudes(0.2, 2);
  const double width = height * draw.over_magnitudes(0.1, 1);
  Body block = box("block", {}, {width, height}, of);
  const double falls = width / height;  // rad, at least: the arc tangent is less, by a fifth at most
  block.angle = draw.between(0.1, 0.7) * falls * (draw.chance(0.5) ? 1 : -1);
  double lowest = 0;
  for (const Vec corner : std::array{Vec{width / 2, -height / 2}, Vec{-width / 2, -height / 2}}) {
    lowest = std::min(lowest, rotated(corner, block.angle).y);
  }
  block.position.y = std::ceil(-lowest * 1e4) / 1e4;
  scene.bodies.push_back(block);
  return scene;
}

const Catalog<Kind>::Entry of_plane{{.name = "plane", .about = "A body falls on a plane.", .scene = plane}};
const Catalog<Kind>::Entry of_few{
    {.name = "few", .about = "A few bodies fall on the ground and on each other.", .scene = few}};
const Catalog<Kind>::Entry of_drop{
    {.name = "drop", .about = "A body falls on one that rests or is fixed.", .scene = drop}};
const Catalog<Kind>::Entry of_thin{{.name = "thin", .about = "Rods and tiny bodies fall on a plane.", .scene = thin}};
const Catalog<Kind>::Entry of_composite{
    {.name = "composite", .about = "Bodies of several shapes fall on a plane.", .scene = composite}};
const Catalog<Kind>::Entry of_dome{{.name = "dome", .about = "A disc slides or rolls off a fixed one.", .scene = dome}};
const Catalog<Kind>::Entry of_rocking{
    {.name = "rocking", .about = "A block rocks from corner to corner.", .scene = rocking}};

}  // namespace
}  // namespace plumb::kinds::ground
