#include <algorithm>
#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::thin_wall {
namespace {

constexpr double duration = 0.5;    // s
constexpr double radius = 0.1;      // m
constexpr double thickness = 0.02;  // m
constexpr double distance = 3.03;   // m to the wall

Scene scene(const Parameters& p) {
  Scene scene{.name = "thin-wall", .about = "A bullet flies at a thin wall.", .gravity = {0, 0}, .duration = duration};
  Body bullet = disc("bullet", {-distance - radius, 0}, radius, surface(0, 0));
  bullet.bullet = true;
  bullet.velocity = {p.at("speed"), 0};
  Body wall = box("wall", {thickness / 2, 0}, {thickness, 4}, surface(0, 0));
  wall.type = BodyType::fixed;
  scene.bodies = {bullet, wall};
  return scene;
}

// e = 0: it stops at the wall. An impact noticed late leaves it that deep in, but never so deep that its centre has
// passed the middle of the wall: from there nothing can know which way is out.
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  const auto place = [=](const Stepping& s) {
    const double late = v * lag(s) + s.gap + round_off(s, duration, distance + v * duration);
    return std::min(late, radius + thickness / 2);
  };
  const auto speed = [=](const Stepping& s) { return round_off(s, duration, v) + s.creep; };
  return {
      {.body = "bullet", .quantity = Quantity::x, .allowed = place, .source = "stops at the wall, and never behind it"},
      {.body = "bullet", .quantity = Quantity::vx, .allowed = speed, .source = "e = 0: none is left"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "thin-wall",
     .question = "Does a fast body stop at a wall thinner than its way in a step?",
     .parameters = {{.name = "speed", .value = 100, .min = 10, .max = 1000, .unit = "m/s", .about = "of the bullet"}},
     .variants = {{"slow", {{"speed", 10}}}, {"fast", {}}},
     .closed_form = "line",
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::thin_wall
