// Balls and boxes that go on bouncing in a pen, without friction: what impacts cost.

#include "../course.h"
#include "scenarios/parts.h"
#include "scenarios/random.h"

namespace plumb::benchmarks {
namespace {

constexpr int columns = 24;
constexpr double pitch = 1;  // m: room for a box at any angle

Start bouncing() {
  const Surface rubber = surface(0, 0.8);
  Start start{.size = 0.7, .center = {0, 50}, .reach = 60};
  std::vector<Body>& bodies = start.scene.bodies;
  bodies.push_back(fixed(box("floor", {0, -1}, {40, 2}, rubber)));
  for (const double side : {-1, 1}) bodies.push_back(fixed(box("wall", {side * 13, 50}, {2, 100}, rubber)));
  Random random(2);
  for (int i = 0; i < 600; ++i) {
    const Vec at{(i % columns - (columns - 1) / 2.0) * pitch, 1 + i / columns * pitch};
    Body one = i % 2 == 0 ? disc("disc", at, 0.4, rubber) : box("box", at, {0.7, 0.7}, rubber);
    one.angle = random.between(-1, 1);
    one.velocity = {random.between(-5, 5), random.between(-5, 5)};
    bodies.push_back(one);
  }
  return start;
}

const Catalog<Course>::Entry entry{{.name = "bouncing",
                                    .about = "600 discs and boxes of e = 0.8 in a pen",
                                    .settled = {},
                                    .moving = {0, 600},
                                    .start = bouncing}};

}  // namespace
}  // namespace plumb::benchmarks
