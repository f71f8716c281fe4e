// Bodies that fall and spin and never meet: what a body costs.

#include "../course.h"
#include "scenarios/parts.h"

namespace plumb::benchmarks {
namespace {

Start free_bodies() {
  Start start{.size = 1};
  for (int i = 0; i < 10000; ++i) {
    Body body = box("box", {3.0 * (i % 100), 3.0 * (i / 100)}, {1, 1}, surface(0.6, 0));
    body.angular_velocity = 0.1 * (i % 7);
    start.scene.bodies.push_back(body);
  }
  return start;
}

const Catalog<Course>::Entry entry{{.name = "free-10000",
                                    .about = "10 000 boxes that fall and never meet",
                                    .settled = {},
                                    .moving = {10, 210},
                                    .start = free_bodies}};

}  // namespace
}  // namespace plumb::benchmarks
