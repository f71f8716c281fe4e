// 2000 discs without friction, of any size, fall into a box: nothing turns, and every contact has one row.

#include "../course.h"
#include "scenarios/parts.h"
#include "scenarios/random.h"

namespace plumb::benchmarks {
namespace {

constexpr int columns = 54;
constexpr double pitch = 1;  // m: room for the largest
constexpr double wall = 28;  // m, from the middle

Start smooth_discs() {
  const Surface ice = surface(0, 0);
  Start start{.size = 0.5, .center = {0, 25}, .reach = 60};
  std::vector<Body>& bodies = start.scene.bodies;
  bodies.push_back(fixed(box("floor", {0, -1}, {2 * wall + 4, 2}, ice)));
  for (const double side : {-1, 1}) bodies.push_back(fixed(box("wall", {side * (wall + 1), 50}, {2, 100}, ice)));
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vec at{(i % columns - (columns - 1) / 2.0) * pitch, 1 + i / columns * pitch};
    Body drop = disc("disc", at, random.between(0.25, 0.45), ice);
    drop.velocity = {random.between(-1, 1), random.between(-1, 0)};
    bodies.push_back(drop);
  }
  return start;
}

const Catalog<Course>::Entry entry{{.name = "smooth-discs",
                                    .about = "2000 discs without friction fall into a box and settle",
                                    .settled = {900, 1100},
                                    .moving = {60, 360},
                                    .start = smooth_discs}};

}  // namespace
}  // namespace plumb::benchmarks
