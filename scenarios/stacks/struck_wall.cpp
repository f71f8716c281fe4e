#include <string>
#include <vector>

#include "scenarios/parts.h"
#include "scenarios/scenario.h"

// A wall of so many boxes that an engine may have another path for them; and they move.
namespace plumb::scenarios::struck_wall {
namespace {

constexpr double duration = 2;  // s
constexpr double size = 0.5;    // m, of a box

// Whole, or of two parts that lie beside each other, a third and two thirds of it: the same motion.
Body brick(const std::string& name, Vec at, bool in_parts, const Surface& of) {
  Body made = box(name, at, {size, size}, of);
  if (in_parts) {
    made.shapes = {{.geometry = Box{.size = {size / 3, size}, .center = {-size / 3, 0}}, .surface = of},
                   {.geometry = Box{.size = {2 * size / 3, size}, .center = {size / 6, 0}}, .surface = of}};
  }
  return made;
}

// Every other row of the wall is a quarter of a box to the side. With half a box, as bricks have it, the last
// box of such a row would balance on the edge of the one below.
Scene scene(const Parameters& p) {
  const Surface rough = surface(0.5, 0);
  const int rows = static_cast<int>(p.at("rows"));
  const int columns = static_cast<int>(p.at("columns"));
  Scene scene{.name = "struck-wall", .about = "A heavy disc knocks down a wall of boxes.", .duration = duration};
  scene.bodies.push_back(level_ground(rough));
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double x = (column + (row % 2) / 4.0) * size;
      const std::string name = std::to_string(row + 1) + "." + std::to_string(column + 1);
      scene.bodies.push_back(brick(name, {x, (row + 0.5) * size}, p.at("parts") > 1, rough));
    }
  }
  Body ball = disc("ball", {-2.5, rows * size / 2}, 1, surface(0.5, 0, p.at("ratio")));
  ball.velocity = {p.at("speed"), 0};
  scene.bodies.push_back(ball);
  return scene;
}

const Catalog<Scenario>::Entry entry{
    {.name = "struck-wall",
     .question = "Does a wall that is knocked down obey the laws of contact throughout?",
     .parameters = {{.name = "rows", .value = 10, .min = 4, .max = 40, .about = "of the wall", .whole = true},
                    {.name = "columns", .value = 8, .min = 1, .max = 40, .about = "of the wall", .whole = true},
                    {.name = "ratio",
                     .value = 4,
                     .min = 0.1,
                     .max = 100,
                     .about = "density of the ball divided by that of the boxes"},
                    {.name = "speed", .value = 6, .min = 0.1, .max = 50, .unit = "m/s", .about = "of the ball"},
                    {.name = "parts", .value = 1, .min = 1, .max = 2, .about = "of each box", .whole = true}},
     .variants = {{"80 boxes", {}},
                  {"64 boxes", {{"rows", 8}, {"speed", 2}}},
                  {"15 in parts", {{"rows", 5}, {"columns", 3}, {"parts", 2}}}},
     .scene = scene,
     .expectations = [](const Parameters&) { return std::vector<Expectation>{}; }}};

}  // namespace
}  // namespace plumb::scenarios::struck_wall
