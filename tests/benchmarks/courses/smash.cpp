// Box2D 3's benchmark "smash": without gravity, a heavy box flies into a wall of small ones. There the wall sleeps
// until it is hit; here nothing sleeps.

#include "../course.h"
#include "scenarios/parts.h"

namespace plumb::benchmarks {
namespace {

constexpr double across = 0.4;  // m, of a small box, and from one to the next

Start smash() {
  Start start{.size = across};
  start.scene.gravity = {0, 0};
  Body big = box("big", {-20, 0}, {8, 8}, surface(0.6, 0, 8));
  big.velocity = {40, 0};
  start.scene.bodies.push_back(big);
  for (int column = 0; column < 120; ++column) {
    for (int row = 0; row < 80; ++row) {
      const Vec at{30 + column * across, (row - 40) * across};
      start.scene.bodies.push_back(box("small", at, {across, across}, surface(0.6, 0)));
    }
  }
  return start;
}

// It is hit in the 69th step.
const Catalog<Course>::Entry entry{{.name = "smash",
                                    .about = "9600 boxes at rest are hit by a heavy one",
                                    .settled = {},
                                    .moving = {60, 300},
                                    .start = smash}};

}  // namespace
}  // namespace plumb::benchmarks
