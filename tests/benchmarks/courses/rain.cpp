// 1000 discs and 1000 boxes of any size and angle fall into a box, as Plumb's own first measurements had them (Box2D's
// benchmark of that name is of ragdolls).

#include "../course.h"
#include "scenarios/parts.h"
#include "scenarios/random.h"

namespace plumb::benchmarks {
namespace {

constexpr int columns = 54;
constexpr double pitch = 1;  // m: room for the largest body at any angle
constexpr double wall = 28;  // m, from the middle

Start rain() {
  const Surface wood = surface(0.6, 0);
  Start start{.size = 0.5, .center = {0, 25}, .reach = 60};
  std::vector<Body>& bodies = start.scene.bodies;
  bodies.push_back(fixed(box("floor", {0, -1}, {2 * wall + 4, 2}, wood)));
  for (const double side : {-1, 1}) bodies.push_back(fixed(box("wall", {side * (wall + 1), 50}, {2, 100}, wood)));
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const double across = random.between(0.5, 0.7);
    const Vec at{(i % columns - (columns - 1) / 2.0) * pitch, 1 + i / columns * pitch};
    Body drop = i % 2 == 0 ? disc("disc", at, across / 2, wood) : box("box", at, {across, across}, wood);
    drop.angle = random.between(-1, 1);
    drop.velocity = {random.between(-1, 1), random.between(-1, 0)};
    bodies.push_back(drop);
  }
  return start;
}

const Catalog<Course>::Entry entry{{.name = "rain",
                                    .about = "1000 discs and 1000 boxes fall into a box and settle",
                                    .settled = {900, 1100},
                                    .moving = {60, 360},
                                    .start = rain}};

}  // namespace
}  // namespace plumb::benchmarks
