// Scenes of a few bodies at rest: what a step costs before any body does.

#include "../course.h"
#include "scenarios/parts.h"

namespace plumb::benchmarks {
namespace {

Start on_the_ground(std::vector<Body> bodies) {
  Start start{.size = 1, .reach = 10};
  start.scene.bodies = std::move(bodies);
  start.scene.bodies.push_back(fixed(box("ground", {0, -1}, {40, 2}, surface(0.6, 0))));
  return start;
}

Start one_box() { return on_the_ground({box("box", {0, 0.5}, {1, 1}, surface(0.6, 0))}); }

Start three_bodies() {
  return on_the_ground({box("box", {0, 0.5}, {1, 1}, surface(0.6, 0)), disc("disc", {3, 0.5}, 0.5, surface(0.6, 0))});
}

const Catalog<Course>::Entry one{{.name = "one-box",
                                  .about = "a box that rests on the ground",
                                  .settled = {200, 10200},
                                  .moving = {},
                                  .start = one_box}};

const Catalog<Course>::Entry three{{.name = "three-bodies",
                                    .about = "a box and a disc that rest on the ground",
                                    .settled = {200, 10200},
                                    .moving = {},
                                    .start = three_bodies}};

}  // namespace
}  // namespace plumb::benchmarks
