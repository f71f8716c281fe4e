// Box2D 3's benchmarks "large_pyramid" and "many_pyramids". Boxes touch their neighbours, so a base of 100 makes 14 950
// contacts of two points.

#include "../benchmark_scene.h"
#include "scenarios/parts.h"

namespace plumb::benchmarks::pyramids {
namespace {

SceneSetup one_pyramid(int base) {
  SceneSetup setup{.size = 1};
  setup.scene.bodies.push_back(fixed(box("ground", {0, -1}, {200, 2}, surface(0.6, 0))));
  add_pyramid(setup, base, {0, 0});
  return setup;
}

// 20 floors, one above the other, with 20 pyramids of ten rows on each.
SceneSetup many_pyramids() {
  constexpr int base = 10;
  constexpr int count = 20;           // of floors, and of pyramids on each
  constexpr double pitch = base + 1;  // m, from floor to floor, and from pyramid to pyramid
  SceneSetup setup{.size = 1};
  Body floors{.name = "floors", .type = BodyType::fixed};
  for (int floor = 0; floor < count; ++floor) {
    const double y = floor * pitch;
    const Segment line{{-count * pitch / 2, y}, {count * pitch / 2, y}};
    floors.shapes.push_back({.geometry = line, .surface = surface(0.6, 0)});
  }
  setup.scene.bodies.push_back(floors);
  for (int floor = 0; floor < count; ++floor) {
    for (int i = 0; i < count; ++i) add_pyramid(setup, base, {(i - (count - 1) / 2.0) * pitch, floor * pitch});
  }
  return setup;
}

const Catalog<BenchmarkScene>::Entry large{
    {.name = "pyramid-100", .about = "5050 boxes in 100 rows", .settled = {200, 300}, .moving = {0, 60}, .setup = [] {
       return one_pyramid(100);
     }}};

const Catalog<BenchmarkScene>::Entry small{
    {.name = "pyramid-20", .about = "210 boxes in 20 rows", .settled = {200, 800}, .moving = {0, 60}, .setup = [] {
       return one_pyramid(20);
     }}};

const Catalog<BenchmarkScene>::Entry many{{.name = "many-pyramids",
                                           .about = "22 000 boxes in 400 pyramids of ten rows",
                                           .settled = {100, 150},
                                           .moving = {},
                                           .setup = many_pyramids}};

}  // namespace
}  // namespace plumb::benchmarks::pyramids
