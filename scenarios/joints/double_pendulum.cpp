#include <cmath>

#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::double_pendulum {
namespace {

constexpr double length = 1;   // m, of either rod
constexpr double thick = 0.1;  // m

// Both rods in one line, by `angle` from the vertical, at rest.
Scene scene(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  const Vec along{std::sin(angle), -std::cos(angle)};
  Scene scene{.name = "double-pendulum", .about = "A rod hung on a rod.", .duration = p.at("duration")};
  scene.bodies.push_back({.name = "pivot", .type = BodyType::fixed, .layers = 0});
  for (int i = 1; i <= 2; ++i) {
    const double way = (i - 0.5) * length;
    Body rod = box(i == 1 ? "upper" : "lower", {way * along.x, way * along.y}, {thick, length}, {});
    rod.angle = angle;
    rod.layers = 0;
    scene.bodies.push_back(rod);
  }
  scene.joints = {Revolute{.a = 0, .b = 1}, Revolute{.a = 1, .b = 2, .anchor = {length * along.x, length * along.y}}};
  return scene;
}

const Catalog<Scenario>::Entry entry{
    {.name = "double-pendulum",
     .question = "Does a double pendulum swing on without gaining energy?",
     .parameters =
         {{.name = "angle", .value = 120, .min = 1, .max = 179, .unit = "deg", .about = "at the start"},
          {.name = "duration", .value = 5, .min = 0.1, .max = 100, .unit = "s", .about = "how long it swings"}},
     .variants = {{"small", {{"angle", 5}}}, {"wild", {}}},
     .scene = scene,
     .expectations = [](const Parameters&) { return std::vector<Expectation>{}; }}};

}  // namespace
}  // namespace plumb::scenarios::double_pendulum
