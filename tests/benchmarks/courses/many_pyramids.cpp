// Box2D 3's benchmark "many_pyramids": 20 floors, one above the other, with 20 pyramids of ten rows on each.

#include "pyramid.h"
#include "scenarios/parts.h"

namespace plumb::benchmarks {
namespace {

constexpr int base = 10;
constexpr int count = 20;           // of floors, and of pyramids on each
constexpr double pitch = base + 1;  // m, from floor to floor, and from pyramid to pyramid

Start many_pyramids() {
  Start start{.size = 1};
  Body floors{.name = "floors", .type = BodyType::fixed};
  for (int floor = 0; floor < count; ++floor) {
    const double y = floor * pitch;
    const Segment line{{-count * pitch / 2, y}, {count * pitch / 2, y}};
    floors.shapes.push_back({.geometry = line, .surface = surface(0.6, 0)});
  }
  start.scene.bodies.push_back(floors);
  for (int floor = 0; floor < count; ++floor) {
    for (int i = 0; i < count; ++i) add_pyramid(start, base, {(i - (count - 1) / 2.0) * pitch, floor * pitch});
  }
  return start;
}

const Catalog<Course>::Entry entry{{.name = "many-pyramids",
                                    .about = "22 000 boxes in 400 pyramids of ten rows",
                                    .settled = {100, 150},
                                    .moving = {},
                                    .start = many_pyramids}};

}  // namespace
}  // namespace plumb::benchmarks
