#include "scenarios/stacks/pyramid.h"

#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"

namespace plumb {

std::vector<Body> pyramid_of(const std::string& prefix, int base, double x, Surface of) {
  constexpr double pitch = 1.25;  // m, from box to box
  std::vector<Body> boxes;
  for (int row = 1; row <= base; ++row) {
    const int width = base - row + 1;
    for (int place = 1; place <= width; ++place) {
      const Vec center{x + (place - (width + 1) / 2.0) * pitch, row - 0.5};
      boxes.push_back(box(prefix + std::to_string(row) + "." + std::to_string(place), center, {1, 1}, of));
    }
  }
  return boxes;
}

// Every box bears on two below it, outside the middle on both sides, and is loaded the same way: all resultants lie
// between the bearings, and nothing moves. As in a tower, box by box up to row k: k gaps in height, and a lean of
// 2 gap/size each, which carries the apex k (k+1) gap to the side.
std::vector<Expectation> pyramid_stands(const std::vector<Body>& pyramid, double duration) {
  std::vector<Expectation> all;
  for (const Body& one : pyramid) {
    const double row = one.position.y + 0.5;
    const double reach = std::abs(one.position.x) + row;
    all.push_back({.body = one.name,
                   .quantity = Quantity::y,
                   .expected = one.position.y,
                   .allowed = [=](const Stepping& s) { return row * s.gap + round_off(s, duration, reach); },
                   .source = "equilibrium: stays where it is, within one gap a contact below"});
  }
  const Body& apex = pyramid.back();
  const double row = apex.position.y + 0.5;
  all.push_back({.body = apex.name,
                 .quantity = Quantity::x,
                 .expected = apex.position.x,
                 .allowed =
                     [=, reach = std::abs(apex.position.x) + row](const Stepping& s) {
                       return row * (row + 1) * s.gap + row * s.creep * duration + round_off(s, duration, reach);
                     },
                 .source = "equilibrium: no lean but what one gap a contact and the creep make"});
  return all;
}

namespace {

constexpr double friction = 0.5;

int base_of(const Parameters& p) { return static_cast<int>(p.at("base")); }

Scene scene(const Parameters& p) {
  const Surface wood = surface(friction, 0);
  Scene scene{.name = "pyramid", .about = "Boxes in rows, each on two of the row below.", .duration = p.at("duration")};
  scene.bodies = pyramid_of("box ", base_of(p), 0, wood);
  scene.bodies.insert(scene.bodies.begin(), level_ground(wood));
  return scene;
}

std::vector<Expectation> expectations(const Parameters& p) {
  return pyramid_stands(pyramid_of("box ", base_of(p), 0, surface(friction, 0)), p.at("duration"));
}

const Catalog<Scenario>::Entry entry{
    {.name = "pyramid",
     .question = "Does a pyramid of boxes stand?",
     .parameters =
         {{.name = "base", .value = 10, .min = 1, .max = 100, .about = "boxes in the lowest row", .whole = true},
          {.name = "duration", .value = 3, .min = 0.1, .max = 100, .unit = "s", .about = "how long it must stand"}},
     .variants = {{"five", {{"base", 5}}}, {"ten", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb
