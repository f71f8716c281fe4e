#include <fmt/format.h>

#include <array>
#include <cmath>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"
#include "scenarios/scene/vec.h"

// Motions that textbooks solve, so that their closed forms may judge, and be judged.
namespace plumb::kinds::textbook {
namespace {

Scene orbit(Draw& draw) {
  Scene scene{.gravity = {}, .duration = draw.between(0.5, 2)};
  scene.bodies.push_back({.name = "sun", .type = BodyType::fixed, .layers = 1});
  const double distance = draw.over_magnitudes(0.5, 4);
  const Vec out = draw.direction();
  Body planet = draw.body("planet", distance * out, 0.1);
  planet.layers = 2;
  const double strength = draw.over_magnitudes(1, 30);
  // Below the speed of escape, sqrt(2 k/r).
  const double speed = draw.between(0.5, 1.3) * std::sqrt(strength / distance);
  planet.velocity = speed * Vec{-out.y, out.x} + draw.between(-0.3, 0.3) * speed * out;
  scene.bodies.push_back(planet);
  scene.forces.push_back(Attraction{.from = 0, .strength = strength});
  return scene;
}

Scene pendulum(Draw& draw) {
  Scene scene{.gravity = draw.gravity(), .duration = draw.between(0.5, 2)};
  scene.bodies.push_back({.name = "pivot", .type = BodyType::fixed, .layers = 1});
  Body bob = draw.body("bob", draw.over_magnitudes(0.3, 2) * draw.direction(), draw.over_magnitudes(0.1, 0.5));
  bob.layers = 2;
  scene.bodies.push_back(bob);
  scene.joints.push_back(Revolute{.a = 0, .b = 1});
  return scene;
}

Scene oscillator(Draw& draw) {
  Scene scene{.gravity = {}, .duration = draw.between(0.5, 2)};
  const Vec out = draw.direction();
  const double length = draw.between(0.5, 2);
  Body body = draw.body("body", draw.between(0.6, 1.4) * length * out, draw.over_magnitudes(0.1, 0.4));
  body.velocity = draw.between(-0.5, 0.5) * out;
  scene.bodies.push_back(body);
  scene.forces.push_back(Spring{.b = 0,
                                .stiffness = draw.over_magnitudes(0.5, 20),
                                .length = length,
                                .damping = draw.chance(0.5) ? 0 : draw.between(0, 0.2)});
  return scene;
}

// Discs along a line, between walls or not.
Scene row(Draw& draw) {
  Scene scene{.gravity = {}, .duration = draw.between(0.5, 2)};
  Surface of = draw.surface();
  of.static_friction = of.dynamic_friction = 0;
  const bool walls = draw.chance(0.4);
  if (walls) scene.bodies.push_back(half_space("left", {.normal = {1, 0}, .offset = -0.5}, of));
  const int count = draw.whole(2, 5);
  double x = 0;
  for (int i = 0; i < count; ++i) {
    const double radius = draw.over_magnitudes(0.1, 0.4);
    x += radius + draw.between(0.05, 0.5);
    Surface own = of;
    own.density = draw.over_magnitudes(0.2, 20);
    Body one = disc(fmt::format("disc {}", i + 1), {x, 0}, radius, own);
    one.velocity = {draw.between(-3, 3), 0};
    scene.bodies.push_back(one);
    x += radius;
  }
  if (walls) scene.bodies.push_back(half_space("right", {.normal = {-1, 0}, .offset = -x - 0.5}, of));
  return scene;
}

// A box or a disc on the ground, or a disc above it, at rest or not; gravity may be tilted.
Scene on_ground(Draw& draw) {
  Scene scene{.gravity = draw.gravity(), .duration = draw.between(0.5, 2)};
  const Surface of = draw.surface();
  scene.bodies.push_back(level_ground(of));
  const double size = draw.over_magnitudes(0.1, 1);
  const bool round = draw.chance(0.5);
  const double height = round && draw.chance(0.5) ? draw.between(0, 1) : 0;
  const Vec sides{2 * size * (draw.chance(0.5) ? 1 : draw.between(0.1, 1)), 2 * size};
  Body body = round ? disc("body", {0, size + height}, size, of) : box("body", {0, size}, sides, of);
  if (draw.chance(0.5)) body.velocity = {draw.between(-4, 4), 0};
  if (round && height == 0 && draw.chance(0.5)) body.angular_velocity = draw.between(-6, 6);
  scene.bodies.push_back(body);
  return scene;
}

Scene beam(Draw& draw) {
  Scene scene{.duration = draw.between(0.5, 1.5)};
  const Surface of = draw.surface();
  const double radius = draw.between(0.1, 0.3);
  const double half = draw.between(0.5, 2);
  const double thickness = draw.between(0.1, 0.4);
  scene.bodies.push_back(fixed(disc("left", {-draw.between(0.2, 0.9) * half, -radius}, radius, of)));
  scene.bodies.push_back(fixed(disc("right", {draw.between(0.2, 0.9) * half, -radius}, radius, of)));
  scene.bodies.push_back(box("beam", {0, thickness / 2}, {2 * half, thickness}, of));
  return scene;
}

Scene scene(Draw& draw) {
  constexpr std::array motions{orbit, pendulum, oscillator, row, on_ground, on_ground, beam};
  return draw.one_of(motions)(draw);
}

const Catalog<Kind>::Entry entry{{.name = "textbook", .about = "A motion that textbooks solve.", .scene = scene}};

}  // namespace
}  // namespace plumb::kinds::textbook
