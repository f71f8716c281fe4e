#include <fmt/format.h>

#include <algorithm>

#include "reports/find/kind.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"
#include "scenarios/scene/vec.h"

// Kinematic bodies that carry others.
namespace plumb::kinds::driven {
namespace {

void add_all(const Scene& from, Scene& to) {
  to.bodies.insert(to.bodies.end(), from.bodies.begin(), from.bodies.end());
}

// A slab moves under bodies, to a wall or up and down like a lift. It may shake as well.
Scene belt(Draw& draw) {
  Scene scene{.duration = draw.between(0.5, 1.5)};
  const Surface of = draw.surface();
  Body belt = box("belt", {0, -0.25}, {40, 0.5}, of);
  belt.type = BodyType::kinematic;
  belt.velocity = draw.chance(0.75) ? Vec{draw.between(-4, 4), 0} : Vec{0, draw.between(-1.5, 1.5)};
  Scene on_belt;  // of its own: the belt is below, its bounding circle is not
  if (belt.velocity.y == 0 && draw.chance(0.4)) {
    const double side = belt.velocity.x < 0 ? -1 : 1;
    on_belt.bodies.push_back(fixed(box("wall", {side * 3, 1.02}, {0.5, 2}, of)));
  }
  scatter(on_belt, draw.count(1, 10), [&](std::string name) {
    const double size = draw.over_magnitudes(0.1, 0.5);
    const Vec at{draw.between(-2, 2), 0};
    Body body = draw.chance(0.5) ? box(std::move(name), at, {2 * size, 2 * size}, draw.surface())
                                 : disc(std::move(name), at, size, draw.surface());
    body.position.y = size + (draw.chance(0.6) ? 0 : draw.between(0.01, 0.5));
    return body;
  });
  if (draw.chance(0.25)) belt.path = draw.path();
  // A belt that sinks would take bodies under the wall, and crush them there.
  const bool lifts = belt.path && belt.path->amplitude.y != 0;
  if (lifts) std::erase_if(on_belt.bodies, [](const Body& body) { return body.type == BodyType::fixed; });
  scene.bodies.push_back(belt);
  add_all(on_belt, scene);
  return scene;
}

// Four walls about the origin, one kinematic body.
Body walls(std::string name, double half, const Surface& of) {
  constexpr double thick = 0.4;
  Body made{.name = std::move(name), .type = BodyType::kinematic};
  for (const Vec side : {Vec{1, 0}, Vec{-1, 0}, Vec{0, 1}, Vec{0, -1}}) {
    const Vec size = side.x != 0 ? Vec{thick, 2 * half} : Vec{2 * half + 2 * thick, thick};
    made.shapes.push_back({.geometry = Box{.size = size, .center = (half + thick / 2) * side}, .surface = of});
  }
  return made;
}

// Alike boxes in as many rows as columns about the origin.
void add_rows(int rows, double apart, double side, const Surface& of, Scene& into) {
  for (int i = 0; i < rows * rows; ++i) {
    const int row = i / rows;
    const Vec at{(i % rows - (rows - 1) / 2.0) * apart, (row - (rows - 1) / 2.0) * apart};
    into.bodies.push_back(box(fmt::format("body {}", i + 1), at, {side, side}, of));
  }
}

Scene drum(Draw& draw) {
  Scene scene{.gravity = draw.gravity(), .duration = draw.between(0.5, 1.5)};
  const Surface of = draw.surface();
  const double half = draw.between(0.8, 2);
  scene.bodies.push_back(walls("drum", half, of));
  scene.bodies.back().angular_velocity = draw.between(-3, 3);
  if (draw.chance(0.25)) {
    const Surface boxes = draw.surface();
    const double side = draw.between(0.15, 0.35);
    const double apart = side + draw.between(0.005, 0.08);
    add_rows(std::min(draw.whole(2, 6), static_cast<int>(2 * half / apart) - 1), apart, side, boxes, scene);
    return scene;
  }
  Scene inside;  // of its own, as the bounding circle of the walls is around it
  scatter(inside, draw.count(1, 25), [&](std::string name) {
    const double size = draw.over_magnitudes(0.08, 0.3);
    Body body = draw.body(std::move(name), draw.within(half - size - 0.02, half - size - 0.02), size);
    body.velocity = draw.within(1, 1);
    return body;
  });
  add_all(inside, scene);
  return scene;
}

// A mistake in a game's level: a body far too large lies across rows of others, within walls that turn or stand.
Scene overlapping(Draw& draw) {
  Scene scene{.duration = draw.between(0.3, 1)};
  const Surface of = draw.surface();
  const double half = draw.between(0.8, 2);
  scene.bodies.push_back(walls("walls", half, of));
  if (draw.chance(0.7)) scene.bodies.back().angular_velocity = draw.between(-3, 3);
  const int rows = draw.whole(1, 5);
  const double apart = 2 * half / (rows + 1);
  const double side = apart * draw.between(0.5, 0.95);
  add_rows(rows, apart, side, of, scene);
  Body& large = scene.bodies[static_cast<std::size_t>(draw.whole(1, rows * rows))];
  const double factor = draw.over_magnitudes(2, 1000);
  large.shapes[0].geometry = Box{.size = {draw.chance(0.3) ? factor * side : side, factor * side}};
  return scene;
}

const Catalog<Kind>::Entry of_belt{
    {.name = "belt", .about = "A slab moves under bodies, sideways, like a lift, or shaking.", .scene = belt}};
const Catalog<Kind>::Entry of_drum{{.name = "drum", .about = "A turning drum carries bodies.", .scene = drum}};
const Catalog<Kind>::Entry of_overlapping{{.name = "overlapping",
                                           .about = "A body far too large lies across others.",
                                           .posed = Posed::overlapping,
                                           .scene = overlapping}};

}  // namespace
}  // namespace plumb::kinds::driven
