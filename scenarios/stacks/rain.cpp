#include <numbers>

#include "scenarios/parts.h"
#include "scenarios/random.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::rain {
namespace {

constexpr double cell = 1.2;  // m: room for the largest body at any angle
constexpr int columns = 8;

// Boxes and discs by turns, of any size and angle, each somewhere in a cell of its own.
Scene scene(const Parameters& p) {
  Random random(static_cast<std::uint64_t>(p.at("seed")));
  Scene scene{.name = "rain", .about = "Boxes and discs rain into a pit.", .duration = 4};
  scene.bodies.push_back(pit(columns * cell, surface(0.5, 0.2)));
  for (int i = 0; i < static_cast<int>(p.at("count")); ++i) {
    const double across = random.between(0.4, 0.7);
    const double play = (cell - across * std::numbers::sqrt2) / 2;
    const int row = i / columns;
    const int column = i % columns;
    const Vec at{(column - (columns - 1) / 2.0) * cell + random.between(-play, play),
                 (row + 1) * cell + random.between(-play, play)};
    const std::string name = (i % 2 == 0 ? "box " : "disc ") + std::to_string(i + 1);
    Body drop =
        i % 2 == 0 ? box(name, at, {across, across}, surface(0.5, 0.2)) : disc(name, at, across / 2, surface(0.5, 0.2));
    drop.angle = random.between(0, std::numbers::pi / 2);
    scene.bodies.push_back(drop);
  }
  return scene;
}

const Catalog<Scenario>::Entry entry{
    {.name = "rain",
     .question = "Does a rain of boxes and discs come to rest without losing any in its heap?",
     .parameters = {{.name = "count", .value = 48, .min = 1, .max = 10000, .about = "of bodies", .whole = true},
                    {.name = "seed", .value = 1, .min = 0, .max = 1e6, .about = "of the arrangement", .whole = true}},
     .variants = {{"seed 1", {}}, {"seed 2", {{"seed", 2}}}},
     .scene = scene,
     .expectations = [](const Parameters&) { return std::vector<Expectation>{}; }}};

}  // namespace
}  // namespace plumb::scenarios::rain
