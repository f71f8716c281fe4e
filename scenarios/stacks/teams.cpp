#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/stacks/pyramid.h"

namespace plumb::scenarios::teams {
namespace {

constexpr double duration = 2;  // s

int base_of(const Parameters& p) { return static_cast<int>(p.at("base")); }

// From the middle, so that the two have just changed places in the end.
double start(const Parameters& p) { return p.at("speed") * duration / 2; }

// On ground without friction, each pile moves as one.
std::vector<Body> team(const Parameters& p, double side) {
  auto pile = pyramid_of(side < 0 ? "left " : "right ", base_of(p), side * start(p), surface(0.5, 0));
  for (Body& body : pile) {
    body.velocity = {-side * p.at("speed"), 0};
    body.layers = side < 0 ? 1 : 2;
  }
  return pile;
}

Scene scene(const Parameters& p) {
  Scene scene{.name = "teams",
              .about = "Two piles on layers of their own slide through each other on ice.",
              .duration = duration};
  scene.bodies.push_back(level_ground(surface(0, 0)));
  for (const double side : {-1.0, 1.0}) {
    const auto pile = team(p, side);
    scene.bodies.insert(scene.bodies.end(), pile.begin(), pile.end());
  }
  return scene;
}

// Seen by who slides along with it, a pile stands: where it stood and v t, within what a pyramid may settle, a gap in
// height and k (k+1) gap to the side up to row k; what gaps close sets speeds apart by no more than the creep.
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  std::vector<Expectation> all;
  for (const double side : {-1.0, 1.0}) {
    for (const Body& body : team(p, side)) {
      const double row = body.position.y + 0.5;
      const auto exact = [=, x = std::abs(body.position.x)](const Stepping& s) {
        return round_off(s, duration, x + row + v * duration);
      };
      all.push_back(
          {.body = body.name,
           .quantity = Quantity::x,
           .expected = body.position.x - side * v * duration,
           .allowed = [=](const Stepping& s) { return row * (row + 1) * s.gap + row * s.creep * duration + exact(s); },
           .source = "v t, as if the others were not there"});
      all.push_back({.body = body.name,
                     .quantity = Quantity::y,
                     .expected = body.position.y,
                     .allowed = [=](const Stepping& s) { return row * s.gap + exact(s); },
                     .source = "stays at its height: the others are not there, the ground is"});
    }
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "teams",
     .question = "Do two teams in layers of their own pass through each other and still stand on the same ground?",
     .parameters =
         {{.name = "base", .value = 3, .min = 1, .max = 20, .about = "boxes in a pile's lowest row", .whole = true},
          {.name = "speed", .value = 5, .min = 1, .max = 50, .unit = "m/s", .about = "of either"}},
     .variants = {{"piles", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::teams
