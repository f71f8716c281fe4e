#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::layers {
namespace {

constexpr double duration = 2;  // s, in which the two pass through each other
constexpr double gravity = 10;  // m/s^2
constexpr double start = 4;     // m from the middle

Scene scene(const Parameters& p) {
  const double v = p.at("speed");
  Scene scene{.name = "layers",
              .about = "Two boxes on layers of their own fly through each other.",
              .gravity = {0, -gravity},
              .duration = duration};
  for (const double side : {-1.0, 1.0}) {
    Body one = box(side < 0 ? "left" : "right", {side * start, 0}, {1, 1}, surface(0.5, 0.5));
    one.velocity = {-side * v, 0};
    one.angular_velocity = side;
    one.layers = side < 0 ? 1 : 2;
    scene.bodies.push_back(one);
  }
  return scene;
}

// Each falls freely: off by drift g t h and round-off.
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  const double fall = gravity * duration;
  const double reach = start + (v + fall) * duration;
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, reach); };
  const auto height = [=](const Stepping& s) { return drifted(s, gravity, duration) + exact(s); };
  std::vector<Expectation> all;
  for (const char* body : {"left", "right"}) {
    all.push_back({.body = body, .quantity = Quantity::x, .allowed = exact, .source = "v t, as if alone"});
    all.push_back(
        {.body = body, .quantity = Quantity::y, .allowed = height, .source = "g t^2/2, as if alone; drift g t h"});
    all.push_back({.body = body, .quantity = Quantity::angle, .allowed = exact, .source = "w t, as if alone"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "layers",
     .question = "Do bodies on layers that share nothing pass through each other untouched?",
     .parameters = {{.name = "speed", .value = 4, .min = 0.1, .max = 100, .unit = "m/s", .about = "of either"}},
     .variants = {{"cross", {}}},
     .closed_form = "ballistic",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::layers
