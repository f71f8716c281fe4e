// Box2D 3's benchmark "large_pyramid": neighbours touch, so that a base of 100 makes 14 950 contacts of two points.

#include "pyramid.h"

#include "scenarios/parts.h"

namespace plumb::benchmarks {

void add_pyramid(Start& start, int base, Vec middle) {
  std::vector<Body>& bodies = start.scene.bodies;
  for (int row = 0; row < base; ++row) {
    const int width = base - row;
    for (int i = 0; i < width; ++i) {
      const std::size_t here = bodies.size();
      bodies.push_back(box("", {middle.x + i - (width - 1) / 2.0, middle.y + row + 0.5}, {1, 1}, surface(0.6, 0)));
      if (row == 0) continue;
      const std::size_t below = here - static_cast<std::size_t>(width) - 1;
      start.rests.push_back({here, below});
      start.rests.push_back({here, below + 1});
    }
  }
}

namespace {

Start pyramid(int base) {
  Start start{.size = 1};
  start.scene.bodies.push_back(fixed(box("ground", {0, -1}, {200, 2}, surface(0.6, 0))));
  add_pyramid(start, base, {0, 0});
  return start;
}

const Catalog<Course>::Entry large{
    {.name = "pyramid-100", .about = "5050 boxes in 100 rows", .settled = {200, 300}, .moving = {0, 60}, .start = [] {
       return pyramid(100);
     }}};

const Catalog<Course>::Entry small{
    {.name = "pyramid-20", .about = "210 boxes in 20 rows", .settled = {200, 800}, .moving = {0, 60}, .start = [] {
       return pyramid(20);
     }}};

}  // namespace
}  // namespace plumb::benchmarks
