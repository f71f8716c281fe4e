// 4000 small discs and boxes come down on hills of 2000 segments: two sizes, the larger one many and at rest.

#include <cmath>

#include "../course.h"
#include "scenarios/parts.h"
#include "scenarios/random.h"

namespace plumb::benchmarks {
namespace {

constexpr int segments = 2000;
constexpr int columns = 3600;
constexpr double half = segments / 2.0;  // m; each segment is 1 m across

double height(double x) { return 1.5 * std::sin(0.13 * x) + 0.8 * std::sin(0.41 * x + 1); }

Start terrain() {
  const Surface rock = surface(0.5, 0);
  Start start{.size = 0.2, .reach = half + 20};
  Body hills{.name = "hills", .type = BodyType::fixed};
  for (int i = 0; i < segments; ++i) {
    const double x = i - half;
    hills.shapes.push_back({.geometry = Segment{{x, height(x)}, {x + 1, height(x + 1)}}, .surface = rock});
  }
  start.scene.bodies.push_back(hills);
  Random random(1);
  for (int i = 0; i < 4000; ++i) {
    const double across = random.between(0.2, 0.3);
    const Vec at{(i % columns + 0.5 - columns / 2.0) * 0.5, 3 + 0.5 * (i / columns)};
    Body stone = i % 2 == 0 ? disc("disc", at, across / 2, rock) : box("box", at, {across, across}, rock);
    stone.angle = random.between(-1, 1);
    stone.velocity = {random.between(-2, 2), random.between(-1, 0)};
    start.scene.bodies.push_back(stone);
  }
  return start;
}

const Catalog<Course>::Entry entry{{.name = "terrain",
                                    .about = "4000 small discs and boxes come down on hills of 2000 segments",
                                    .settled = {},
                                    .moving = {60, 260},
                                    .start = terrain}};

}  // namespace
}  // namespace plumb::benchmarks
