#include <string>
#include <vector>

#include "scenarios/parts.h"
#include "scenarios/scenario.h"

// A wall of so many boxes that an engine may have another path for them; and they move.
namespace plumb::scenarios::struck_wall {
namespace {

constexpr double duration = 2;  // s
constexpr double size = 0.5;    // m, of a box

// Every other row of the wall is a quarter of a box to the side. With half a box, as bricks have it, the last
// box of such a row would balance on the edge of the one below.
Scene scene(const Parameters& p) {
  const Surface brick = surface(0.5, 0);
  const int rows = static_cast<int>(p.at("rows"));
  const int columns = static_cast<int>(p.at("columns"));
  Scene scene{.name = "struck-wall", .about = "A heavy disc knocks down a wall of boxes.", .duration = duration};
  scene.bodies.push_back(level_ground(brick));
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double x = (column + (row % 2) / 4.0) * size;
      scene.bodies.push_back(box(std::to_string(row + 1) + "." + std::to_string(column + 1), {x, (row + 0.5) * size},
                                 {size, size}, brick));
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
                    {.name = "speed", .value = 6, .min = 0.1, .max = 50, .unit = "m/s", .about = "of the ball"}},
     .variants = {{"80 boxes", {}}, {"64 boxes", {{"rows", 8}, {"speed", 2}}}},
     .scene = scene,
     .expectations = [](const Parameters&) { return std::vector<Expectation>{}; }}};

}  // namespace
}  // namespace plumb::scenarios::struck_wall
