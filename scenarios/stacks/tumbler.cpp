#include <cmath>
#include <numbers>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::tumbler {
namespace {

constexpr double duration = 4;     // s
constexpr double pitch = 0.36;     // m, from item to item
constexpr double item = 0.3;       // m, across
constexpr double thickness = 0.3;  // m, of the drum's walls

int count(const Parameters& p, const char* name) { return static_cast<int>(p.at(name)); }

// Inner radius: what is in the drum, a square, stays clear of paddles a tenth of the radius long.
double radius(const Parameters& p) { return p.at("side") * pitch / std::numbers::sqrt2 / 0.85; }

// A regular polygon of walls, closed at its corners, and paddles that stand out from them.
Body drum(const Parameters& p) {
  const Surface steel = surface(0.4, 0);
  const double r = radius(p);
  const int walls = count(p, "walls");
  Body drum{.name = "drum", .type = BodyType::kinematic, .angular_velocity = p.at("turn")};
  const auto add = [&](double angle, double from, double width, double height) {
    const double middle = from + height / 2;
    const Box plank{{width, height}, {middle * std::sin(angle), -middle * std::cos(angle)}, angle};
    drum.shapes.push_back({.geometry = plank, .surface = steel});
  };
  const double half = std::numbers::pi / walls;
  for (int i = 0; i < walls; ++i) add(2 * half * i, r, 2 * (r + thickness) * std::tan(half), thickness);
  const int paddles = count(p, "paddles");
  for (int i = 0; i < paddles; ++i) add(2 * std::numbers::pi * i / paddles, 0.9 * r, 0.1, 0.1 * r);
  return drum;
}

Scene scene(const Parameters& p) {
  Scene scene{.name = "tumbler", .about = "Boxes or discs in a drum that is turned.", .duration = duration};
  scene.bodies.push_back(drum(p));
  const int side = count(p, "side");
  const double middle = (side - 1) / 2.0;
  for (int i = 0; i < side * side; ++i) {
    const int row = i / side;
    const int column = i % side;
    const Vec place{(column - middle) * pitch, (row - middle) * pitch};
    const std::string name = "item " + std::to_string(i + 1);
    const Surface wood = surface(0.4, 0.1);
    scene.bodies.push_back(p.at("discs") == 1 ? disc(name, place, item / 2, wood)
                                              : box(name, place, {item, item}, wood));
  }
  return scene;
}

// The drum turns as it is told; whatever it holds stays within the circle about its walls' inner corners.
std::vector<Expectation> expectations(const Parameters& p) {
  const double turned = p.at("turn") * duration;
  std::vector<Expectation> all{{.body = "drum",
                                .quantity = Quantity::angle,
                                .expected = turned,
                                .allowed = [=](const Stepping& s) { return round_off(s, duration, turned); },
                                .source = "turned at a given rate"}};
  const double corner = radius(p) / std::cos(std::numbers::pi / p.at("walls"));
  for (int i = 1; i <= count(p, "side") * count(p, "side"); ++i) {
    for (const Quantity along : {Quantity::x, Quantity::y}) {
      all.push_back({.body = "item " + std::to_string(i),
                     .quantity = along,
                     .expected = 0,
                     .allowed = [=](const Stepping&) { return corner; },
                     .source = "stays inside the drum"});
    }
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "tumbler",
     .question = "Does a turning drum keep what is in it?",
     .parameters =
         {{.name = "walls", .value = 4, .min = 3, .max = 64, .about = "of the drum", .whole = true},
          {.name = "paddles", .value = 0, .min = 0, .max = 16, .about = "that stand out from the walls", .whole = true},
          {.name = "side", .value = 5, .min = 2, .max = 40, .about = "its square are the items inside", .whole = true},
          {.name = "discs", .value = 0, .min = 0, .max = 1, .about = "1: discs, 0: boxes", .whole = true},
          {.name = "turn", .value = 0.8, .min = 0.1, .max = 3, .unit = "rad/s", .about = "of the drum"}},
     .variants = {{"boxes", {}}, {"washer", {{"walls", 16}, {"paddles", 4}, {"discs", 1}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::tumbler
